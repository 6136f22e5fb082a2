#pragma once

#include <QString>
#include <span>

namespace brume {

// A brush by name, independent of the size of a scene: lengths are relative to the distance of the
// view.
struct BrushPreset {
  QString name;
  bool sprays = false;     // an airbrush, else a paintbrush
  double size = 0.06;      // radius of a Gaussian
  double depth = 0.5;      // optical depth through its center: sqrt(pi) radius density
  double jitter = 0.0;     // as in core/authoring
  double smoothing = 0.0;  // [pixels]
  double stretch = 1.0;
  // A paintbrush has:
  double spacing = 1.0;
  double scatter = 0.5;
  double falloff = 0.0;
  double flow = 1.0;
  // An airbrush has:
  double rate = 60.0;  // [1/s]
  double speed = 0.2;  // [1/s]
  double spread = 0.7;
  double wander = 0.1;  // [1/s^2]

  bool operator==(const BrushPreset&) const = default;
};

// Those that come with the program; names are translated.
std::span<const BrushPreset> brush_presets();

}  // namespace brume
