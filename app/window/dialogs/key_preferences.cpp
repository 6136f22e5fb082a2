#include "app/window/dialogs/key_preferences.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/widgets/keys.h"

namespace brume {
namespace {

QString plain_title(const QAction& action) {
  return action.text().remove('&').remove(QChar(0x2026));
}

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
      filter_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      edit_(new QKeySequenceEdit(this)),
      note_(new QLabel(this)) {
  for (const KeyEntry& entry : key_table()) {
    if (auto* action = window.findChild<QAction*>(entry.action)) actions_ << action;
  }
  filter_->setObjectName("key_filter");
  filter_->setPlaceholderText(tr("Find a command"));
  list_->setObjectName("key_list");
  list_->setHeaderLabels({tr("Command"), tr("Keys")});
  list_->setRootIsDecorated(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  edit_->setObjectName("key_edit");
  note_->setObjectName("key_note");
  note_->setWordWrap(true);
  auto* set = new QPushButton(tr("Set"), this);
  set->setObjectName("key_set");
  auto* clear = new QPushButton(tr("None"), this);
  auto* reset_one = new QPushButton(tr("Default"), this);
  reset_one->setObjectName("key_default");
  auto* all = new QPushButton(tr("All Defaults"), this);
  all->setObjectName("keys_default");
  auto* row = new QHBoxLayout;
  row->addWidget(edit_, 1);
  for (QPushButton* button : {set, clear, reset_one, all}) row->addWidget(button);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(filter_);
  layout->addWidget(list_, 1);
  layout->addLayout(row);
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
    auto* item = new QTreeWidgetItem(list_, {plain_title(*action), keys_text(*action)});
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
    losers << plain_title(*other);
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
