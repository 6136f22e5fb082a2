#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace brume {

struct Noise;

// The noise of section 5.5 of the paper: it bends view rays, so that a few Gaussians look like fog
// torn by wind. A view ray of unit direction w meets a Gaussian of radius r, whose foot on the ray
// is x (the point of the whole line nearest to its centre), as if the ray were shifted sideways by
//
//   delta = r amplitude / rms * w x grad(w . A)(x),
//
// where A is three channels of tileable gradient noise (Perlin 2002) with `frequency` lattice cells
// per u and grad is taken per cell. A is fixed in the world and goes with the wind: only x and w
// count, and a ray and its reverse are shifted alike. The ray keeps its length and its parameter;
// light on its way to the ray is not bent.
//
// Why this shift, and not A itself: w x grad(w . A) is the curl noise curl A (Bridson 2007) across
// the ray, up to its sign and to the term w x (w . grad) A that frees it of divergence in the plane
// across w. Rays through that plane with feet x see the depth f(x + delta(x)) where they saw f(x),
// so the plane's mean is that of f(y) / J with
//
//   J = det(1 + grad delta) = 1 + div delta + det(grad delta) = 1 + det(grad delta).
//
// What is left is of second order in amplitude * frequency * r and is a divergence itself, so its
// mean over the plane is 0: it changes one Gaussian a little, and clouds less. The mean over all
// noises is not changed at all, whatever the amplitude: delta is alike distributed everywhere. (All
// this in parallel rays. From near, what is shifted towards the eye looks larger, by about
// 2 |delta| over the distance.)
class RayNoise {
 public:
  // The lattice repeats after so many cells along x, y and z; a power of 2.
  static constexpr int period = 64;
  // |delta| / (r amplitude) is 1 on average (the root of the mean square) and taken to be at most
  // this for culling. Not one of 8 million points had more than 3.8; the bound is 6.1.
  static constexpr double greatest = 4.0;

  RayNoise() = default;  // none
  // At `time` [s]. Amplitudes above 1e6 are taken for that: nothing is left of any cloud then.
  RayNoise(const Noise& noise, double time);

  [[nodiscard]] bool on() const { return amplitude_ > 0.0; }
  [[nodiscard]] double amplitude() const { return amplitude_; }
  // Lattice cells per u.
  [[nodiscard]] double frequency() const { return frequency_; }
  // What the lattice's hash is made with.
  [[nodiscard]] std::uint32_t key() const { return key_; }
  // The place of a point in the lattice, in cells, each in [0, period).
  [[nodiscard]] glm::dvec3 cell(const glm::dvec3& x) const;

  // delta / r for the foot `x` of a Gaussian on a ray of unit direction `w`, across w. Continuous,
  // with continuous derivatives, in both. Finite wherever x is.
  [[nodiscard]] glm::dvec3 shift(const glm::dvec3& x, const glm::dvec3& w) const;

  bool operator==(const RayNoise&) const = default;

 private:
  double amplitude_ = 0.0;
  double frequency_ = 0.0;
  glm::dvec3 drift_{0.0};  // [u]
  std::uint32_t key_ = 0;
};

namespace noise_lattice {

// The root of the mean square of w x grad(w . A) over all noises, points and directions.
constexpr double rms = 1.2202;

// 32 bits of a node of the lattice; the nine highest are the signs of its three gradients, all of
// whose coordinates are 1 or -1: bit 31 - 3 k - j is coordinate j of channel k. (lowbias32 of
// C. Wellons' hash prospector.) Render's kernels do the same.
constexpr std::uint32_t hash(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

// The number of a node; coordinates in [0, RayNoise::period).
constexpr std::uint32_t node(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return (z * RayNoise::period + y) * RayNoise::period + x;
}

}  // namespace noise_lattice
}  // namespace brume
