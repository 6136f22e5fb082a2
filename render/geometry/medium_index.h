#pragma once

#include <span>
#include <vector>

#include "brume/medium.h"
#include "brume/revision.h"
#include "core/scene/ray_noise.h"
#include "core/transport/optical_depth.h"
#include "render/geometry/fog_ball.h"
#include "render/geometry/sphere_bvh.h"

namespace brume {

// Optics of a Gaussian of an extinction_medium(), or of a mixture of them: its albedo relative to
// that of the medium's fog, and its emission divided by the same.
struct RelativeOptics {
  double albedo = 1.0;
  glm::dvec3 emission{0.0};
};

// The mean of optics, weighted by density [1/u], beginning with fog.
class OpticsMean {
 public:
  explicit OpticsMean(double fog) : density_(fog), albedo_(fog) {}
  void add(double density, const RelativeOptics& optics) {
    density_ += density;
    albedo_ += density * optics.albedo;
    emission_ += density * optics.emission;
  }
  [[nodiscard]] RelativeOptics mean() const {
    if (!(density_ > 0.0)) return {};
    return {albedo_ / density_, emission_ / density_};
  }

 private:
  double density_, albedo_;
  glm::dvec3 emission_{0.0};
};

// How much of Gaussians may be culled from a path.
struct CullingTolerance {
  // Optical depth below which a Gaussian may be.
  double depth;
  // Where Gaussians are many, the sum of what is culled counts: of each up to this share of the
  // depth of a line through its center, so of a path up to this share of its depth, but at most
  // `max_depth`, beyond which the edge of a single one would be seen.
  double share = 0.0;
  double max_depth = 0.0;

  CullingTolerance(double depth_) : depth(depth_) {}  // NOLINT(google-explicit-constructor)
  CullingTolerance(double depth_, double share_, double max_depth_)
      : depth(depth_), share(share_), max_depth(max_depth_) {}

  [[nodiscard]] double of(const Gaussian& gaussian) const;
};

// A medium prepared for queries: its Gaussians in the paper's symbols, their cutoff radii and a
// bounding-volume hierarchy. Indices are the medium's.
class MediumIndex {
 public:
  MediumIndex(const Medium& medium, const CullingTolerance& tolerance, double anisotropy = 0.0);

  // Changes with all but the noise and where fog is.
  [[nodiscard]] Revision revision() const { return revision_; }
  [[nodiscard]] std::size_t size() const { return gaussians_.size(); }
  [[nodiscard]] std::span<const GaussianTerm<double>> gaussians() const { return gaussians_.all(); }
  [[nodiscard]] std::span<const double> cutoff_radii() const { return cutoff_radii_; }
  // The optics of each Gaussian; empty if all are as by default.
  [[nodiscard]] std::span<const RelativeOptics> optics() const { return optics_; }
  // The optics at x, with fog of that density [1/u]; means weighted by density.
  [[nodiscard]] RelativeOptics optics_at(const glm::dvec3& x, double fog) const;
  [[nodiscard]] const SphereBvh& bvh() const { return bvh_; }
  // Noise that displaces view rays; off by default; changing it needs no new index.
  [[nodiscard]] const RayNoise& noise() const { return noise_; }
  void set_noise(const RayNoise& noise) { noise_ = noise; }
  // Cutoff radius for a view ray that noise may displace [u].
  [[nodiscard]] double view_cutoff_radius(std::size_t i) const {
    if (!noise_.on() || !(cutoff_radii_[i] > 0.0)) return cutoff_radii_[i];
    return cutoff_radii_[i] + RayNoise::max_shift * noise_.amplitude() / gaussians_[i].a;
  }
  // Maximum of view_cutoff_radius() - cutoff_radii().
  [[nodiscard]] double max_displacement() const;
  // g of its phase function, see henyey_greenstein().
  [[nodiscard]] double anisotropy() const { return anisotropy_; }
  // Optical depth below which any Gaussian may be culled from a path.
  [[nodiscard]] double tolerance() const { return tolerance_.depth; }
  // Segments below this optical depth are skipped, except in homogeneous fog, where short segments
  // near a light matter.
  [[nodiscard]] double negligible_depth() const {
    return b0_ > 0.0 ? 0.0 : 1e-3 * tolerance_.depth;
  }
  // The density b0 of homogeneous fog [1/u].
  [[nodiscard]] double homogeneous_density() const { return b0_; }
  // Where that fog is: everywhere by default. Changing it needs no new index.
  [[nodiscard]] const FogBall& fog() const { return fog_; }
  void set_fog(const FogBall& fog) { fog_ = fog; }
  [[nodiscard]] double homogeneous_density_at(const glm::dvec3& x) const {
    return fog_.contains(x) ? b0_ : 0.0;
  }
  // Its optical depth along the first `length` of a ray, may be +inf.
  [[nodiscard]] double fog_depth(const glm::dvec3& x, const glm::dvec3& w, double length) const {
    return b0_ > 0.0 ? b0_ * fog_.length(x, w, length) : 0.0;
  }

  // b(x) of Gaussians and b0 [1/u], up to the tolerance.
  [[nodiscard]] double density(const glm::dvec3& x) const;

  // Optical depth of a segment (length may be +inf), up to the tolerance.
  [[nodiscard]] double depth(const RaySegment& segment) const;

 private:
  Revision revision_ = new_revision();
  GaussianTerms<double> gaussians_;
  std::vector<double> cutoff_radii_;
  std::vector<RelativeOptics> optics_;
  double max_radius_ = 0.0;
  RayNoise noise_;
  SphereBvh bvh_;
  double b0_;
  FogBall fog_;
  CullingTolerance tolerance_;
  double anisotropy_;
};

// The optics of the Gaussians of an extinction_medium(); empty if all are as by default.
std::vector<RelativeOptics> relative_optics(const Medium& extinction);

// For which the optical depth of a ray is within `error`, as measured on clouds (culled Gaussians
// add up to 1/16 of the rigorous n * tolerance). Relative to the deepest Gaussian in thin media,
// which would be culled altogether otherwise.
CullingTolerance culling_tolerance(const Medium& medium, double error);

}  // namespace brume
