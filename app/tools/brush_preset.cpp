#include "app/tools/brush_preset.h"

#include <QCoreApplication>
#include <array>

namespace brume {

std::span<const BrushPreset> brush_presets() {
  const auto name = [](const char* text) { return QCoreApplication::translate("Brushes", text); };
  static const std::array presets = std::to_array<BrushPreset>({
      {.name = name("Soft mist"),
       .size = 0.12,
       .depth = 0.25,
       .jitter = 0.3,
       .smoothing = 15.0,
       .spacing = 0.7,
       .scatter = 1.2,
       .falloff = 0.9},
      {.name = name("Wisps"),
       .size = 0.03,
       .depth = 0.35,
       .jitter = 0.8,
       .smoothing = 25.0,
       .spacing = 0.6,
       .scatter = 1.8,
       .falloff = 0.7},
      {.name = name("Cloud puffs"),
       .size = 0.09,
       .depth = 0.9,
       .jitter = 0.6,
       .spacing = 0.6,
       .scatter = 0.9,
       .falloff = 0.4},
      {.name = name("Dense smoke"),
       .size = 0.06,
       .depth = 1.5,
       .jitter = 0.5,
       .spacing = 0.5,
       .scatter = 0.7,
       .falloff = 0.3},
      {.name = name("Fine line"),
       .size = 0.015,
       .depth = 0.8,
       .smoothing = 40.0,
       .spacing = 0.6,
       .scatter = 0.0},
      {.name = name("Glaze"), .size = 0.08, .depth = 0.5, .spacing = 0.8, .flow = 0.2},
      {.name = name("Light spray"), .sprays = true, .size = 0.04, .depth = 0.3, .jitter = 0.3},
      {.name = name("Steam jet"),
       .sprays = true,
       .size = 0.025,
       .depth = 0.25,
       .jitter = 0.6,
       .rate = 120.0,
       .speed = 0.5,
       .spread = 0.25,
       .wander = 0.15},
      {.name = name("Dust burst"),
       .sprays = true,
       .size = 0.05,
       .depth = 0.12,
       .jitter = 0.9,
       .rate = 200.0,
       .speed = 0.3,
       .spread = 1.5,
       .wander = 0.3},
  });
  return presets;
}

}  // namespace brume
