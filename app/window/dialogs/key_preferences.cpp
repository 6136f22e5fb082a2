#include "app/window/dialogs/key_preferences.h"
#include "app/widgets/mnemonics.h"

#include <QAction>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/widgets/keys.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

// "Ctrl+Z", "Del, X".
QString keys_text(const QAction& action) {
  QStringList texts;
  for (const QKeySequence& keys : action.shortcuts()) {
    texts << keys.toString(QKeySequence::NativeText);
  }
  return texts.join(", ");
}

}  // namespace

KeyPreferences::KeyPreferences(QWidget& window, QWidget* parent)
    : QWidget(parent),
      filter_(named(new QLineEdit(this), "key_filter")),
      list_(named(new QTreeWidget(this), "key_list")),
      edit_(named(new QKeySequenceEdit(this), "key_edit")),
      note_(named(new QLabel(this), "key_note")) {
  for (const KeyEntry& entry : key_table()) {
    if (auto* action = window.findChild<QAction*>(entry.action)) actions_ << action;
  }
  filter_->setPlaceholderText(tr("Find a command"));
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->setRootIsDecorated(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  note_->setWordWrap(true);
  auto* set = named(new QPushButton(tr("Set"), this), "key_set");
  auto* clear = new QPushButton(tr("None"), this);
  auto* reset_one = named(new QPushButton(tr("Default"), this), "key_default");
  auto* all = named(new QPushButton(tr("All Defaults"), this), "keys_default");
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(filter_);
  layout->addWidget(list_, 1);
  layout->addLayout(row_of({edit_, set, clear, reset_one, all}));
  layout->addWidget(note_);
  connect(filter_, &QLineEdit::textChanged, this, &KeyPreferences::list_matches);
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeyPreferences::show_current);
  connect(set, &QPushButton::clicked, this, &KeyPreferences::take_entered);
  connect(clear, &QPushButton::clicked, this, [this] {
    if (QAction* action = current()) set_keys(*action, {});
  });
  connect(reset_one, &QPushButton::clicked, this, [this] {
    if (QAction* action = current()) reset(*action);
  });
  connect(all, &QPushButton::clicked, this, &KeyPreferences::reset_all);
  for (QAction* action : actions_) {
    auto* item = new QTreeWidgetItem(list_, {command_title(*action), keys_text(*action)});
    item->setData(0, Qt::UserRole, action->objectName());
  }
  list_->setCurrentItem(list_->topLevelItem(0));
}

QAction* KeyPreferences::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? actions_.at(list_->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item)))
              : nullptr;
}

void KeyPreferences::list_matches() {
  for (int k = 0; k < list_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* item = list_->topLevelItem(k);
    item->setHidden(!item->text(0).contains(filter_->text(), Qt::CaseInsensitive) &&
                    !item->text(1).contains(filter_->text(), Qt::CaseInsensitive));
  }
}

void KeyPreferences::show_current() {
  const QAction* action = current();
  edit_->setKeySequence(action ? action->shortcut() : QKeySequence());
  note_->clear();
}

void KeyPreferences::show_keys() {
  for (int k = 0; k < list_->topLevelItemCount(); ++k) {
    list_->topLevelItem(k)->setText(1, keys_text(*actions_.at(k)));
  }
}

void KeyPreferences::set_keys(QAction& action, const QList<QKeySequence>& keys) {
  QStringList losers;
  for (QAction* other : actions_) {
    if (other == &action) continue;
    QList<QKeySequence> left = other->shortcuts();
    if (left.removeIf([&keys](const QKeySequence& k) { return keys.contains(k); }) == 0) continue;
    losers << command_title(*other);
    other->setShortcuts(left);
    remember_keys(qPrintable(other->objectName()), left);
  }
  action.setShortcuts(keys);
  remember_keys(qPrintable(action.objectName()), keys);
  show_keys();
  show_current();
  if (!losers.isEmpty()) note_->setText(tr("Taken from %1.").arg(losers.join(", ")));
}

void KeyPreferences::take_entered() {
  QAction* action = current();
  if (!action) return;
  const QKeySequence keys = edit_->keySequence();
  set_keys(*action, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
}

void KeyPreferences::reset(QAction& action) {
  set_keys(action, default_keys_of(qPrintable(action.objectName())));
}

void KeyPreferences::reset_all() {
  for (QAction* action : actions_) {
    const QByteArray name = action->objectName().toUtf8();
    action->setShortcuts(default_keys_of(name.constData()));
    remember_keys(name.constData(), action->shortcuts());
  }
  show_keys();
  show_current();
}

}  // namespace brume
