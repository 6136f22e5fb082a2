#include "core/medium/medium.h"

#include <algorithm>

namespace brume {
std::optional<std::size_t> Medium::index_of(GaussianId id) const {
  const auto it = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (it == ids_.end() || *it != id) return std::nullopt;
  return static_cast<std::size_t>(it - ids_.begin());
}

GaussianId Medium::append(const Gaussian& gaussian) {
  centers_.push_back(gaussian.center);
  radii_.push_back(gaussian.radius);
  densities_.push_back(gaussian.density);
  ids_.push_back(next_id_);
  revision_ = new_revision();
  return next_id_++;
}

void Medium::reserve(std::size_t count) {
  centers_.reserve(count);
  radii_.reserve(count);
  densities_.reserve(count);
  ids_.reserve(count);
}

void Medium::set_homogeneous_density(double b0) {
  if (b0 == homogeneous_density_) return;
  homogeneous_density_ = b0;
  revision_ = new_revision();
}

Medium Medium::divided_by(double divisor) const {
  Medium medium = *this;
  for (double& density : medium.densities_) density /= divisor;
  medium.homogeneous_density_ /= divisor;
  medium.revision_ = new_revision();
  return medium;
}

bool Medium::operator==(const Medium& other) const {
  if (revision_ == other.revision_) return true;
  return homogeneous_density_ == other.homogeneous_density_ && ids_ == other.ids_ &&
         centers_ == other.centers_ && radii_ == other.radii_ && densities_ == other.densities_;
}

}  // namespace brume
