#pragma once

#include <QKeySequence>
#include <QList>
#include <span>

namespace brume {

// The table of all keyboard shortcuts. Rebound by the setting keys/<action>: sequences separated by
// "; ".
struct KeyEntry {
  const char* action;
  const char* keys;  // separated by "; "
};
std::span<const KeyEntry> key_table();

// The shortcuts of an action; empty if none.
QList<QKeySequence> keys_of(const char* action);
QList<QKeySequence> default_keys_of(const char* action);
// For this and later sessions; the default ones are no setting.
void remember_keys(const char* action, const QList<QKeySequence>& keys);

}  // namespace brume
