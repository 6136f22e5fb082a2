#pragma once

#include <QCoreApplication>
#include <QString>

namespace brume {

// The translated text of a command in the history.
inline QString undo_text(const char* text) {
  return QCoreApplication::translate("Undo", text);
}

}  // namespace brume
