#include "brume/medium.h"

#include <algorithm>

namespace brume {
namespace {

// Columns that are empty while all Gaussians are as by default.
template <class T>
void set_in(SharedColumn<T>& column, std::size_t size, std::size_t index, const T& value) {
  if (column.empty()) {
    if (value == T()) return;
    column.resize(size);
  }
  column.set(index, value);
}

// Adds the last of `size`.
template <class T>
void add_to(SharedColumn<T>& column, std::size_t size, const T& value) {
  if (!column.empty()) {
    column.push_back(value);
  } else {
    set_in(column, size, size - 1, value);
  }
}

template <class T>
bool are_equal(const SharedColumn<T>& a, const SharedColumn<T>& b) {
  if (a.empty() == b.empty()) return a == b;
  return std::ranges::all_of((a.empty() ? b : a).all(),
                             [](const T& value) { return value == T(); });
}

}  // namespace

std::vector<Gaussian> Medium::gaussians() const {
  std::vector<Gaussian> all;
  all.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) all.push_back(gaussian(i));
  return all;
}

std::optional<std::size_t> Medium::index_of(GaussianId id) const {
  const std::span<const GaussianId> all = ids();
  if (all.empty() || id < all.front() || id > all.back()) return std::nullopt;
  // Ids ascend: an index is at most as far from either end as the id is, so where none is missing
  // it is found at once.
  const std::size_t last = all.size() - 1;
  const std::size_t low = last - std::min<std::size_t>(last, all.back() - id);
  const std::size_t high = std::min<std::size_t>(last, id - all.front());
  const auto range = all.subspan(low, high + 1 - low);
  const auto found = std::ranges::lower_bound(range, id);
  if (found == range.end() || *found != id) return std::nullopt;
  return low + static_cast<std::size_t>(found - range.begin());
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
  add_to(optics_, size(), gaussian.optics);
  add_to(groups_, size(), gaussian.group);
  add_to(shapes_, size(), gaussian.shape);
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
  set_in(optics_, size(), index, optics);
}

void Medium::set_group(std::size_t index, GroupId group) {
  set_in(groups_, size(), index, group);
}

void Medium::set_shape(std::size_t index, const GaussianShape& shape) {
  set_in(shapes_, size(), index, shape);
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
  return homogeneous_density_ == other.homogeneous_density_ && ids_ == other.ids_ &&
         centers_ == other.centers_ && radii_ == other.radii_ && densities_ == other.densities_ &&
         are_equal(optics_, other.optics_) && are_equal(groups_, other.groups_) &&
         are_equal(shapes_, other.shapes_);
}

}  // namespace brume
