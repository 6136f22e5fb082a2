#include "app/view/view_input.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/view/tool.h"
#include "app/view/view.h"

namespace brume {
namespace {

// The right button asks for a menu if the mouse hardly moves meanwhile.
bool is_slip(QPointF way) {
  return way.manhattanLength() < MouseDrag::max_slip;
}

}  // namespace

ViewInput::ViewInput(View& view) : view_(view) {
  // Runs out when no events of the mouse wait any more.
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &ViewInput::flush_moves);
  connect(&fly_keys_, &FlyKeys::moved, this,
          [this](const glm::dvec3& way) { view_.camera_controller().fly(fly_speed_ * way); });
  connect(&fly_keys_, &FlyKeys::interrupted, this, [this] {
    drag_ = Drag::none;
    right_press_.reset();
  });
  connect(&tool_drag_, &MouseDrag::cancelled, this, &ViewInput::cancel);
  connect(&tool_drag_, &MouseDrag::ended, this, [this] {
    flush_moves();
    release_tool();
  });
}

void ViewInput::set_tool(Tool* tool) {
  flush_moves();
  if (tool_) {
    if (drag_ == Drag::tool) tool_->cancel();
    tool_->leave();
  }
  end_gesture();
  tool_ = tool;
}

// The last pressure stays for what the stroke still has to do when the pen is lifted.
void ViewInput::set_pen(bool is_down, double pressure) {
  pen_is_down_ = is_down;
  if (is_down) pressure_ = pressure;
}

// Qt on X11 merges moves that wait, as they do while a frame is drawn. Here each one counts;
// elsewhere only the newest, and what it changes may take long.
void ViewInput::enter() {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void ViewInput::press(const QMouseEvent& event) {
  if (drag_ != Drag::none) return;  // one gesture at a time
  right_press_.reset();
  flush_moves();
  if (!pen_is_down_) pressure_ = 1.0;
  if (tool_) tool_->set_view(view_);
  last_position_ = event.position();
  start_drag(event);
}

void ViewInput::start_drag(const QMouseEvent& event) {
  const bool left = event.button() == Qt::LeftButton;
  const NavigationPreset preset = view_.camera_controller().navigation();
  const bool tools_own = left && tool_ && tool_->uses_alt() &&
                         event.modifiers().testFlag(Qt::AltModifier) &&
                         preset != NavigationPreset::maya;
  const auto navigation = navigation_drag(preset, event.button(), event.modifiers());
  if (navigation && !tools_own) {
    drag_ = Drag::camera;
    camera_drag_ = *navigation;
    view_.camera_controller().set_pivot(view_.point_under(event.position()));
  } else if (event.button() == Qt::RightButton) {
    right_press_ = event.position();
    if (!view_.camera_controller().can_fly()) return;
    drag_ = Drag::flight;
    fly_keys_.press();
  } else if (left && tool_) {
    drag_ = Drag::tool;
    tool_drag_.press(event.position(), tool_->draws_strokes());
    tool_->set_pressure(pressure_);
    tool_->press(event.position(), event.modifiers());
  }
}

void ViewInput::move(QPointF position) {
  path_.push_back(position);
  if (!timer_.isActive()) timer_.start();
}

void ViewInput::flush_moves() {
  timer_.stop();
  if (path_.empty()) return;
  const std::vector<QPointF> path = std::exchange(path_, {});
  const QPointF step = path.back() - std::exchange(last_position_, path.back());
  switch (drag_) {
    case Drag::none:
      Q_EMIT pointed_at(path.back());
      if (tool_) {
        tool_->set_view(view_);
        tool_->hover(path.back());
      }
      break;
    case Drag::tool:
      if (!tool_drag_.has_begun(path.back())) break;
      tool_->set_pressure(pressure_);
      tool_->move(path);
      break;
    case Drag::camera:
      view_.camera_controller().drag(camera_drag_, step);
      break;
    case Drag::flight:
      if (right_press_ && is_slip(path.back() - *right_press_)) break;
      right_press_.reset();
      view_.camera_controller().look_around(step);
      break;
  }
}

void ViewInput::release(const QMouseEvent& event) {
  flush_moves();
  const Qt::MouseButtons held = event.buttons();
  if (!held.testFlag(Qt::LeftButton)) {
    last_position_ = event.position();
    release_tool();
    tool_drag_.release();
  }
  if (drag_ == Drag::camera && held == Qt::NoButton) drag_ = Drag::none;
  if (drag_ == Drag::flight && !held.testFlag(Qt::RightButton)) {
    drag_ = Drag::none;
    fly_keys_.release();
    if (fly_keys_.is_used()) right_press_.reset();
  }
  if (event.button() == Qt::RightButton && right_press_) {
    const QPointF pressed = *std::exchange(right_press_, std::nullopt);
    if (is_slip(event.position() - pressed)) Q_EMIT menu_asked(pressed);
  }
}

void ViewInput::turn_wheel(double angle) {
  flush_moves();  // they were meant for the view as it was
  if (drag_ == Drag::flight) {
    right_press_.reset();
    fly_speed_ = std::clamp(fly_speed_ * std::pow(1.001, angle), 1e-3, 1e3);
  } else {
    view_.camera_controller().zoom_by(std::pow(0.999, angle));
  }
}

void ViewInput::leave() {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, true);
  flush_moves();
  if (tool_ && &tool_->view() == &view_) tool_->leave();
}

void ViewInput::release_tool() {
  if (std::exchange(drag_, drag_ == Drag::tool ? Drag::none : drag_) == Drag::tool) {
    tool_->release(last_position_);
  }
}

void ViewInput::cancel() {
  path_.clear();
  drag_ = Drag::none;
  tool_->cancel();
}

void ViewInput::end_gesture() {
  path_.clear();
  tool_drag_.release();
  if (drag_ == Drag::tool) drag_ = Drag::none;
}

}  // namespace brume
