#include "brume/stage.h"

#include <array>

namespace brume {

const char* to_string(Stage stage) {
  // In the order of the enumeration.
  static constexpr std::array names{
      "transfer",      "prepare",     "visibility", "environment",   "light_depth",
      "eye_depth",     "light_table", "scattering", "shadow_map",    "airlight",
      "transmittance", "paths",       "surfaces",   "composite",     "samples",
      "homogeneous",   "noise",       "upsample",   "average_depth", "surface_scattering",
      "vertex_light",  "lists",       "display",    "submit",        "wait",
      "read_depth",    "read_back",   "lights",     "frame"};
  static_assert(names.size() == stage_count);
  return names[static_cast<std::size_t>(stage)];
}

std::string to_string(const StageSet& stages) {
  std::string names;
  for (std::size_t i = 0; i < stage_count; ++i) {
    const auto stage = static_cast<Stage>(i);
    if (!stages.has(stage)) continue;
    if (!names.empty()) names += ' ';
    names += to_string(stage);
  }
  return names;
}

std::string to_string(Reason reason, std::size_t count) {
  switch (reason) {
    case Reason::no_surfaces:
      return "the scene has no surfaces";
    case Reason::no_light:
      return "nothing emits light";
    case Reason::no_medium:
      return "the medium is empty";
    case Reason::no_gaussians:
      return "the medium has no Gaussians";
    case Reason::no_environment:
      return "the scene has none";
    case Reason::black_environment:
      return "its intensity is 0";
    case Reason::no_homogeneous_density:
      return "the medium's homogeneous density is 0";
    case Reason::thin_medium:
      return "the medium is too thin for more than one scattering";
    case Reason::no_noise:
      return "its amplitude is 0";
    case Reason::no_transfer_requested:
      return "no surface requests it";
    case Reason::only_direct_light:
      return "all light is direct";
    case Reason::transfer_refused:
      return "metallic-roughness materials and surfaces with copies have none";
    case Reason::transfer_pending:
      return "it is not computed yet";
    case Reason::lights_off:
      return "switched off: " + std::to_string(count);
    case Reason::black_lights:
      return std::to_string(count) + " lights of intensity 0";
    case Reason::lights_beyond_paper:
      return "the paper's method has isotropic point lights only; left out: " +
             std::to_string(count);
    case Reason::optics_beyond_paper:
      return "the paper's method has one albedo and no emission; left out: those of Gaussians";
    case Reason::panes_beyond_reference:
      return "panes shadow the reference's fog as opaque surfaces do";
    case Reason::part_of_paths:
      return "paths carry its light";
    case Reason::part_of_all_orders:
      return "it is part of all orders of scattering";
    case Reason::double_precision:
      return "double precision was requested";
    case Reason::march_on_cpu:
      return "airlight march runs only on the CPU";
    case Reason::reference_on_cpu:
      return "airlight reference runs only on the CPU";
    case Reason::mirrors_on_cpu:
      return "rays that smooth surfaces mirror are traced on the CPU";
    case Reason::path_on_cpu:
      return "airlight path runs only on the CPU";
    case Reason::coverage_on_cpu:
      return "surfaces with holes, and panes, are rendered on the CPU";
    case Reason::copies_on_cpu:
      return "surfaces with copies are rendered on the CPU";
    case Reason::visible_lights_on_cpu:
      return "lights that are visible are rendered on the CPU";
    case Reason::too_many_slices:
      return "more slices than fit into a work group";
    case Reason::too_many_radii:
      return "optical-depth tables have more radii than fit into a work group";
    case Reason::center_depths_on_cpu:
      return "optical depths at the centres are computed on the CPU";
    case Reason::vertex_light_on_cpu:
      return "vertex lighting is computed on the CPU";
    case Reason::environment_on_cpu:
      return "its grid is computed on the CPU";
    case Reason::average_depth_on_cpu:
      return "the grids around surfaces are computed on the CPU";
  }
  return {};
}

}  // namespace brume
