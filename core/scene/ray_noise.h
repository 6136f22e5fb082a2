#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace brume {

struct Noise;

// The noise of section 5.5 of the paper: displaces view rays, so that a few Gaussians look like fog
// torn by wind. A view ray of unit direction w meets a Gaussian of radius r, whose foot on the ray
// is x (the point of the line nearest to its center), as if the ray were shifted sideways by
//
//   delta = r amplitude / rms * w x grad(w . A)(x),
//
// where A is three channels of tileable gradient noise (Perlin 2002) with `frequency` lattice cells
// per u; grad is per cell. A is fixed in world space and moves with the wind: delta depends on x
// and w only, and is the same for a ray and its reverse. Length and parametrisation of the ray
// stay; shadow rays are not displaced.
//
// Why this displacement and not A itself: w x grad(w . A) is the curl noise curl A (Bridson 2007)
// across the ray, up to its sign and to the term w x (w . grad) A, without which it has no
// divergence in the plane across w. Parallel rays through that plane with feet x see the optical
// depth f(x + delta(x)) instead of f(x), so the mean over the plane is that of f(y) / J with
//
//   J = det(1 + grad delta) = 1 + div delta + det(grad delta) = 1 + det(grad delta).
//
// The remainder is of second order in amplitude * frequency * r and is a divergence, so its mean
// over the plane is 0: it changes one Gaussian slightly, and clouds less. The mean over all noises
// is unchanged for any amplitude, since delta has the same distribution everywhere. (For
// perspective rays, shifts towards the eye magnify by about 2 |delta| over the distance.)
class RayNoise {
 public:
  // Period of the lattice in cells along each axis; a power of 2.
  static constexpr int period = 64;
  // Bound of |delta| / (r amplitude) for culling; its rms is 1. None of 8 million samples exceeded
  // 3.8; the rigorous bound is 6.1.
  static constexpr double max_shift = 4.0;

  RayNoise() = default;  // none
  // At `time` [s]. Amplitudes are clamped to 1e6, where nothing is left of any cloud.
  RayNoise(const Noise& noise, double time);

  [[nodiscard]] bool on() const { return amplitude_ > 0.0; }
  [[nodiscard]] double amplitude() const { return amplitude_; }
  // Lattice cells per u.
  [[nodiscard]] double frequency() const { return frequency_; }
  // Seed of the lattice's hash.
  [[nodiscard]] std::uint32_t key() const { return key_; }
  // Lattice coordinates of a point, in cells, each in [0, period).
  [[nodiscard]] glm::dvec3 cell(const glm::dvec3& x) const;

  // delta / r for the foot `x` of a Gaussian on a ray of unit direction `w`; perpendicular to w.
  // Continuously differentiable in both, finite for finite x.
  [[nodiscard]] glm::dvec3 shift(const glm::dvec3& x, const glm::dvec3& w) const;

  bool operator==(const RayNoise&) const = default;

 private:
  double amplitude_ = 0.0;
  double frequency_ = 0.0;
  glm::dvec3 drift_{0.0};  // [u]
  std::uint32_t key_ = 0;
};

namespace noise_lattice {

// RMS of w x grad(w . A) over all noises, points and directions.
constexpr double rms = 1.2202;

// Hash of a lattice node; the nine highest bits are the signs of its three gradients, whose
// coordinates are all +-1: bit 31 - 3 k - j is coordinate j of channel k. (lowbias32 of C. Wellons'
// hash prospector.) Identical in the SIMD kernels and the shaders.
inline constexpr std::uint32_t hash_factors[] = {0x7feb352dU, 0x846ca68bU};
inline constexpr int hash_shifts[] = {16, 15, 16};
constexpr std::uint32_t hash(std::uint32_t x) {
  x ^= x >> hash_shifts[0];
  x *= hash_factors[0];
  x ^= x >> hash_shifts[1];
  x *= hash_factors[1];
  x ^= x >> hash_shifts[2];
  return x;
}

// Weight of the farther node at f in [0, 1]: f^3 P(f), highest coefficient first (Perlin's fifth
// order). Its derivative is fade_slope f^2 (1 - f)^2.
inline constexpr float fade[] = {6.0f, -15.0f, 10.0f};
inline constexpr float fade_slope = 30.0f;

// Index of a node; coordinates in [0, RayNoise::period).
constexpr std::uint32_t node(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return (z * RayNoise::period + y) * RayNoise::period + x;
}

}  // namespace noise_lattice
}  // namespace brume
