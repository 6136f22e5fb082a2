#include "app/commands/group_command.h"

#include "app/document/document.h"

namespace brume {

GroupCommand::GroupCommand(Document& document, Groups groups, MediumEdit edit, const QString& text)
    : SceneCommand(document, text),
      before_(document.scene().groups),
      after_(std::move(groups)),
      edit_(std::move(edit)) {
  setObsolete(before_ == after_ && edit_.empty());
}

void GroupCommand::apply() {
  selection_before_ = document_.selection();
  if (before_ != after_) document_.set_part(after_);
  if (!edit_.empty()) document_.apply(edit_);
}

void GroupCommand::revert() {
  if (!edit_.empty()) document_.apply(edit_.inverted());
  if (before_ != after_) document_.set_part(before_);
  document_.select(selection_before_);
}

}  // namespace brume
