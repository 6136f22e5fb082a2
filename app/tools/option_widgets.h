#pragma once

#include <functional>

#include "app/panels/value_field.h"
#include "app/tools/paint_plane.h"
#include "app/tools/tool.h"

namespace brume {

// Widgets in a tool's row of options. They show what `get` answers whenever the tool says that its
// options have changed, and give what the user enters to `set`.

struct NumberOption {
  QString title;
  QString name;  // of the widget
  NumberDomain domain;
  ValueField::Scale scale;
  double step;
};
// Answers the widget, for what else decides whether it is of use.
ValueField* add_number(QHBoxLayout& row, Tool& tool, const NumberOption& option,
                       const std::function<double()>& get, const std::function<void(double)>& set);

struct ChoiceOption {
  QString title;
  QString name;
};
void add_choice(QHBoxLayout& row, Tool& tool, const ChoiceOption& option,
                const QStringList& choices, const std::function<int()>& get,
                const std::function<void(int)>& set);

// Where a tool paints: which plane, and where that is.
void add_target(QHBoxLayout& row, Tool& tool, const QString& prefix,
                const std::function<PaintTarget()>& get,
                const std::function<void(const PaintTarget&)>& set);

}  // namespace brume
