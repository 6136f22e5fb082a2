#include "brume/stage.h"

namespace brume {

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::transfer:
      return "transfer";
    case Stage::prepare:
      return "prepare";
    case Stage::visibility:
      return "visibility";
    case Stage::environment:
      return "environment";
    case Stage::light_depth:
      return "light_depth";
    case Stage::eye_depth:
      return "eye_depth";
    case Stage::light_table:
      return "light_table";
    case Stage::scattering:
      return "scattering";
    case Stage::shadow_map:
      return "shadow_map";
    case Stage::airlight:
      return "airlight";
    case Stage::transmittance:
      return "transmittance";
    case Stage::paths:
      return "paths";
    case Stage::surfaces:
      return "surfaces";
    case Stage::composite:
      return "composite";
    case Stage::samples:
      return "samples";
    case Stage::homogeneous:
      return "homogeneous";
    case Stage::noise:
      return "noise";
    case Stage::upsample:
      return "upsample";
    case Stage::average_depth:
      return "average_depth";
    case Stage::surface_scattering:
      return "surface_scattering";
    case Stage::vertex_light:
      return "vertex_light";
    case Stage::lists:
      return "lists";
    case Stage::display:
      return "display";
    case Stage::submit:
      return "submit";
    case Stage::wait:
      return "wait";
    case Stage::read_depth:
      return "read_depth";
    case Stage::read_back:
      return "read_back";
    case Stage::lights:
      return "lights";
    case Stage::frame:
      return "frame";
  }
  return "";
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
    case Reason::transfer_of_metallic_roughness:
      return "metallic-roughness materials have none";
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
    case Reason::path_on_cpu:
      return "airlight path runs only on the CPU";
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
