#pragma once

#include <QUndoCommand>

#include "core/scene/camera.h"

namespace brume {

class Document;

// Stores a view as the scene's camera.
class SetCameraCommand : public QUndoCommand {
 public:
  SetCameraCommand(Document& document, const Camera& camera);

  void undo() override;
  void redo() override;

 private:
  Document& document_;
  Camera before_;
  Camera after_;
};

}  // namespace brume
