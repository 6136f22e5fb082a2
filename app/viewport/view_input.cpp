#include "app/viewport/view_input.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/viewport/tool.h"
#include "app/viewport/viewport.h"

namespace brume {

ViewInput::ViewInput(Viewport& view) : view_(view) {
  // Runs out when no events of the mouse wait any more.
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &ViewInput::flush_moves);
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

// Qt on X11 merges moves that wait, as they do while a frame is drawn. Here each one counts;
// elsewhere only the newest, and what it changes may take long.
void ViewInput::enter() {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void ViewInput::press(const QMouseEvent& event) {
  if (drag_ != Drag::none) return;  // one gesture at a time
  flush_moves();
  if (tool_) tool_->set_view(view_);
  last_position_ = event.position();
  drag_ = drag_of(event);
  if (drag_ == Drag::tool) tool_->press(event.position(), event.modifiers());
}

ViewInput::Drag ViewInput::drag_of(const QMouseEvent& event) const {
  const bool left = event.button() == Qt::LeftButton;
  const NavigationPreset preset = view_.navigation();
  const bool tools_own = left && tool_ && tool_->uses_alt() &&
                         event.modifiers().testFlag(Qt::AltModifier) &&
                         preset != NavigationPreset::maya;
  const auto drag = navigation_drag(preset, event.button(), event.modifiers());
  if (drag && !tools_own) {
    switch (*drag) {
      case NavigationDrag::orbit:
        return view_.projection() == Projection::perspective ? Drag::orbit : Drag::pan;
      case NavigationDrag::pan:
        return Drag::pan;
      case NavigationDrag::zoom:
        return Drag::zoom;
    }
  }
  return left && tool_ ? Drag::tool : Drag::none;
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
  const double half_turn = std::numbers::pi / std::max(1, view_.height());
  const Camera& camera = view_.camera();
  switch (drag_) {
    case Drag::none:
      Q_EMIT pointed_at(path.back());
      if (tool_) {
        tool_->set_view(view_);
        tool_->hover(path.back());
      }
      break;
    case Drag::tool:
      tool_->move(path);
      break;
    case Drag::orbit:
      view_.set_camera(orbit(camera, {step.x() * half_turn, step.y() * half_turn}));
      break;
    case Drag::pan:
      view_.set_camera(pan(camera, view_.film(), {step.x(), step.y()}));
      break;
    case Drag::zoom:
      view_.zoom_by(std::exp(0.005 * (step.y() - step.x())));
      break;
  }
}

void ViewInput::release(const QMouseEvent& event) {
  flush_moves();
  const Qt::MouseButtons held = event.buttons();
  if (drag_ == Drag::tool && !held.testFlag(Qt::LeftButton)) {
    tool_->release(event.position());
    drag_ = Drag::none;
  } else if (held == Qt::NoButton) {
    drag_ = Drag::none;
  }
}

void ViewInput::leave() {
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, true);
  flush_moves();
  if (tool_ && &tool_->view() == &view_) tool_->leave();
}

bool ViewInput::cancel() {
  if (drag_ != Drag::tool) return false;
  flush_moves();
  tool_->cancel();
  return true;
}

void ViewInput::end_gesture() {
  path_.clear();
  if (drag_ == Drag::tool) drag_ = Drag::none;
}

}  // namespace brume
