#include "app/tools/selection/selection_tool.h"

#include <algorithm>

#include "app/document/document.h"
#include "app/tools/option_widgets.h"

namespace brume {

void SelectionTool::add_options(QHBoxLayout& row) {
  add_choice(
      row, *this, {tr("Selection"), "select_mode"},
      {tr("Replace"), tr("Add"), tr("Remove"), tr("Intersect")},
      [this] { return static_cast<int>(mode_); },
      [this](int index) { set_mode(static_cast<SelectMode>(index)); });
}

void SelectionTool::set_mode(SelectMode mode) {
  mode_ = mode;
  Q_EMIT options_changed();
}

SelectMode SelectionTool::mode_with(Qt::KeyboardModifiers modifiers) const {
  const bool shift = modifiers.testFlag(Qt::ShiftModifier);
  const bool control = modifiers.testFlag(Qt::ControlModifier);
  if (shift && control) return SelectMode::intersect;
  if (shift) return SelectMode::add;
  if (control) return SelectMode::remove;
  return mode_;
}

void SelectionTool::choose(const std::vector<GaussianId>& before,
                           const std::vector<std::size_t>& indices, SelectMode mode,
                           MergeId merge_id) {
  std::vector<GaussianId> chosen;
  for (const std::size_t index : indices) chosen.push_back(document_.medium().ids()[index]);
  std::sort(chosen.begin(), chosen.end());
  select_gaussians(document_, combined(before, chosen, mode), merge_id);
}

}  // namespace brume
