#include "render/grid/node_layout.h"

#include <cmath>
#include <glm/common.hpp>

namespace brume {
namespace {

// Spacings of an octave. The fewer there are, the seldomer a medium that grows changes its own, and
// the more nodes of the budget stay unused.
constexpr double spacings_per_octave = 32.0;

// The spacing after so many steps, exactly twice that of an octave of steps before. A float, to be
// identical wherever it is used.
float spacing_after(int steps) {
  return static_cast<float>(std::exp2(steps / spacings_per_octave));
}

// The most layers that cover so many cells, wherever these begin.
glm::dvec3 max_layers(const glm::dvec3& cells) {
  return glm::ceil(cells) + 1.0;
}

float smallest_spacing(const glm::dvec3& extent, double min_spacing, int max_nodes) {
  const double least = std::max(min_spacing, std::cbrt(extent.x * extent.y * extent.z / max_nodes));
  constexpr double rounding = 1e-6;
  int steps = static_cast<int>(std::ceil(spacings_per_octave * std::log2(least) - rounding));
  for (;; ++steps) {
    const glm::dvec3 layers = max_layers(extent / static_cast<double>(spacing_after(steps)));
    if (layers.x * layers.y * layers.z <= static_cast<double>(max_nodes)) {
      return spacing_after(steps);
    }
  }
}

}  // namespace

NodeLayout lay_out(const glm::dvec3& low, const glm::dvec3& high, double min_spacing, int max_nodes,
                   const AxisPlanes& planes) {
  NodeLayout layout;
  layout.nodes.spacing = smallest_spacing(high - low, min_spacing, max_nodes);
  const double spacing = static_cast<double>(layout.nodes.spacing);
  for (int k = 0; k < 3; ++k) {
    const double place = 0.5 * spacing;
    const double shift = planes.shift(k, low[k] - spacing, high[k] + spacing, place, spacing);
    const double first = std::floor((low[k] - place - shift) / spacing);
    const double last = std::ceil((high[k] - place - shift) / spacing);
    layout.first[k] = place + shift + first * spacing;
    layout.nodes.count[k] = static_cast<int>(last - first) + 1;
  }
  return layout;
}

}  // namespace brume
