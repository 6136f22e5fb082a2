#pragma once

#include <QCoreApplication>
#include <QString>

namespace brume {

// The translated text of a command in the history, with %n and the plural of a count.
inline QString undo_text(const char* text, int count = -1) {
  return QCoreApplication::translate("Undo", text, nullptr, count);
}

}  // namespace brume
