#pragma once

#include <QAction>
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

}  // namespace brume
