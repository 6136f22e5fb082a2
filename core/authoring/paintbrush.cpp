#include "core/authoring/paintbrush.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/math/basis.h"

namespace brume {

std::vector<Gaussian> PaintStroke::extend(const glm::dvec3& point) {
  const double step = std::max(brush_.spacing, 0.05) * brush_.radius;
  const glm::dvec3 way = last_ ? point - *last_ : glm::dvec3(0.0);
  const double length = glm::length(way);
  if (!last_ || !(length <= longest * step)) {
    last_ = point;
    left_ = step;
    return {{point, brush_.radius, brush_.density}};
  }
  std::vector<Gaussian> gaussians;
  if (length == 0.0) return gaussians;
  const glm::dvec3 direction = way / length;
  const Basis plane = make_basis(direction);
  double at = left_;
  for (; at <= length; at += step) {
    const glm::dvec2 offset = brush_.scatter * brush_.radius * random_.in_disc();
    gaussians.push_back({*last_ + at * direction + offset.x * plane.u + offset.y * plane.v,
                         brush_.radius, brush_.density});
  }
  left_ = at - length;
  last_ = point;
  return gaussians;
}

}  // namespace brume
