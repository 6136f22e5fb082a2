#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "render/geometry/medium_index.h"
#include "render/geometry/tile_rays.h"

namespace brume {

// SIMD kernels of the CPU renderer in single precision, for the widest instruction set of the
// machine (Highway: SSE4, AVX2, AVX-512). Positions are relative to the rays' origin; the
// subtraction is done in double.
//
// Arrays of rays are padded to padded(n) elements, to load and store whole vectors.
constexpr std::size_t padded(std::size_t count) {
  return (count + 15) / 16 * 16;
}

// RayNoise around an origin.
struct BatchNoise {
  float amplitude = 0.0f;     // divided by noise_lattice::rms; 0: none
  float frequency = 0.0f;     // [cells/u]
  float x = 0, y = 0, z = 0;  // lattice position of the origin [cells]
  std::uint32_t key = 0;

  [[nodiscard]] bool on() const { return amplitude > 0.0f; }
};

// The ellipsoid of a Gaussian relative to an origin.
struct BatchEllipsoid {
  std::array<float, 6> warp{};  // Ellipsoid::warp: xx yy zz yz xz xy; 0 0 0 0 0 0: a ball
  glm::vec3 center{0.0f};       // warped [u]
  float max_speed = 0.0f;       // of warped unit vectors: 1 over the least stretch
};

// The batches that kernels are made for; the last for all that has ellipsoids, displaced by noise
// or not.
enum class BatchKind { balls, displaced_balls, ellipsoids };

// Gaussians relative to an origin, as a structure of arrays; those of floats are padded to
// padded(size()) elements, except optics.
struct GaussianBatch {
  std::vector<float> x, y, z;  // b_i - origin [u]
  std::vector<float> a;        // [1/u]
  std::vector<float> scale;    // c sqrt(pi) / (2 a): half the optical depth of a line through the
                               // center (of an ellipsoid along its longest axis)
  std::vector<float> max_e;    // a^2 h^2 beyond which the Gaussian is culled
  std::vector<float>
      max_undisplaced_e;  // the same before displacement by noise; empty without noise
  // Where rays can meet the Gaussian up to its cutoff [u]: from near to far.
  std::vector<float> near, far;
  std::vector<float> reach;  // cutoff radius, displacement by noise included [u]
  std::vector<std::int32_t> index;
  std::vector<BatchEllipsoid> ellipsoids;  // empty: all are balls
  // RelativeOptics: albedo and emission R, G, B; empty until add_optics(), and if all are as by
  // default.
  std::array<std::vector<float>, 4> optics;
  BatchNoise noise;

  // For rays from the origin, or for all rays in one direction that start in the plane through the
  // origin across it. `ray_noise`: the medium's noise for view rays, none for shadow rays.
  void assign(const MediumIndex& medium, const glm::dvec3& origin,
              std::span<const std::uint32_t> indices, const RayNoise& ray_noise = {},
              const std::optional<glm::dvec3>& direction = std::nullopt);
  // The same for the view rays of a tile.
  void assign(const MediumIndex& medium, const TileRays& rays,
              std::span<const std::uint32_t> indices);
  void add_optics(const MediumIndex& medium);
  [[nodiscard]] std::size_t size() const { return index.size(); }
  [[nodiscard]] bool has_optics() const { return !optics[0].empty(); }
  [[nodiscard]] bool is_ellipsoid(std::size_t j) const { return ellipsoids[j].warp[0] > 0.0f; }
  [[nodiscard]] BatchKind kind() const {
    if (!ellipsoids.empty()) return BatchKind::ellipsoids;
    return noise.on() ? BatchKind::displaced_balls : BatchKind::balls;
  }

 private:
  void add_ellipsoid(std::size_t k, const GaussianTerm<double>& g, const glm::dvec3& origin,
                     const std::optional<glm::dvec3>& direction);
};

// Rays or segments from the origin, as arrays: unit direction and length (may be +inf).
struct PathBatch {
  std::vector<float> x, y, z;
  // Where parallel rays start, from the origin [u]; empty: all start there.
  std::vector<float> offset_x, offset_y, offset_z;
  std::vector<float> length;
  std::vector<std::int32_t> self;  // index of a Gaussian to exclude, or -1
  std::size_t count = 0;

  void assign(const glm::dvec3& origin, std::span<const glm::dvec3> ends,
              std::span<const std::int32_t> self_of);
  // Rays of unit directions; lengths may be +inf.
  void assign(std::span<const glm::dvec3> directions, std::span<const double> lengths);
  void assign(const TileRays& rays);
  void make_endless();  // sets all lengths to +inf
  void resize(std::size_t size);
  [[nodiscard]] std::size_t padded_size() const { return x.size(); }
  [[nodiscard]] bool has_offsets() const { return !offset_x.empty(); }
};

// Calls body.template operator()<kind>() with the kind of a batch.
template <class Body>
decltype(auto) with_kind(const GaussianBatch& batch, Body body) {
  switch (batch.kind()) {
    case BatchKind::balls:
      return body.template operator()<BatchKind::balls>();
    case BatchKind::displaced_balls:
      return body.template operator()<BatchKind::displaced_balls>();
    default:
      return body.template operator()<BatchKind::ellipsoids>();
  }
}

// depths[k] += optical depth along path k, for padded_size() paths.
void accumulate_path_depths(const GaussianBatch& gaussians, const PathBatch& paths, float* depths);

// Number of lights evaluated together per view ray.
constexpr std::size_t light_pack = 4;

struct LightBatch {
  std::size_t count = 0;
  float anisotropy = 0.0f;                      // of the medium
  bool at_mean = false;                         // see PaperOptions
  std::array<float, light_pack> x{}, y{}, z{};  // relative to the eye [u]
  std::array<float, light_pack> h_min{};        // see PointLightRay [u]
  // Per light and Gaussian: Tbar_i(s, b_i) + Tbar_i(v, b_i).
  std::array<std::vector<float>, light_pack> frozen;
  // Per Gaussian: Tbar_i(v, b_i). Only used with `scattered`.
  std::vector<float> from_eye;
};

// The paper's airlight (eq. 16) of all Gaussians: for every ray k, depths[k] += T(v, p) and
// radiance[l][k] += sum_i L_i per unit of radiant intensity [1/u^2]. `depths` is null if already
// summed for another pack of lights. Unless null, scattered[k] += sum_i T_i(v, p) exp(-Tbar_i(v,
// b_i) - T_i(v, x_i)): in-scattering of a unit uniform light. Returns the Gaussian x ray pairs that
// passed the cutoff.
std::uint64_t accumulate_paper_airlight(const GaussianBatch& gaussians, const PathBatch& rays,
                                        const LightBatch& lights, float* depths, float* scattered,
                                        const std::array<float*, light_pack>& radiance);

// Homogeneous fog, everywhere or in a ball.
struct BatchFog {
  float density = 0.0f;    // b0 [1/u]
  glm::vec3 center{0.0f};  // relative to the rays' origin [u]
  float radius = 0.0f;     // 0: everywhere

  BatchFog() = default;
  explicit BatchFog(float b0) : density(b0) {}
  BatchFog(const MediumIndex& medium, const glm::dvec3& origin);
};

// Airlight of the homogeneous part (eqs. 17 to 19): radiance[k] += attenuation * b0/(4 pi) *
// integral, per unit of radiant intensity; relative error at most 5e-4.
void accumulate_homogeneous_airlight(const BatchFog& fog, float attenuation, const glm::vec3& light,
                                     float h_min, float anisotropy, const PathBatch& rays,
                                     float* radiance);

}  // namespace brume
