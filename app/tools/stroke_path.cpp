#include "app/tools/stroke_path.h"

namespace brume {
namespace {

constexpr double spacing = 3.0;  // pixels from point to point of the curve

void append(std::vector<QPointF>& curve, const std::vector<glm::dvec2>& more) {
  for (const glm::dvec2& point : more) curve.emplace_back(point.x, point.y);
}

}  // namespace

void StrokePath::begin(QPointF position) {
  path_.emplace(glm::dvec2(position.x(), position.y()), spacing);
}

std::vector<QPointF> StrokePath::extend(std::span<const QPointF> positions) {
  std::vector<QPointF> curve;
  if (!path_) return curve;
  for (const QPointF position : positions)
    append(curve, path_->extend({position.x(), position.y()}));
  return curve;
}

std::vector<QPointF> StrokePath::end() {
  std::vector<QPointF> curve;
  if (path_) append(curve, path_->end());
  path_.reset();
  return curve;
}

}  // namespace brume
