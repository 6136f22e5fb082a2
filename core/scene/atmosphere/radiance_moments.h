#pragma once

#include <array>
#include <vector>

#include "core/scene/atmosphere/air.h"

namespace brume {

// A direction relative to a place: its cosines to the zenith and, of its horizontal part, to the
// sun's azimuth. Light is the same on both sides of the plane of sun and zenith.
struct SkyDirection {
  double up;
  double sunward;
};

// The spherical harmonics of up to degree 2 that are even about that plane: Y00, Y10, Y11, Y20,
// Y21, Y22.
inline constexpr std::size_t moment_count = 6;
using Moments = std::array<Spectrum, moment_count>;
std::array<double, moment_count> even_harmonics(const SkyDirection& direction);

// Radiance in all directions, as moments, over altitudes and zenith angles of the sun.
class RadianceMoments {
 public:
  static constexpr int altitudes = 14;

  // Around a zenith angle of the sun [radians].
  explicit RadianceMoments(double sun_zenith);

  [[nodiscard]] int zeniths() const { return zeniths_; }

  [[nodiscard]] static double altitude(int i);   // [km]
  [[nodiscard]] double sun_zenith(int j) const;  // [radians]; at least 0
  [[nodiscard]] const Moments& node(int i, int j) const { return nodes_[index(i, j)]; }
  void set(int i, int j, const Moments& moments);

  // Between nodes: the logarithm of the mean radiance is linear, which falls off exponentially in
  // twilight, and the others relative to it. Beyond the outer nodes as on them.
  [[nodiscard]] Moments at(double altitude, double sun_zenith) const;
  // The place among the zenith angles of the nodes: the node before it, and how far it is on the
  // way to the next.
  struct Place {
    int node;
    double share;
  };
  [[nodiscard]] Place place_of_zenith(double sun_zenith) const;

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i * zeniths_ + j);
  }

  int zeniths_;
  double first_;  // [radians]
  std::vector<Moments> nodes_;
  std::vector<Moments> relative_;  // logarithms of the first moments, and ratios to them
};

}  // namespace brume
