#pragma once

#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "brume/stage.h"
#include "core/scene/lights/point_lights.h"
#include "render/motion.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// The optical depth that the reference leaves out of a ray.
inline constexpr double reference_depth_error = 1e-8;
// The optical depth that paths leave out.
inline constexpr double path_depth_error = 1e-6;

// Decides, as the single place, what a frame computes and how. Made once a frame, before the scene
// is split into albedo groups, which share it. The backend gl moves it to the device (gl/gl_plan).
struct RenderPlan {
  // `shared`: transfer that others compute; null: the frame computes what is missing.
  RenderPlan(const Scene& scene, const Film& film, const Settings& requested,
             const TransferStore* shared = nullptr, const Motion& in_motion = {});

  Motion motion;
  Settings settings;  // as requested, without `auto_`, with light maps limited to memory
  // Those that are on and not black, as point lights: see core/scene/lights/point_lights.h.
  std::vector<PointLight> lights;
  std::vector<TransferRequest> transfers;  // without duplicates

  StageSet stages;  // whose times are in the statistics
  StageSet parts;   // of those, without times of their own
  std::vector<SkippedStage> skipped;
  std::vector<SkippedStage> on_cpu;  // although gl was requested

  // Whether a stage, or a part of one, runs.
  [[nodiscard]] bool runs(Stage stage) const { return stages.has(stage) || parts.has(stage); }

  // The stage that finds what the medium does to view rays, if there is one.
  [[nodiscard]] Stage medium_stage() const {
    return runs(Stage::airlight) ? Stage::airlight
           : runs(Stage::paths)  ? Stage::paths
                                 : Stage::transmittance;
  }
  [[nodiscard]] bool has_medium() const { return has_density; }

  bool has_density = false;  // of Gaussians or homogeneous
  bool has_mirrors = false;  // smooth surfaces show what is around them
  // Gaussians with an albedo of their own, or that shine; `paper` knows none.
  bool has_own_optics = false;
  // An environment with non-zero radiance: behind the scene, and lighting it.
  bool has_environment = false;
  // Environment light enters the medium; Stage::environment runs only if the method wants a grid.
  bool has_environment_in_medium = false;
  // A grid holds in-scattered light of the environment, or of more than one scattering.
  [[nodiscard]] bool has_source_function() const {
    return runs(Stage::environment) || runs(Stage::scattering);
  }
  // First hits are rasterized where float is precise enough, faster than rays unless triangles
  // outnumber pixels.
  bool rasterizes = false;
  // Surfaces with holes or panes, see Coverage; of panes view rays see what is behind them.
  bool has_holes = false;
  bool has_panes = false;
  bool has_copies = false;          // surfaces with copies
  bool has_visible_lights = false;  // see LightShapes
  // Surfaces take environment light from the grid instead of average optical depths.
  bool has_receivers = false;
  // Surfaces take all light from the grid but the point lights' unscattered.
  bool has_all_light_at_surfaces = false;
  // Surfaces that are not diffuse reflect light from all directions.
  bool has_indirect_light = false;
  // Some shaded surface has such a material.
  bool has_metallic_roughness = false;
  // The optical depths of point lights at surfaces: from the tables, or summed exactly. Neither:
  // zero.
  enum class SurfaceDepths { none, tables, exact };
  SurfaceDepths surface_depths = SurfaceDepths::none;
  // Occlusion of view rays from lights is found analytically, for the reference.
  bool has_exact_occlusion = false;
  // The precision of `paper`, and of exact sums at surfaces.
  Settings::Precision precision = Settings::Precision::simd_float;
  double depth_error = 0.0;  // see Settings
  double merge_error = 0.0;

  // Whether the transfer requested by a surface is used by any light.
  [[nodiscard]] bool needs_transfer(const Surface& surface) const;
};

// Whether smooth surfaces mirror what is around them in frames of the scene.
bool shows_mirrored_light(const Scene& scene, const Settings& settings);

// RenderPlan::transfers, of sliced frames without settings.
std::vector<TransferRequest> needed_transfers(const Scene& scene, const Settings& settings = {});

}  // namespace brume
