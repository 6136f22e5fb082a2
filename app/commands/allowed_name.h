#pragma once

#include <QString>
#include <algorithm>

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
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

// Returns a name that no other object has, but for the one of `own_id`.
template <class Objects>
std::string free_name(const Objects& objects, const QString& name, auto own_id) {
  const auto is_taken = [&](const QString& text) {
    return std::ranges::any_of(objects, [&](const auto& other) {
      return other.id != own_id && QString::fromStdString(other.name) == text;
    });
  };
  return free_name(name, is_taken).toStdString();
}

template <class Objects>
auto new_id(const Objects& objects) {
  decltype(objects.front().id) last = 0;
  for (const auto& object : objects) last = std::max(last, object.id);
  return last + 1;
}

// Renames one of the scene's groups or splines, as an undo step.
template <class Objects>
void rename_one(Document& document, Objects objects, auto id, const QString& name) {
  const auto found = std::ranges::find(objects, id, &Objects::value_type::id);
  const QString wanted = allowed_name(name, 10);  // with room for a number
  if (found == objects.end() || wanted.isEmpty()) return;
  const QString old_name = QString::fromStdString(found->name);
  if (wanted == old_name) return;
  found->name = free_name(objects, wanted, id);
  const QString text =
      undo_text("Rename %1 to %2").arg(old_name, QString::fromStdString(found->name));
  set_scene_part(document, std::move(objects), text);
}

}  // namespace brume
