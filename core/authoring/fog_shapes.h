#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// A volume to fill with Gaussians on a lattice, so close that their sum is even but at its rim.
struct FogShape {
  // An axis-aligned box, an ellipsoid, or fog that lies on the ground and thins upwards by e over
  // the height size.y.
  enum class Kind { box, sphere, height };
  Kind kind = Kind::box;
  glm::dvec3 center{0.0};  // of height fog: of its footprint, on the ground
  glm::dvec3 size{1.0};    // edges or diameters, > 0 [u]
  double density = 0.1;    // scattering coefficient within; of height fog at the ground; >= 0 [1/u]
  double spacing =
      0.2;  // of the lattice, > 0 [u], along y; the radius of the Gaussians is 0.8 of it
  double flatness = 1.0;  // spacing and radii along x and z over those along y, >= 1
  double jitter = 0.0;    // random offsets within a cell of the lattice, in [0, 1]
  std::uint64_t seed = 1;

  bool operator==(const FogShape&) const = default;
};

// How many cells the lattice has: at least as many as fill() returns Gaussians.
double cell_count(const FogShape& shape);

// The Gaussians of a shape, at most cell_count().
std::vector<Gaussian> fill(const FogShape& shape);

// The height of the ground below a point; nullopt: none there.
using FindGround = std::function<std::optional<double>(double x, double z)>;

// A layer of Gaussians on the ground within a footprint, one lattice cell thick; patchy by
// `jitter`. Flat ones lie along its slope. Cells without ground stay empty. Of the shape, size.y is
// the thickness of the layer.
std::vector<Gaussian> lay_on_ground(const FogShape& shape, const FindGround& find_ground);

// Fog that rises from a point, widens, bends with the wind and thins as it mixes with air.
struct FogColumn {
  glm::dvec3 foot{0.0};
  double height = 1.0;   // > 0 [u]
  double width = 0.1;    // at the foot; > 0 [u]
  double spread = 0.3;   // by which its radius grows, relative to the height risen
  glm::dvec3 lean{0.0};  // offset of its top [u]
  double density = 1.0;  // at the foot [1/u]
  std::size_t count = 60;
  double turbulence = 0.5;  // offsets from its axis, relative to its radius
  std::uint64_t seed = 1;

  bool operator==(const FogColumn&) const = default;
};
std::vector<Gaussian> rise(const FogColumn& column);

}  // namespace brume
