#include "app/window/menus/command_search.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/widgets/mnemonics.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

constexpr QSize search_size(520, 340);

}  // namespace

CommandSearch::CommandSearch(const QMenuBar& menus, QWidget* parent)
    : QFrame(parent, Qt::Popup),
      words_(named(new QLineEdit(this), "command_words")),
      list_(named(new QListWidget(this), "command_list")) {
  setObjectName("command_search");
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  words_->setPlaceholderText(tr("What do you want to do?"));
  words_->installEventFilter(this);
  list_->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(words_);
  layout->addWidget(list_);
  collect(menus.actions(), {});
  connect(words_, &QLineEdit::textChanged, this, &CommandSearch::list_matches);
  connect(list_, &QListWidget::itemClicked, this, &CommandSearch::run);
  list_matches();
}

void CommandSearch::collect(const QList<QAction*>& actions, const QString& path) {
  for (QAction* action : actions) {
    if (action->isSeparator()) continue;
    const QString title = path + without_mnemonic(action->text());
    if (const QMenu* menu = action->menu()) {
      collect(menu->actions(), title + " › ");
    } else {
      commands_.push_back({title, action});
    }
  }
}

void CommandSearch::list_matches() {
  const QStringList words = words_->text().split(' ', Qt::SkipEmptyParts);
  list_->clear();
  for (std::size_t k = 0; k < commands_.size(); ++k) {
    const auto& [title, action] = commands_[k];
    const bool matches = std::ranges::all_of(words, [&title = title](const QString& word) {
      return title.contains(word, Qt::CaseInsensitive);
    });
    if (!matches) continue;
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    auto* item = new QListWidgetItem(keys.isEmpty() ? title : title + "    " + keys, list_);
    item->setData(Qt::UserRole, qulonglong{k});
    if (!action->isEnabled()) item->setFlags(Qt::NoItemFlags);
  }
  list_->setCurrentRow(0);
}

void CommandSearch::open() {
  const QWidget& window = *parentWidget();
  resize(search_size.boundedTo(window.size()));
  move(window.mapToGlobal(QPoint((window.width() - width()) / 2, window.height() / 8)));
  show();
  words_->setFocus();
}

void CommandSearch::run() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item || !(item->flags() & Qt::ItemIsEnabled)) return;
  const QPointer<QAction> action = commands_[item->data(Qt::UserRole).toULongLong()].action;
  close();
  // Once this is gone: the command may show a menu or a dialog.
  QMetaObject::invokeMethod(
      parentWidget(), [action] { return action ? action->trigger() : void(); },
      Qt::QueuedConnection);
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      run();
      return true;
    }
    if (key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_PageUp ||
        key == Qt::Key_PageDown) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace brume
