#include "app/commands/medium_command.h"

#include "app/document/document.h"

namespace brume {

MergeId new_merge_id() {
  static MergeId last = no_merge;
  return ++last;
}

MediumCommand::MediumCommand(Document& document, MediumEdit edit, const QString& text,
                             MergeId merge_id, AfterAdding after_adding)
    : QUndoCommand(text),
      document_(document),
      edit_(std::move(edit)),
      merge_id_(merge_id),
      after_adding_(after_adding) {
  setObsolete(edit_.empty());
}

void MediumCommand::undo() {
  document_.apply(edit_.inverted(), after_adding_ == AfterAdding::select);
}

void MediumCommand::redo() {
  if (!edit_.empty()) document_.apply(edit_, after_adding_ == AfterAdding::select);
}

bool MediumCommand::mergeWith(const QUndoCommand* later) {
  const auto* command = dynamic_cast<const MediumCommand*>(later);
  if (!command) return false;
  edit_.merge(command->edit_);
  setText(command->text());
  setObsolete(edit_.empty());
  return true;
}

}  // namespace brume
