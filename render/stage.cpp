#include "brume/stage.h"

#include <array>
#include <string_view>
#include <utility>

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

namespace {

// They are in the order of the enumeration; # is the count.
constexpr auto reason_texts = std::to_array<std::pair<Reason, std::string_view>>({
    {Reason::no_surfaces, "the scene has no surfaces"},
    {Reason::no_light, "nothing emits light"},
    {Reason::no_medium, "the medium is empty"},
    {Reason::no_gaussians, "the medium has no Gaussians"},
    {Reason::no_environment, "the scene has none"},
    {Reason::black_environment, "its intensity is 0"},
    {Reason::no_homogeneous_density, "the medium's homogeneous density is 0"},
    {Reason::no_noise, "its amplitude is 0"},
    {Reason::thin_medium, "the medium is too thin for more than one scattering"},
    {Reason::no_transfer_requested, "no surface requests it"},
    {Reason::only_direct_light, "all light is direct"},
    {Reason::transfer_refused, "metallic-roughness materials and surfaces with copies have none"},
    {Reason::transfer_pending, "it is not computed yet"},
    {Reason::lights_off, "switched off: #"},
    {Reason::black_lights, "# lights of intensity 0"},
    {Reason::lights_beyond_paper,
     "the paper's method has isotropic point lights only; left out: #"},
    {Reason::optics_beyond_paper,
     "the paper's method has one albedo and no emission; left out: those of Gaussians"},
    {Reason::panes_beyond_reference, "panes shadow the reference's fog as opaque surfaces do"},
    {Reason::part_of_paths, "paths carry its light"},
    {Reason::part_of_all_orders, "it is part of all orders of scattering"},
    {Reason::double_precision, "double precision was requested"},
    {Reason::reference_on_cpu, "airlight reference runs only on the CPU"},
    {Reason::path_on_cpu, "airlight path runs only on the CPU"},
    {Reason::mirrors_on_cpu, "rays that smooth surfaces mirror are traced on the CPU"},
    {Reason::coverage_on_cpu, "surfaces with holes, and panes, are rendered on the CPU"},
    {Reason::copies_on_cpu, "surfaces with copies are rendered on the CPU"},
    {Reason::visible_lights_on_cpu, "lights that are visible are rendered on the CPU"},
    {Reason::clipped_on_cpu, "walls before the view are left out on the CPU"},
    {Reason::too_many_slices, "more slices than fit into a work group"},
    {Reason::too_many_radii, "optical-depth tables have more radii than fit into a work group"},
    {Reason::center_depths_on_cpu, "optical depths at the centres are computed on the CPU"},
    {Reason::vertex_light_on_cpu, "vertex lighting is computed on the CPU"},
    {Reason::environment_on_cpu, "its grid is computed on the CPU"},
    {Reason::average_depth_on_cpu, "the grids around surfaces are computed on the CPU"},
});

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < reason_texts.size(); ++i) {
    if (reason_texts[i].first != static_cast<Reason>(i)) return false;
  }
  return reason_texts.back().first == Reason::average_depth_on_cpu;
}
static_assert(is_in_order());

}  // namespace

std::string to_string(Reason reason, std::size_t count) {
  std::string text(reason_texts[static_cast<std::size_t>(reason)].second);
  const std::size_t place = text.find('#');
  return place == std::string::npos ? text : text.replace(place, 1, std::to_string(count));
}

}  // namespace brume
