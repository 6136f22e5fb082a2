#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/math/spherical_harmonics.h"
#include "render/grid/grid_occlusion.h"
#include "render/grid/level_inflow.h"
#include "render/grid/sweep_kernels.h"
#include "render/util/job.h"

namespace brume {

// Number of spherical-harmonics bands stored per grid node.
inline constexpr int grid_bands = 4;

// Radiance at the nodes of a grid by the direction that it comes from, as spherical harmonics: a
// row of `stride` floats, of which the first are the nodes, for each channel and basis function.
struct NodeLight {
  int bands = 0;
  std::size_t channels = 0;
  std::size_t stride = 0;
  std::vector<float> values;  // channel after channel, in each row after row

  NodeLight() = default;
  NodeLight(int bands_, std::size_t channels_, std::size_t nodes);  // zero

  [[nodiscard]] std::size_t functions() const { return sh_size(bands); }
  [[nodiscard]] std::span<float> row(std::size_t channel, std::size_t function) {
    return std::span(values).subspan((channel * functions() + function) * stride, stride);
  }
  [[nodiscard]] std::span<const float> row(std::size_t channel, std::size_t function) const {
    return std::span(values).subspan((channel * functions() + function) * stride, stride);
  }
};

// Homogeneous fog without end around a grid, which holds all that shines. As far as the grid's
// border its light diffuses: the fluence falls with the distance r from the lights as exp(-decay r)
// / r.
struct EndlessFog {
  double transport_extinction = 1.0;  // [1/u]
  double decay = 0.0;                 // [1/u]; 0: nothing is absorbed
  double albedo = 1.0;                // as if scattering were isotropic
  glm::dvec3 lights{0.0};             // their middle, from the first node [u]

  EndlessFog() = default;
  // `density` is the extinction [1/u].
  EndlessFog(double density, double scattering_albedo, double anisotropy,
             const glm::dvec3& middle_of_lights);
};

// A medium on a grid.
struct GridMedium {
  GridNodes nodes;
  std::span<const float> density;           // that scatters and attenuates, per node [1/u]
  double fog = 0.0;                         // that only attenuates [1/u]
  bool continues = false;                   // beyond the grid, which other levels hold; else empty
  const GridOcclusion* surfaces = nullptr;  // between the nodes; null: none
  std::span<const float> albedo{};          // factor of what each node scatters; empty: 1
  bool is_fog_alone = false;                // without Gaussians
  std::optional<EndlessFog> beyond{};       // sends back a part of the light that leaves the grid
};

// A level around finer ones, and the light in it.
struct OuterLevel {
  GridMedium medium;
  NodeLight incident;
  std::vector<float> reflected;  // see reflected_light()
  const LevelInflow* inflow;     // at the border of the next finer level
};

// Bands of the Henyey-Greenstein phase function, from 0 on: g^l.
std::vector<double> phase_bands(double anisotropy, int count);
// The fraction of light that counts as scattered in the forward lobe of that phase function, beyond
// `count` bands. Delta-M truncation takes the first of those bands, g^count, for all; but what is
// then left in four bands scatters too much to the side and back: in a cloud of optical depth 10
// and g = 0.85, 2% in the mean. In [0, 1); 0 for g <= 0.
double forward_lobe(double anisotropy, int count);

// Nodes per block of a parallel sum.
inline constexpr std::size_t node_block = 1024;

// Radiance of the surfaces that hide neighbours from nodes, lit by the light at the nodes, which
// has at least 3 bands: per channel and GridOcclusion::surfels().
std::vector<float> reflected_light(const GridOcclusion& surfaces, const NodeLight& incident);

// The light that arrives at the nodes after `medium` has scattered the light `incident` once more,
// with an albedo of 1, and surfaces have sent the radiance `reflected`, see reflected_light(): one
// sweep for each direction of a quadrature rule that is exact for spherical harmonics up to
// `degree`. Band l of the phase function is phase[l], at most incident.bands of them. Sets
// `scattered`, whose bands are its own; the rows may not overlap. Independent of the number of
// threads. Invalid after the job was stopped.
void scatter_once(const GridMedium& medium, const NodeLight& incident,
                  std::span<const float> reflected, std::span<const double> phase, int degree,
                  NodeLight& scattered, const Job& job);

// The same light at the nodes of a grid within other levels, the finest of them first: what arrives
// at its border from them and goes on into it, in as many bands as theirs.
NodeLight scatter_into(const GridMedium& medium, std::span<const OuterLevel> outer,
                       std::span<const double> phase, int degree, const Job& job);

}  // namespace brume
