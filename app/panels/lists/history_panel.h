#pragma once

#include <QUndoView>

namespace brume {

// The undo history; a disk icon marks the saved state.
class HistoryPanel : public QUndoView {
  Q_OBJECT
 public:
  explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);
};

}  // namespace brume
