#pragma once

#include <vector>

#include "app/commands/gaussians/select_command.h"
#include "app/view/tool.h"

namespace brume {

// Base of selection tools: the mode, from options or modifiers. Shift adds, Ctrl removes, both
// intersect.
class SelectionTool : public Tool {
  Q_OBJECT
 public:
  using Tool::Tool;

  void add_options(QHBoxLayout& row) override;
  [[nodiscard]] SelectMode mode() const { return mode_; }
  void set_mode(SelectMode mode);

 protected:
  [[nodiscard]] SelectMode mode_with(Qt::KeyboardModifiers modifiers) const;
  // `indices` of the medium, in any order.
  void choose(const std::vector<GaussianId>& before, const std::vector<std::size_t>& indices,
              SelectMode mode, MergeId merge_id = no_merge);

 private:
  SelectMode mode_ = SelectMode::set;
};

}  // namespace brume
