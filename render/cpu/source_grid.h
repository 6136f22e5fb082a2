#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "core/transport/optical_depth.h"
#include "render/cpu/arriving_light.h"
#include "render/cpu/box.h"
#include "render/cpu/sweep_kernels.h"
#include "render/distant_lights.h"
#include "render/job.h"
#include "render/settings.h"

namespace brume {

// The bands of the Henyey-Greenstein phase function that a SourceGrid keeps. What it has beyond
// them is a narrow peak; the bands of that are taken out of the others and left with it, as delta-M
// does (Wiscombe 1977): band l of the light around a point times g^l - p_l is that band of what is
// scattered there but for the peak, whose bands p_l are g^4 (sgn g)^l for l < 4, and g^l from there
// on.
class PhaseBands {
 public:
  static constexpr int most = grid_bands;

  // One band for isotropic scattering, else four.
  explicit PhaseBands(double anisotropy);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] std::span<const double> factors() const {
    return std::span(factors_).first(static_cast<std::size_t>(count_));
  }
  // All basis functions of the bands at a unit direction, each times its band's factor.
  [[nodiscard]] std::array<float, sh_size(most)> at(const glm::dvec3& w) const;
  // Those bands of the phase function itself, at the cosine of the angle that light turns by
  // [1/sr].
  [[nodiscard]] double phase(double cosine) const;

 private:
  int count_;
  std::array<double, most> factors_;
};

// So many parts of the map a SourceGrid keeps the transmittance of where scattering is not
// isotropic: of light that turns little, more than the first bands of the phase function matters.
inline constexpr int source_families = 16;

struct SourceLight {
  DistantLight light;
  int family = 0;      // the part of the map that it is of, < source_families
  double share = 1.0;  // of the light of that
};

// The source function of single scattering, without the scattering coefficient:
//   J(x, w) = integral over directions w' of p(w, w') L(w') exp(-T(x, w')),
// what a medium of Gaussians scatters at x towards an eye that looks along w, of light L from far
// away. Kept on a grid around the Gaussians as the first bands of spherical harmonics of the light
// that arrives and the mean transmittance towards parts of the map, and interpolated linearly. The
// transmittance towards each light is swept through the grid, so the cost is nodes x lights and
// depends little on the number of Gaussians.
//
// Where surfaces are lit, it also holds the light that arrives at each node itself, for them.
class SourceGrid {
 public:
  struct Receivers {
    Box box;  // around the surfaces
    ArrivalOptics optics;

    bool operator==(const Receivers&) const = default;
  };
  struct Content {
    int bands = 1;  // of J, <= grid_bands
    bool has_fog = false;
    std::optional<Receivers> receivers;
  };

  // A second, coarser grid reaches out 4 times as far where there is fog around the Gaussians, or
  // surfaces. In parallel; after a stop of the job the grid is of no use.
  SourceGrid(std::span<const GaussianTerm<double>> gaussians, std::span<const SourceLight> lights,
             const Content& content, const SourceGridSize& size, const Job& job);

  // What a SourceLookUp needs. A node holds, for each basis function, R G B 0; of J it also holds
  // the transmittance of each family, where there is more than one band.
  struct Level {
    glm::dvec3 first{0.0};  // where node 0 stands
    GridNodes nodes;
    std::vector<float> values;    // J
    std::vector<float> arriving;  // see arriving_light(); empty without receivers
  };
  // Floats of J in a node.
  static constexpr std::size_t node_size(int bands) {
    return 4 * sh_size(bands) + (bands > 1 ? source_families : 0);
  }
  // From fine to coarse: one or two.
  [[nodiscard]] std::span<const Level> levels() const { return levels_; }
  [[nodiscard]] int bands() const { return bands_; }
  // Whether the fine grid alone would do for receivers in this box.
  [[nodiscard]] bool holds(const Box& box) const;

 private:
  int bands_;
  Box core_;  // of the fine grid; empty without Gaussians
  std::vector<Level> levels_;
};

}  // namespace brume
