#pragma once

#include <QUndoView>

namespace brume {

// What was done, as sentences; a disk marks the state that is saved.
class HistoryPanel : public QUndoView {
  Q_OBJECT
 public:
  explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);
};

}  // namespace brume
