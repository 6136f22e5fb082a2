#include "render/settings.h"

#include <algorithm>

namespace brume {

const char* to_string(AirlightMethod method) {
  switch (method) {
    case AirlightMethod::paper:
      return "paper";
    case AirlightMethod::sliced:
      return "sliced";
    case AirlightMethod::march:
      return "march";
    case AirlightMethod::reference:
      return "reference";
  }
  return "";
}

std::string airlight_name(const Settings& settings) {
  std::string name = to_string(settings.airlight);
  if (settings.airlight == AirlightMethod::paper) {
    if (settings.paper.at_mean) name += "+mean";
    if (settings.paper.conserve_energy) name += "+energy";
  }
  if (settings.airlight == AirlightMethod::march)
    name += ':' + std::to_string(settings.march_steps);
  return name;
}

Settings sliced_settings(Settings settings, int slices) {
  settings.airlight = AirlightMethod::sliced;
  settings.slices = slices;
  settings.light_table = slices < 12   ? LightTableSize{64, 32}
                         : slices < 24 ? LightTableSize{96, 48}
                         : slices < 48 ? LightTableSize{128, 64}
                                       : LightTableSize{256, 128};
  settings.upsampling_tolerance = slices < 16   ? 0.03
                                  : slices < 32 ? 0.01
                                  : slices < 64 ? 0.005
                                                : 0.002;
  settings.depth_error = slices < 24 ? 3e-3 : slices < 48 ? 1e-3 : 1e-4;
  settings.shadow_cells = std::clamp(16 * slices, 256, 1024);
  settings.source_grid = slices < 8    ? SourceGridSize{20'000, 64}
                         : slices < 24 ? SourceGridSize{60'000, 64}
                         : slices < 48 ? SourceGridSize{80'000, 96}
                                       : SourceGridSize{120'000, 128};
  return settings;
}

}  // namespace brume
