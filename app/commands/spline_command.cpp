#include "app/commands/spline_command.h"

#include "app/document/document.h"

namespace brume {

SplineCommand::SplineCommand(Document& document, Splines after, MediumEdit edit,
                             const QString& text, MergeId merge_id)
    : SceneCommand(document, text),
      before_(document.scene().splines),
      after_(std::move(after)),
      edit_(std::move(edit)),
      merge_id_(merge_id) {
  setObsolete(edit_.empty() && after_ == before_);
}

// The splines first: who hears of the medium looks at them.
void SplineCommand::apply() {
  document_.set_splines(after_);
  if (!edit_.empty()) document_.apply(edit_);
}

void SplineCommand::revert() {
  document_.set_splines(before_);
  if (!edit_.empty()) document_.apply(edit_.inverted());
}

bool SplineCommand::merge(const SceneCommand& later) {
  const auto* command = dynamic_cast<const SplineCommand*>(&later);
  if (!command) return false;
  after_ = command->after_;
  edit_.merge(command->edit_);
  setObsolete(edit_.empty() && after_ == before_);
  return true;
}

}  // namespace brume
