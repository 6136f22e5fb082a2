#include "app/tools/selection/brush_select_tool.h"

#include <algorithm>
#include <utility>

#include "app/commands/gaussians/select_command.h"
#include "app/document/document.h"
#include "app/tools/option_widgets.h"
#include "app/view/view.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

double distance_to_segment(QPointF point, QPointF start, QPointF end) {
  const QPointF way = end - start;
  const double square = QPointF::dotProduct(way, way);
  const double t =
      square > 0.0 ? std::clamp(QPointF::dotProduct(point - start, way) / square, 0.0, 1.0) : 0.0;
  const QPointF gap = point - (start + t * way);
  return std::sqrt(QPointF::dotProduct(gap, gap));
}

}  // namespace

QString BrushSelectTool::hint() const {
  return tr(
      "Drag over what you want to select. Shift adds, Ctrl removes, both intersect; [ and ] "
      "change the radius.");
}

void BrushSelectTool::add_options(QHBoxLayout& row) {
  SelectionTool::add_options(row);
  add_number(
      row, *this,
      {tr("Radius, px"), "select_radius", screen_radius_domain, ValueField::Scale::logarithmic,
       0.01},
      [this] { return radius_; }, [this](double value) { set_radius(value); });
}

void BrushSelectTool::set_radius(double radius) {
  radius_ = std::clamp(radius, screen_radius_domain.min_value, screen_radius_domain.max_value);
  Q_EMIT appearance_changed();
  Q_EMIT options_changed();
}

void BrushSelectTool::hover(QPointF position) {
  cursor_ = position;
  Q_EMIT appearance_changed();
}

void BrushSelectTool::leave() {
  cursor_.reset();
  Q_EMIT appearance_changed();
}

void BrushSelectTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  hover(position);
  running_ = true;
  gesture_mode_ = mode_with(modifiers);
  merge_id_ = new_merge_id();
  before_ = document_.selection();
  passed_.clear();
  path_.begin(position);
  last_ = position;
  pass({position});
}

void BrushSelectTool::move(std::span<const QPointF> path) {
  hover(path.back());
  if (running_) pass(path_.extend(path));
}

void BrushSelectTool::release(QPointF /*position*/) {
  if (running_) pass(path_.end());
  running_ = false;
}

void BrushSelectTool::cancel() {
  if (running_) select_gaussians(document_, before_, merge_id_);
  running_ = false;
}

void BrushSelectTool::pass(const std::vector<QPointF>& curve) {
  if (curve.empty()) return;
  const auto more = view().handles().inside([&](QPointF at) {
    QPointF start = last_;
    return std::ranges::any_of(curve, [&](QPointF end) {
      return distance_to_segment(at, std::exchange(start, end), end) <= radius_;
    });
  });
  last_ = curve.back();
  passed_.insert(passed_.end(), more.begin(), more.end());
  std::sort(passed_.begin(), passed_.end());
  passed_.erase(std::unique(passed_.begin(), passed_.end()), passed_.end());
  choose(before_, passed_, gesture_mode_, merge_id_);
}

void BrushSelectTool::draw_on_film(Overlay& overlay) const {
  if (cursor_) overlay.add_circle(cursor_->x(), cursor_->y(), radius_, accent_color().rgba());
}

}  // namespace brume
