#include "app/panels/lists/history_panel.h"

#include <QStyle>

namespace brume {

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : QUndoView(&stack, parent) {
  const int size = fontMetrics().height();
  setIconSize({size, size});
  setUniformItemSizes(true);
  setEmptyLabel(tr("As opened"));
  setCleanIcon(style()->standardIcon(QStyle::SP_DialogSaveButton));
}

}  // namespace brume
