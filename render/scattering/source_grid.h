#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "core/math/spherical_harmonics.h"
#include "core/transport/optical_depth.h"
#include "render/geometry/box.h"
#include "render/geometry/fog_ball.h"
#include "render/geometry/medium_index.h"
#include "render/grid/grid_occlusion.h"
#include "render/grid/level_inflow.h"
#include "render/grid/ordinates.h"
#include "render/grid/sweep_kernels.h"
#include "render/lights/distant_lights.h"
#include "render/lights/emission_lights.h"
#include "render/scattering/incident_grid.h"
#include "render/scattering/lit_space.h"
#include "render/scattering/phase_bands.h"
#include "render/settings.h"
#include "render/util/job.h"

namespace brume {

// Number of clusters of directions for which a SourceGrid stores the mean transmittance if
// scattering is anisotropic: forward scattering depends on more than the first bands.
inline constexpr int source_clusters = 16;

struct SourceLight {
  DistantLight light;
  int cluster = 0;                // cluster index, < source_clusters
  double cluster_fraction = 1.0;  // fraction of the cluster's irradiance
};

// Source function of single scattering, without the scattering coefficient:
//   J(x, w) = integral over directions w' of p(w, w') L(w') exp(-T(x, w')),
// for distant light L. Stored on a grid as the first spherical-harmonics bands
// of the incident light and the mean transmittance per cluster of directions; trilinearly
// interpolated. The transmittance towards each light is swept through the grid: the cost is nodes x
// lights, nearly independent of the number of Gaussians.
//
// With receivers it also stores the incident light itself, for surfaces.
class SourceGrid {
 public:
  struct Receivers {
    Box box;  // bounds of the surfaces
    IncidentOptics optics;

    bool operator==(const Receivers&) const = default;
  };
  struct Content {
    int bands = 1;             // bands of J, <= grid_bands
    double fog_density = 0.0;  // homogeneous extinction [1/u]
    // Where it is. Endless: it attenuates distant lights evenly, and J leaves that out.
    FogBall fog_ball;
    LitSpace lit;
    std::optional<Receivers> receivers;
    LevelOcclusion* surfaces = nullptr;        // that occlude all light; null: none do
    bool keeps_transmitted = false;            // see Level
    const EmissionLights* emission = nullptr;  // null: none, and all albedos are the medium's
  };

  static constexpr std::size_t max_levels = 5;

  // Its levels are those of lay_out_levels(). In parallel; invalid after the job was stopped.
  SourceGrid(std::span<const GaussianTerm<double>> gaussians, std::span<const SourceLight> lights,
             const Content& content, const SourceGridSize& size, const Job& job);

  [[nodiscard]] Revision revision() const { return revision_; }
  // Of the distant lights' J.
  [[nodiscard]] Revision distant_revision() const { return distant_revision_; }
  // Light that is scattered already, for all levels: of one channel times `color`, or of three.
  struct Scattered {
    std::span<const NodeLight> levels;  // of bands() bands
    glm::vec3 color;
    std::span<const double> factors;  // of the bands
    double distant_scale;             // of the distant lights' J
  };
  // J is distant_scale times that of the distant lights, plus `scattered`; and as it was.
  void set_scattered(const Scattered& scattered, const Job& job);
  void remove_scattered();
  // Sets the light at the nodes that receivers get: of the distant lights, transmitted, and
  // `scattered`, whose factors do not count.
  void set_incident(const Scattered& scattered, const Job& job);
  // Data for SourceLookup. A node holds R G B 0 per basis function; J also has the transmittance
  // per cluster if there is more than one band.
  struct Level {
    glm::dvec3 first{0.0};  // position of node 0
    GridNodes nodes;
    std::vector<float> density;  // of the Gaussians, per node [1/u]
    std::vector<float> fog;      // share of what is around each node that has fog; empty: 1
    // Of what is around each node: its relative albedo, empty if it is 1 everywhere, and its
    // emission R, G, B, empty if there is none.
    std::vector<float> albedo;
    std::array<std::vector<float>, 3> emission;
    std::vector<float> values;  // J
    // J of distant light alone, if there is more.
    std::vector<float> distant;
    // R G B 0 per basis function; see incident_light() and set_incident(). Empty without receivers.
    std::vector<float> incident;
    // Of the distant lights, if kept: transmitted to the nodes, and then reflected by surfaces, see
    // reflected_light().
    NodeLight transmitted;
    std::vector<float> reflected;
    std::shared_ptr<const GridOcclusion> surfaces;  // null: none
    std::optional<LevelInflow> inflow;              // from the level around it; none: the coarsest
    // It has all surfaces within it: on the way to its border there are none.
    bool holds_surfaces = false;

    // Density at the nodes, with fog of that density [1/u].
    [[nodiscard]] std::vector<float> density_with_fog(double fog_density) const;
    // Whether it is a point light to the grid, which holds what a large one stands for.
    [[nodiscard]] bool is_point(const EmissionLights::Light& light) const;
  };
  // Floats per node of J.
  static constexpr std::size_t node_size(int bands) {
    return 4 * sh_size(bands) + (bands > 1 ? source_clusters : 0);
  }
  // At most max_levels, fine first.
  [[nodiscard]] std::span<const Level> levels() const { return levels_; }
  [[nodiscard]] int bands() const { return bands_; }
  [[nodiscard]] std::size_t bytes() const;  // memory
  // Whether the fine grid covers receivers in this box.
  [[nodiscard]] bool holds(const Box& box) const;

 private:
  Revision revision_ = new_revision();
  Revision distant_revision_ = revision_;
  int bands_;
  Box core_;  // bounds of the fine grid; empty without a medium
  std::vector<Level> levels_;
};

}  // namespace brume
