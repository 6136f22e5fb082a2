#include "app/commands/scene_command.h"

#include "app/document/document.h"

namespace brume {

SceneCommand::SceneCommand(Document& document, const QString& text)
    : QUndoCommand(text),
      document_(document),
      before_(document.revision()),
      after_(document.new_revision()) {}

void SceneCommand::undo() {
  revert();
  document_.set_revision(before_);
}

void SceneCommand::redo() {
  if (isObsolete()) return;
  apply();
  document_.set_revision(after_);
}

bool SceneCommand::mergeWith(const QUndoCommand* later) {
  const auto* command = dynamic_cast<const SceneCommand*>(later);
  if (!command || !merge(*command)) return false;
  setText(command->text());
  after_ = command->after_;
  // Back where it began: the step goes, and with it all trace of a change.
  if (isObsolete()) document_.set_revision(before_);
  return true;
}

}  // namespace brume
