#include "core/scene/atmosphere/radiance_moments.h"

#include <algorithm>
#include <cmath>

namespace brume {
namespace {

// Rays that leave the ground level reach the top of the atmosphere 10 degrees away.
constexpr double zenith_range = 14.0 * std::numbers::pi / 180.0;  // to both sides [radians]

// Light changes fast with the zenith angle where the sun is low.
constexpr double low_sun = 65.0 * std::numbers::pi / 180.0;

RadianceMoments::Place place_among(double position, int nodes) {
  const double inside = std::clamp(position, 0.0, nodes - 1.0);
  const int node = std::min(static_cast<int>(inside), nodes - 2);
  return {node, inside - node};
}

}  // namespace

std::array<double, moment_count> even_harmonics(const SkyDirection& direction) {
  const auto& [z, x] = direction;
  return {0.28209479177387814,        0.4886025119029199 * z,
          0.4886025119029199 * x,     0.31539156525252005 * (3.0 * z * z - 1.0),
          1.0925484305920792 * x * z, 0.5462742152960396 * (2.0 * x * x + z * z - 1.0)};
}

RadianceMoments::RadianceMoments(double sun_zenith)
    : zeniths_(sun_zenith < low_sun ? 7 : 15),
      first_(std::max(sun_zenith - zenith_range, 0.0)),
      nodes_(static_cast<std::size_t>(altitudes * zeniths_)),
      relative_(nodes_.size()) {}

void RadianceMoments::set(int i, int j, const Moments& moments) {
  nodes_[index(i, j)] = moments;
  Moments& relative = relative_[index(i, j)];
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    const double mean = std::max(moments[0][k], 1e-300);
    relative[0][k] = std::log(mean);
    for (std::size_t m = 1; m < moment_count; ++m) relative[m][k] = moments[m][k] / mean;
  }
}

double RadianceMoments::altitude(int i) {
  const double share = 1.0 * i / (altitudes - 1);
  return atmosphere_height * share * share * share;
}

double RadianceMoments::sun_zenith(int j) const {
  return first_ + 2.0 * zenith_range / (zeniths_ - 1) * j;
}

RadianceMoments::Place RadianceMoments::place_of_zenith(double sun_zenith) const {
  return place_among((sun_zenith - first_) / (2.0 * zenith_range) * (zeniths_ - 1), zeniths_);
}

Moments RadianceMoments::at(double altitude, double sun_zenith) const {
  const double share = std::clamp(altitude / atmosphere_height, 0.0, 1.0);
  const Place row = place_among((altitudes - 1) * std::cbrt(share), altitudes);
  const Place column = place_of_zenith(sun_zenith);
  const Moments* const below = &relative_[index(row.node, column.node)];
  const Moments* const above = below + zeniths_;
  const std::array corners{below, below + 1, above, above + 1};
  const std::array weights{(1.0 - row.share) * (1.0 - column.share),
                           (1.0 - row.share) * column.share, row.share * (1.0 - column.share),
                           row.share * column.share};
  Moments moments;
  for (std::size_t m = 0; m < moment_count; ++m) {
    for (std::size_t k = 0; k < spectrum_size; ++k) {
      moments[m][k] = weights[0] * (*corners[0])[m][k] + weights[1] * (*corners[1])[m][k] +
                      weights[2] * (*corners[2])[m][k] + weights[3] * (*corners[3])[m][k];
    }
  }
  for (std::size_t k = 0; k < spectrum_size; ++k) {
    moments[0][k] = std::exp(moments[0][k]);
    for (std::size_t m = 1; m < moment_count; ++m) moments[m][k] *= moments[0][k];
  }
  return moments;
}

}  // namespace brume
