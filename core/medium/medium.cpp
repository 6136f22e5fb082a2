#include "brume/medium.h"

#include <algorithm>

namespace brume {

std::optional<std::size_t> Medium::index_of(GaussianId id) const {
  const std::span<const GaussianId> all = ids();
  if (all.empty() || id < all.front() || id > all.back()) return std::nullopt;
  // Ids ascend: an index is at most as far from either end as the id is, so where none is missing
  // it is found at once.
  const std::size_t last = all.size() - 1;
  const std::size_t low = last - std::min<std::size_t>(last, all.back() - id);
  const std::size_t high = std::min<std::size_t>(last, id - all.front());
  const auto range = all.subspan(low, high + 1 - low);
  const auto at = std::ranges::lower_bound(range, id);
  if (at == range.end() || *at != id) return std::nullopt;
  return low + static_cast<std::size_t>(at - range.begin());
}

Medium::Columns Medium::columns() {
  revision_ = new_revision();
  return {centers_.write(), radii_.write(), densities_.write()};
}

GaussianId Medium::append(const Gaussian& gaussian) {
  push_back(next_id_, gaussian);
  revision_ = new_revision();
  return next_id_++;
}

void Medium::push_back(GaussianId id, const Gaussian& gaussian) {
  centers_.push_back(gaussian.center);
  radii_.push_back(gaussian.radius);
  densities_.push_back(gaussian.density);
  ids_.push_back(id);
  if (!optics_.empty()) {
    optics_.push_back(gaussian.optics);
  } else {
    set_optics(size() - 1, gaussian.optics);
  }
  if (!groups_.empty()) {
    groups_.push_back(gaussian.group);
  } else {
    set_group(size() - 1, gaussian.group);
  }
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

void Medium::set_optics(std::size_t index, const GaussianOptics& optics) {
  if (optics_.empty()) {
    if (optics == GaussianOptics()) return;
    optics_.resize(size());
  }
  optics_.set(index, optics);
}

void Medium::set_group(std::size_t index, GroupId group) {
  if (groups_.empty()) {
    if (group == 0) return;
    groups_.resize(size());
  }
  groups_.set(index, group);
}

bool Medium::has_albedos() const {
  return std::ranges::any_of(optics_.all(),
                             [](const auto& optics) { return optics.albedo.has_value(); });
}

bool Medium::has_emission() const {
  return std::ranges::any_of(optics_.all(),
                             [](const auto& optics) { return optics.emission != glm::dvec3(0.0); });
}

bool Medium::operator==(const Medium& other) const {
  if (revision_ == other.revision_) return true;
  const bool same_optics = optics_.empty() && other.optics_.empty();
  for (std::size_t i = 0; !same_optics && i < size(); ++i) {
    if (i >= other.size() || !(optics(i) == other.optics(i))) return false;
  }
  const bool same_groups = groups_.empty() && other.groups_.empty();
  for (std::size_t i = 0; !same_groups && i < size(); ++i) {
    if (i >= other.size() || group(i) != other.group(i)) return false;
  }
  return homogeneous_density_ == other.homogeneous_density_ && ids_ == other.ids_ &&
         centers_ == other.centers_ && radii_ == other.radii_ && densities_ == other.densities_;
}

}  // namespace brume
