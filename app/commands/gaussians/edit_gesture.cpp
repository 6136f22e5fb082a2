#include "app/commands/gaussians/edit_gesture.h"

#include "app/commands/gaussian_budget.h"
#include "app/document/document.h"

namespace brume {

void EditGesture::begin() {
  edit_ = {};
  merge_id_ = new_merge_id();
  running_ = true;
}

void EditGesture::apply(MediumEdit edit, const QString& text) {
  apply(std::move(edit), [&text](const MediumEdit&) { return text; });
}

void EditGesture::apply(MediumEdit edit, const std::function<QString(const MediumEdit&)>& text) {
  if (!running_ || edit.empty()) return;
  if (!has_room(document_, edit.added().size(), edit.removed().size())) return;
  edit_.merge(edit);
  push(std::move(edit), text(edit_));
}

void EditGesture::cancel() {
  if (running_ && !edit_.empty()) push(edit_.inverted(), {});
  running_ = false;
}

void EditGesture::push(MediumEdit edit, const QString& text) {
  applying_ = true;
  document_.undo_stack().push(
      new MediumCommand(document_, std::move(edit), text, merge_id_, AfterAdding::keep_selection));
  applying_ = false;
}

}  // namespace brume
