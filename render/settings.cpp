#include "render/settings.h"

#include <algorithm>

#include "brume/scene.h"
#include "core/scene/lights/point_lights.h"

namespace brume {

const char* to_string(AirlightMethod method) {
  switch (method) {
    case AirlightMethod::auto_:
      return "auto";
    case AirlightMethod::paper:
      return "paper";
    case AirlightMethod::sliced:
      return "sliced";
    case AirlightMethod::reference:
      return "reference";
    case AirlightMethod::path:
      return "path";
  }
  return "";
}

const char* to_string(Scattering scattering) {
  return scattering == Scattering::single ? "single" : "multiple";
}

std::string airlight_name(const Settings& settings) {
  std::string name = to_string(settings.airlight);
  if (settings.airlight == AirlightMethod::paper) {
    if (settings.paper.at_mean) name += "+mean";
    if (settings.paper.conserve_energy) name += "+energy";
  }
  if (settings.airlight == AirlightMethod::sliced) name += ':' + std::to_string(settings.slices);
  if (settings.airlight == AirlightMethod::path) name += ':' + std::to_string(settings.paths);
  return name;
}

namespace {

constexpr OpticalDepthTableSize min_light_table{64, 32};
constexpr int min_shadow_cells = 256;

// The memory of one light: OpticalDepthTable's depths, ShadowMap's distances and ranges.
std::size_t light_map_bytes(const Settings& settings, bool shadows) {
  const auto directions = static_cast<std::size_t>(settings.optical_depth_table.directions);
  const auto radii = static_cast<std::size_t>(settings.optical_depth_table.radii);
  const auto cells = static_cast<std::size_t>(settings.shadow_cells);
  return directions * directions * radii * sizeof(std::uint16_t) +
         (shadows ? cells * cells * 3 * sizeof(float) : 0);
}

}  // namespace

Settings limit_light_map_memory(Settings settings, std::size_t lights, bool shadows) {
  const Settings wanted = settings;
  const auto shrink = [](int& value, int size, int min, int eighths) {
    value = std::max(std::min(size, min), size * eighths / 8);
  };
  for (int eighths = 7; eighths > 0; --eighths) {
    if (lights * light_map_bytes(settings, shadows) <= max_light_map_bytes) break;
    OpticalDepthTableSize& table = settings.optical_depth_table;
    shrink(table.directions, wanted.optical_depth_table.directions, min_light_table.directions,
           eighths);
    shrink(table.radii, wanted.optical_depth_table.radii, min_light_table.radii, eighths);
    shrink(settings.shadow_cells, wanted.shadow_cells, min_shadow_cells, eighths);
  }
  return settings;
}

int chosen_samples(const Scene& scene) {
  const auto is_visible = [](const Surface& surface) { return surface.visible; };
  const bool has_edges =
      std::ranges::any_of(scene.surfaces, is_visible) || std::ranges::any_of(scene.lights, is_seen);
  return has_edges ? edge_samples : 1;
}

Settings without_auto(Settings settings) {
  if (settings.airlight == AirlightMethod::auto_) settings.airlight = AirlightMethod::sliced;
  return settings;
}

Settings sliced_settings(Settings settings, int slices) {
  settings.airlight = AirlightMethod::sliced;
  settings.slices = slices;
  settings.optical_depth_table = slices < 12   ? min_light_table
                                 : slices < 24 ? OpticalDepthTableSize{96, 48}
                                 : slices < 48 ? OpticalDepthTableSize{128, 64}
                                               : OpticalDepthTableSize{256, 128};
  settings.upsampling_tolerance = slices < 16   ? 0.03
                                  : slices < 32 ? 0.01
                                  : slices < 64 ? 0.005
                                                : 0.002;
  settings.depth_error = slices < 24 ? 3e-3 : slices < 48 ? 1e-3 : 1e-4;
  settings.merge_error = slices < 12 ? 0.02 : slices < 24 ? 0.012 : slices < 32 ? 0.005 : 0.0;
  settings.shadow_cells = std::clamp(16 * slices, min_shadow_cells, max_shadow_cells);
  settings.source_grid = slices < 8    ? SourceGridSize{20'000, 64}
                         : slices < 24 ? SourceGridSize{60'000, 64}
                         : slices < 48 ? SourceGridSize{80'000, 96}
                                       : SourceGridSize{120'000, 128};
  return settings;
}

}  // namespace brume
