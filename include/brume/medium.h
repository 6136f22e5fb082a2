#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "brume/export.h"
#include "brume/gaussian.h"
#include "brume/revision.h"
#include "brume/shared_column.h"

namespace brume {

class MediumEdit;

// A scattering medium: b(x) = homogeneous_density + sum of Gaussians (eqs. 1 and 2 of the paper).
//
// A structure of arrays ordered by id; ids only grow. So lookup is a binary search, and a Gaussian
// that is removed and restored returns to its place. Filled with append() on creation, modified
// only by MediumEdit (undo relies on it). Copies share what has not been changed: a copy costs
// nothing, and an edit what it adds, or the columns in which it changes something.
class BRUME_EXPORT Medium {
 public:
  [[nodiscard]] std::size_t size() const { return ids_.size(); }
  [[nodiscard]] bool empty() const { return ids_.empty(); }

  [[nodiscard]] std::span<const glm::dvec3> centers() const { return centers_.all(); }
  // The greatest of each Gaussian.
  [[nodiscard]] std::span<const double> radii() const { return radii_.all(); }
  [[nodiscard]] std::span<const double> densities() const { return densities_.all(); }
  [[nodiscard]] std::span<const GaussianId> ids() const { return ids_.all(); }

  // The Gaussian at an index in [0, size()).
  [[nodiscard]] Gaussian gaussian(std::size_t index) const {
    return {centers_[index], radii_[index], densities_[index],
            optics(index),   group(index),  shape(index)};
  }
  // All of them, in their order.
  [[nodiscard]] std::vector<Gaussian> gaussians() const;
  [[nodiscard]] std::optional<std::size_t> index_of(GaussianId id) const;

  [[nodiscard]] GaussianOptics optics(std::size_t index) const {
    return optics_.empty() ? GaussianOptics() : optics_[index];
  }
  [[nodiscard]] GroupId group(std::size_t index) const {
    return groups_.empty() ? 0 : groups_[index];
  }
  [[nodiscard]] GaussianShape shape(std::size_t index) const {
    return shapes_.empty() ? GaussianShape() : shapes_[index];
  }
  // The shape of each Gaussian; empty if all are balls.
  [[nodiscard]] std::span<const GaussianShape> shapes() const { return shapes_.all(); }
  // Whether a Gaussian has an albedo of its own, or shines.
  [[nodiscard]] bool has_albedos() const;
  [[nodiscard]] bool has_emission() const;

  // The values themselves, to be written in place by what keeps no history: within the domains of
  // Gaussian. The medium has changed once this returns; ask again before each round of writing, so
  // that renderers notice. Valid until Gaussians are added or removed.
  struct Columns {
    std::span<glm::dvec3> centers;
    std::span<double> radii;
    std::span<double> densities;
  };
  [[nodiscard]] Columns columns();

  // b0, the homogeneous scattering coefficient [1/u], >= 0.
  [[nodiscard]] double homogeneous_density() const { return homogeneous_density_; }
  void set_homogeneous_density(double b0);

  // The id that the next appended Gaussian gets; an edit that adds n takes next_id() + 0..n-1.
  [[nodiscard]] GaussianId next_id() const { return next_id_; }
  GaussianId append(const Gaussian& gaussian);
  void reserve(std::size_t count);

  // The same with other radii, densities and optics of its Gaussians, which `change` gets one by
  // one, and b0.
  template <class Change>
  [[nodiscard]] Medium changed(double b0, Change change) const {
    Medium medium = *this;
    medium.homogeneous_density_ = b0;
    for (std::size_t i = 0; i < size(); ++i) {
      const Gaussian changed = change(gaussian(i));
      medium.radii_.set(i, changed.radius);
      medium.densities_.set(i, changed.density);
      medium.set_optics(i, changed.optics);
    }
    medium.revision_ = new_revision();
    return medium;
  }

  // Media of equal revision are equal; copies share theirs. 0: empty from the beginning.
  [[nodiscard]] Revision revision() const { return revision_; }

  // Equal Gaussians, ids and b0; the next id does not matter.
  bool operator==(const Medium& other) const;

 private:
  friend class MediumEdit;

  void push_back(GaussianId id, const Gaussian& gaussian);
  void set_optics(std::size_t index, const GaussianOptics& optics);
  void set_group(std::size_t index, GroupId group);
  void set_shape(std::size_t index, const GaussianShape& shape);

  SharedColumn<glm::dvec3> centers_;
  SharedColumn<double> radii_;
  SharedColumn<double> densities_;
  SharedColumn<GaussianOptics> optics_;  // empty: all as by default
  SharedColumn<GroupId> groups_;         // empty: all in none
  SharedColumn<GaussianShape> shapes_;   // empty: all balls
  SharedColumn<GaussianId> ids_;
  GaussianId next_id_ = 1;
  double homogeneous_density_ = 0.0;
  Revision revision_ = 0;
};

}  // namespace brume
