#pragma once

#include <QString>

#include "brume/limits.h"

namespace brume {

// A name that files may have: without control characters and spaces around it, `room` bytes shorter
// than the longest.
inline QString allowed_name(const QString& text, qsizetype room = 0) {
  QString name = text.simplified();
  name.removeIf([](QChar c) { return c.unicode() < 0x20 || c.unicode() == 0x7f; });
  while (name.toUtf8().size() > static_cast<qsizetype>(limits::name_length) - room) name.chop(1);
  return name;
}

// `name`, or with the first number after it that makes it one that is not taken.
template <class IsTaken>
QString free_name(const QString& name, IsTaken is_taken) {
  QString result = name;
  for (int k = 2; is_taken(result); ++k) result = name + ' ' + QString::number(k);
  return result;
}

}  // namespace brume
