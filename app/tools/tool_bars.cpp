#include "app/tools/tool_bars.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedWidget>

#include "app/tools/tool_box.h"
#include "app/widgets/icons.h"
#include "app/widgets/keys.h"

namespace brume {

ToolBar::ToolBar(ToolBox& tools, QWidget* parent) : QToolBar(tr("Tools"), parent) {
  setObjectName("tools");  // restoreState() knows it by this
  setIconSize({24, 24});
  setMovable(false);
  auto* group = new QActionGroup(this);
  for (std::size_t k = 0; k < tools.entries().size(); ++k) {
    const ToolBox::Entry& entry = tools.entries()[k];
    QAction* action = addAction(load_icon(entry.name), entry.title);
    action->setObjectName("tool." + entry.name);
    action->setCheckable(true);
    action->setChecked(k == tools.active());
    action->setShortcuts(keys_of(qPrintable(action->objectName())));
    action->setToolTip(
        QString("%1 (%2)").arg(entry.title, action->shortcut().toString(QKeySequence::NativeText)));
    group->addAction(action);
    connect(action, &QAction::triggered, &tools, [&tools, k] { tools.activate(k); });
  }
  connect(&tools, &ToolBox::activated, this, [group](std::size_t index) {
    group->actions().at(static_cast<qsizetype>(index))->setChecked(true);
  });
}

ToolOptions::ToolOptions(ToolBox& tools, QWidget* parent) : QFrame(parent) {
  setObjectName("tool_options");
  auto* pages = new QStackedWidget(this);
  for (const ToolBox::Entry& entry : tools.entries()) {
    auto* page = new QWidget(pages);
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(7);
    auto* title = new QLabel(QString("<b>%1</b>").arg(entry.title), page);
    row->addWidget(title);
    entry.tool->add_options(*row);
    row->addStretch(1);
    pages->addWidget(page);
  }
  // A narrow window cuts the row off rather than grow.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 3, 10, 3);
  layout->addWidget(pages);
  pages->setCurrentIndex(static_cast<int>(tools.active()));
  connect(&tools, &ToolBox::activated, pages,
          [pages](std::size_t index) { pages->setCurrentIndex(static_cast<int>(index)); });
}

}  // namespace brume
