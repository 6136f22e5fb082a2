#include "core/authoring/paintbrush.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/math/basis.h"

namespace brume {

std::vector<Gaussian> PaintStroke::extend(const glm::dvec3& point) {
  const double step = std::max(brush_.spacing, 0.05) * brush_.radius;
  const glm::dvec3 way = last_ ? point - *last_ : glm::dvec3(0.0);
  const double length = glm::length(way);
  if (!last_ || !(length <= max_steps * step)) {
    last_ = point;
    distance_to_next_ = step;
    return {{point, brush_.radius, brush_.density}};
  }
  std::vector<Gaussian> gaussians;
  if (length == 0.0) return gaussians;
  const glm::dvec3 direction = way / length;
  const Basis plane = make_basis(direction);
  double distance = distance_to_next_;
  for (; distance <= length; distance += step) {
    const glm::dvec2 offset = brush_.scatter * brush_.radius * random_.in_disc();
    gaussians.push_back({*last_ + distance * direction + offset.x * plane.u + offset.y * plane.v,
                         brush_.radius, brush_.density});
  }
  distance_to_next_ = distance - length;
  last_ = point;
  return gaussians;
}

}  // namespace brume
