#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "app/widgets/keys.h"

namespace brume {

// Adds an action that calls `react` to a menu. `name` is its own in the table of keys, "" for one
// without keys.
template <class React>
QAction* add_action(QMenu* menu, const QString& text, const char* name, QObject* context,
                    React react) {
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcuts(keys_of(name));
  QObject::connect(action, &QAction::triggered, context, react);
  return action;
}

// Adds one of the choices of a group, which calls `choose`.
template <class Choose>
QAction* add_choice(QActionGroup* group, const QString& text, bool is_chosen, Choose choose) {
  QAction* action = group->addAction(text);
  action->setCheckable(true);
  action->setChecked(is_chosen);
  QObject::connect(action, &QAction::triggered, group, choose);
  return action;
}

}  // namespace brume
