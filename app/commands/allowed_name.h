#pragma once

#include <QString>

#include "core/limits.h"

namespace brume {

// A name that files may have: without control characters and spaces around it, `room` bytes shorter
// than the longest.
inline QString allowed_name(const QString& text, qsizetype room = 0) {
  QString name = text.simplified();
  name.removeIf([](QChar c) { return c.unicode() < 0x20 || c.unicode() == 0x7f; });
  while (name.toUtf8().size() > static_cast<qsizetype>(limits::name_length) - room) name.chop(1);
  return name;
}

}  // namespace brume
