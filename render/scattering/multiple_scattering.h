#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "render/geometry/point_source.h"
#include "render/grid/scattering_solver.h"
#include "render/lights/emission_lights.h"
#include "render/motion.h"
#include "render/scattering/incident_point_light.h"
#include "render/scattering/source_grid.h"
#include "render/util/job.h"

namespace brume {

// The light in a medium that was scattered at least once, of all orders, at the nodes of a
// SourceGrid. What the forward lobe beyond the grid's bands scatters counts as not scattered. Kept
// between frames; solved anew when something that it depends on has changed, if asked for from the
// last solution on.
class MultipleScattering {
 public:
  struct Light : PointSource {
    const OpticalDepthTable* table = nullptr;  // null: no Gaussians
  };
  struct Input {
    // Densities, and the environment's light if any, in the medium of the truncated extinction; see
    // TruncatedScattering.
    const SourceGrid& grid;
    double environment_scale;  // of the light in the grid; 0: none
    std::span<const Light> lights;
    std::span<const EmissionLights::Light> emission;
    double albedo;
    double anisotropy;
    double fog_density;  // [1/u]
    bool fog_is_endless;
    const RayCaster* surfaces;  // null: none
    Revision surfaces_revision;
    ScatteringLimits limits;
    Motion motion;
    bool through_windows;  // light comes from few directions
  };
  // False, and empty, if the job was stopped.
  bool update(const Input& input, const Job& job);
  void clear();

  // The results of the last update(). Light for each level of the grid, with bands() bands; of one
  // channel times color(), or of three.
  [[nodiscard]] Revision revision() const { return revision_; }
  [[nodiscard]] std::span<const NodeLight> levels() const { return levels_; }
  [[nodiscard]] const glm::vec3& color() const { return color_; }
  // Per level, what surfaces send of all orders, in as many channels, see reflected_light(); empty
  // if the medium has no forward lobe.
  [[nodiscard]] std::span<const std::vector<float>> reflected() const { return reflected_; }
  // Of the finest level.
  [[nodiscard]] const Convergence& convergence() const { return convergence_; }
  [[nodiscard]] std::size_t bytes() const;  // memory

 private:
  // What the solution depends on.
  struct LightKey {
    glm::dvec3 position{0.0};
    glm::dvec3 intensity{0.0};
    Revision table = 0;
    LightFalloff falloff;
    FogBall fog;

    bool operator==(const LightKey&) const = default;
  };
  struct Key {
    Revision grid = 0;
    double environment_scale = 0.0;
    std::vector<LightKey> lights;
    double albedo = 0.0, anisotropy = 0.0, fog_density = 0.0;
    bool fog_is_endless = false;
    Revision surfaces = 0;
    ScatteringLimits limits;
    bool warm_start = false;
    bool through_windows = false;

    bool operator==(const Key&) const = default;
    [[nodiscard]] bool is_but_for_tables(const Key& other) const;
  };
  // A level's last solution and where it lies.
  struct Solution {
    glm::dvec3 first{0.0};
    GridNodes nodes;
    NodeLight scattered;  // without what comes from the coarser level
  };
  [[nodiscard]] NodeLight first_guess(std::size_t k, const SourceGrid::Level& level, int bands,
                                      std::size_t channels) const;

  Key key_;
  Revision revision_ = 0;
  glm::vec3 color_{1.0f};
  std::vector<NodeLight> levels_;
  std::vector<std::vector<float>> reflected_;
  std::vector<std::optional<Solution>> solutions_;  // per level
  Convergence convergence_;
};

}  // namespace brume
