#pragma once

#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "brume/export.h"

namespace brume {

// The stages of a frame, in the order in which they run on the CPU.
enum class Stage {
  transfer,     // precomputed radiance transfer
  prepare,      // acceleration structures and shading data of the scene
  visibility,   // first hits of the view rays
  environment,  // grid of environment light in the medium
  light_depth,  // `paper`: optical depths from the lights to Gaussian centers
  eye_depth,    // `paper`: the same from the eye
  light_table,  // `sliced`: optical depth tables of the lights
  scattering,   // `sliced`: light scattered more than once
  shadow_map,   // `sliced`: of the lights, in the medium
  airlight,
  transmittance,  // in place of airlight where nothing emits light
  paths,          // `path`: airlight, transmittance and surfaces
  surfaces,       // their shading
  composite,
  samples,  // more of them of pixels that need it
  // Parts of the stages above. OpenGL takes time for some of them.
  homogeneous,         // fog
  noise,               // of the Gaussians
  upsample,            // of airlight
  average_depth,       // `paper`: grids of average optical depths around surfaces
  surface_scattering,  // light that the medium scatters onto surfaces
  vertex_light,        // vertex lighting of surfaces with radiance transfer
  // Stages that only OpenGL has:
  lists,  // tile binning
  display,
  submit,
  wait,
  read_depth,
  read_back,
  // Stages that only reports have:
  lights,  // each alone
  frame,   // all stages
};
inline constexpr std::size_t stage_count = static_cast<std::size_t>(Stage::frame) + 1;

// The name in statistics, which other programs read.
BRUME_EXPORT const char* to_string(Stage stage);

class StageSet {
 public:
  StageSet() = default;
  StageSet(std::initializer_list<Stage> stages) {
    for (const Stage stage : stages) add(stage);
  }
  [[nodiscard]] bool has(Stage stage) const { return bits_[static_cast<std::size_t>(stage)]; }
  [[nodiscard]] bool empty() const { return bits_.none(); }
  void add(Stage stage, bool is_needed = true) {
    if (is_needed) bits_.set(static_cast<std::size_t>(stage));
  }
  void remove(Stage stage) { bits_.reset(static_cast<std::size_t>(stage)); }

  bool operator==(const StageSet&) const = default;

 private:
  std::bitset<stage_count> bits_;
};

// The names, separated by spaces.
BRUME_EXPORT std::string to_string(const StageSet& stages);

// Why a stage is skipped, or runs on the CPU.
enum class Reason {
  // Skipped.
  no_surfaces,
  no_light,
  no_medium,
  no_gaussians,
  no_environment,
  black_environment,
  no_homogeneous_density,
  no_noise,
  thin_medium,
  no_transfer_requested,
  only_direct_light,
  transfer_refused,
  transfer_pending,
  lights_off,
  black_lights,
  lights_beyond_paper,
  optics_beyond_paper,
  panes_beyond_reference,
  part_of_paths,
  part_of_all_orders,
  // On the CPU.
  double_precision,
  reference_on_cpu,
  path_on_cpu,
  mirrors_on_cpu,
  coverage_on_cpu,
  copies_on_cpu,
  visible_lights_on_cpu,
  clipped_on_cpu,
  too_many_slices,
  too_many_radii,
  center_depths_on_cpu,
  vertex_light_on_cpu,
  environment_on_cpu,
  average_depth_on_cpu,
};

// The reason in words. `count`: of lights, where it is about some.
BRUME_EXPORT std::string to_string(Reason reason, std::size_t count = 0);

}  // namespace brume
