#pragma once

#include <span>
#include <vector>

#include "core/medium/medium.h"
#include "core/medium/noise.h"
#include "core/transport/optical_depth.h"
#include "render/sphere_hierarchy.h"

namespace brume {

// A medium made ready for queries: its Gaussians in the paper's symbols, how far each reaches at
// a tolerance on optical depth, and the tree over those spheres. Indices are the medium's.
class MediumIndex {
 public:
  // `tolerance`: the optical depth below which one Gaussian may be left out of a path.
  MediumIndex(const Medium& medium, double tolerance, double anisotropy = 0.0);

  [[nodiscard]] std::size_t size() const { return gaussians_.size(); }
  [[nodiscard]] std::span<const GaussianTerm<double>> gaussians() const { return gaussians_; }
  [[nodiscard]] std::span<const double> reach() const { return reach_; }
  [[nodiscard]] const SphereHierarchy& hierarchy() const { return hierarchy_; }
  // What bends view rays in it; made off, and set without a new index.
  [[nodiscard]] const RayNoise& noise() const { return noise_; }
  void set_noise(const RayNoise& noise) { noise_ = noise; }
  // reach() of a view ray that noise may bend [u].
  [[nodiscard]] double view_reach(std::size_t i) const {
    if (!noise_.on() || !(reach_[i] > 0.0)) return reach_[i];
    return reach_[i] + RayNoise::greatest * noise_.amplitude() / gaussians_[i].a;
  }
  // The most by which one is greater than the other.
  [[nodiscard]] double greatest_bend() const;
  // g of its phase function, see henyey_greenstein().
  [[nodiscard]] double anisotropy() const { return anisotropy_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  // A stretch of a ray with less depth gives no light that is worth having. In homogeneous fog all
  // do: close to a light even short ones are bright.
  [[nodiscard]] double negligible_depth() const { return b0_ > 0.0 ? 0.0 : 1e-3 * tolerance_; }
  [[nodiscard]] double homogeneous_density() const { return b0_; }

  // b(x) of Gaussians and b0 [1/u], exact up to the tolerance on depths.
  [[nodiscard]] double density(const glm::dvec3& x) const;

  // T(a, b) of Gaussians and b0, exact up to the tolerance; +inf is allowed as length.
  [[nodiscard]] double depth(const RaySegment& segment) const;

 private:
  std::vector<GaussianTerm<double>> gaussians_;
  std::vector<double> reach_;
  double greatest_radius_ = 0.0;
  RayNoise noise_;
  SphereHierarchy hierarchy_;
  double b0_;
  double tolerance_;
  double anisotropy_;
};

// The tolerance per Gaussian that leaves the depth of a ray within `error` of the exact one, as
// measured on clouds (math: dropped Gaussians sum up to a 25th of the guaranteed n * tolerance).
// In a thin medium it is relative to the deepest Gaussian, or all of it would be left out.
double depth_tolerance(const Medium& medium, double error);

}  // namespace brume
