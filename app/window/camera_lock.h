#pragma once

#include <QObject>
#include <QTimer>

#include "app/commands/merge_id.h"

namespace brume {

class Document;
class Viewport;

// Turns navigation in a view that is locked to the scene's camera into moves of that camera: a
// drag, or turning the wheel without a pause, is one undo step.
class CameraLock : public QObject {
  Q_OBJECT
 public:
  CameraLock(Document& document, Viewport& view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Document& document_;
  MergeId gesture_ = no_merge;
  QTimer pause_;  // until the wheel's next turn is another gesture
};

}  // namespace brume
