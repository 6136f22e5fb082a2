#include "app/commands/set_camera_command.h"

#include <QCoreApplication>

#include "app/document/document.h"

namespace brume {

SetCameraCommand::SetCameraCommand(Document& document, const Camera& camera)
    : QUndoCommand(QCoreApplication::translate("Undo", "Store view as scene camera")),
      document_(document),
      before_(document.scene().camera),
      after_(camera) {
  setObsolete(before_ == after_);
}

void SetCameraCommand::undo() {
  document_.set_camera(before_);
}

void SetCameraCommand::redo() {
  if (!isObsolete()) document_.set_camera(after_);
}

}  // namespace brume
