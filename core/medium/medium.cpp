#include "core/medium/medium.h"

#include <algorithm>

namespace brume {

std::optional<std::size_t> Medium::index_of(GaussianId id) const {
  const auto at = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (at == ids_.end() || *at != id) return std::nullopt;
  return static_cast<std::size_t>(at - ids_.begin());
}

GaussianId Medium::append(const Gaussian& gaussian) {
  centers_.push_back(gaussian.center);
  radii_.push_back(gaussian.radius);
  densities_.push_back(gaussian.density);
  ids_.push_back(next_id_);
  return next_id_++;
}

void Medium::reserve(std::size_t count) {
  centers_.reserve(count);
  radii_.reserve(count);
  densities_.reserve(count);
  ids_.reserve(count);
}

bool Medium::operator==(const Medium& other) const {
  return homogeneous_density_ == other.homogeneous_density_ && ids_ == other.ids_ &&
         centers_ == other.centers_ && radii_ == other.radii_ && densities_ == other.densities_;
}

}  // namespace brume
