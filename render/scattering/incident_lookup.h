#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/math/spherical_harmonics.h"
#include "render/scattering/grid_levels.h"
#include "render/simd/surface_points.h"

namespace brume {

// Incident light at a point: R G B 0 per basis function.
using NodeRadiance = std::array<float, 4 * sh_size(grid_bands)>;

// What diffuse surfaces make of incident light, per band; of an environment's fifth band, which
// grids do not hold, as much as there is of its mean.
struct DiffuseFactors {
  std::array<float, 5> bands{};
  // Of the environment, R G B 0 per basis function; 0: none.
  std::array<float, 4 * (2 * 4 + 1)> fifth_band{};
  // What the grid's mean is divided by its own; 0: none.
  std::array<float, 4> per_mean{};
};

// The incident light of a SourceGrid with receivers at points of surfaces, clamped to the grid
// (Highway, single precision). If surfaces occlude its light, it is looked up so far before them
// that the nearest node is on their side, of nodes that they do not hide from the eye's side. Keeps
// a reference to the grid. Thread-safe.
class IncidentLookup {
 public:
  IncidentLookup(const SourceGrid& grid, const glm::dvec3& origin,
                 const NodeVisibility& visibility = {})
      : levels_(grid, origin, visibility) {}

  // light[k] = that at point k, which is relative to the origin.
  void incident(const SurfacePoints& points, std::span<NodeRadiance> light) const;
  // Radiance of diffuse surfaces of reflectance 1 at the points. Scalar counterpart:
  // diffuse_light().
  void diffuse(const SurfacePoints& points, const DiffuseFactors& factors,
               PointRadiance& radiance) const;

 private:
  GridLevels levels_;
};

}  // namespace brume
