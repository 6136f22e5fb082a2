#pragma once

#include <functional>
#include <vector>

#include "app/tools/option_widgets.h"

namespace brume {

class FogBrushTool;

struct StrokeNumber {
  NumberOption option;
  QString tip;
  std::function<double()> get;
  std::function<void(double)> set;
};

// A button whose panel has the numbers, and how strokes are mirrored, snap and use a pen.
// `prefix` of object names.
void add_stroke_options_button(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix,
                               const std::vector<StrokeNumber>& numbers);

// A button whose menu has the presets of a tool: those of the program and the user's own, which it
// also saves and deletes.
void add_preset_button(QHBoxLayout& row, FogBrushTool& tool, const QString& prefix);

}  // namespace brume
