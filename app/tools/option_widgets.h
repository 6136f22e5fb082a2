#pragma once

#include <functional>

#include "app/view/paint_point.h"
#include "app/view/tool.h"
#include "app/widgets/value_field.h"
#include "core/number_domain.h"

namespace brume {

// The radius of a circle around the mouse, in pixels.
inline constexpr NumberDomain screen_radius_domain{1.0, 2000.0,
                                                   "a number of pixels from 1 to 2000"};

// Option widgets of a tool: show `get` whenever the tool's options change, and pass input to `set`.

struct NumberOption {
  QString title;
  QString name;  // of the widget
  NumberDomain domain;
  ValueField::Scale scale;
  double step;
};
// Returns the widget, to enable or disable it.
ValueField* add_number(QHBoxLayout& row, Tool& tool, const NumberOption& option,
                       const std::function<double()>& get, const std::function<void(double)>& set);

struct ChoiceOption {
  QString title;
  QString name;
};
void add_choice(QHBoxLayout& row, Tool& tool, const ChoiceOption& option,
                const QStringList& choices, const std::function<int()>& get,
                const std::function<void(int)>& set);

// Widgets for the paint plane and its position.
void add_target(QHBoxLayout& row, Tool& tool, const QString& prefix,
                const std::function<PaintTarget()>& get,
                const std::function<void(const PaintTarget&)>& set);

}  // namespace brume
