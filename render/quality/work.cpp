#include "render/quality/work.h"

#include <algorithm>

namespace brume {

double picture_work(const Frame& frame, const Settings& settings) {
  constexpr double per_frame = 3e7;  // what is prepared, light tables
  constexpr double per_pixel = 150.0;
  constexpr double per_slice = 60.0;     // of a ray
  constexpr double per_sample = 600.0;   // of a pixel at an edge
  constexpr double per_grid_byte = 3.0;  // of a sweep
  const FrameStatistics& statistics = frame.statistics;
  const int sweeps = statistics.scattering ? statistics.scattering->sweeps : 1;
  return per_frame + per_pixel * static_cast<double>(frame.depth.size()) +
         per_slice * static_cast<double>(statistics.exact_pixels) * settings.slices +
         per_sample * static_cast<double>(statistics.sampled_pixels) * settings.samples +
         per_grid_byte * static_cast<double>(statistics.grid_bytes) * sweeps;
}

double path_work(std::size_t gaussians, std::uint64_t draws) {
  constexpr double first_draws = 30.0;
  // Of more than these most are far away, and skipped in groups.
  constexpr double many_gaussians = 300.0;
  const double share = std::min(static_cast<double>(gaussians) / many_gaussians, 1.0);
  const double first = std::min(static_cast<double>(draws), first_draws);
  const double more = static_cast<double>(draws) - first;
  return (250.0 + 750.0 * share) * first + (50.0 + 120.0 * share) * more;
}

double integral_work(std::size_t gaussians, std::size_t lights, bool has_environment) {
  const double per_light = 1e5 + 30.0 * static_cast<double>(gaussians);
  const double environment = 1e6 + 1e5 * static_cast<double>(gaussians);
  return per_light * static_cast<double>(lights) + (has_environment ? environment : 0.0);
}

}  // namespace brume
