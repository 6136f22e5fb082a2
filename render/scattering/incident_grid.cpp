#include "render/scattering/incident_grid.h"

#include <algorithm>
#include <cassert>

namespace brume {
namespace {

// Directions that scattered light comes from: a rule that is exact for the square of four bands,
// and one more for what lies beyond them.
constexpr int scattered_degree = 9;

}  // namespace

std::vector<float> incident_light(const GridNodes& nodes, std::span<const float> density,
                                  const NodeLight& unscattered, const IncidentOptics& optics,
                                  const Job& job) {
  assert(unscattered.bands == grid_bands && unscattered.channels == 3);
  const std::vector<double> phase =
      phase_bands(optics.anisotropy, optics.anisotropy == 0.0 ? 1 : grid_bands);
  NodeLight scattered(grid_bands, 3, nodes.size());
  scatter_once({nodes, density, optics.fog_density}, unscattered, {}, phase, scattered_degree,
               scattered, job);
  const auto scale = static_cast<float>(optics.scattered);
  const std::size_t functions = unscattered.functions();
  std::vector<float> values(4 * functions * nodes.size(), 0.0f);
  job.parallel_for((nodes.size() + node_block - 1) / node_block, [&](std::size_t b) {
    const std::size_t end = std::min((b + 1) * node_block, nodes.size());
    for (int l = 0; l < grid_bands; ++l) {
      const auto transmittance =
          static_cast<float>(optics.through_fog[static_cast<std::size_t>(l)]);
      for (int m = -l; m <= l; ++m) {
        const std::size_t f = sh_index(l, m);
        for (std::size_t c = 0; c < 3; ++c) {
          const float* input = unscattered.row(c, f).data();
          const float* outgoing = scattered.row(c, f).data();
          for (std::size_t i = b * node_block; i < end; ++i) {
            values[4 * (functions * i + f) + c] = transmittance * input[i] + scale * outgoing[i];
          }
        }
      }
    }
  });
  return values;
}

}  // namespace brume
