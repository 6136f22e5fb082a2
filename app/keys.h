#pragma once

#include <QKeySequence>
#include <QList>
#include <span>

namespace brume {

// Every key of the editor, in one table. A key can be rebound in the settings: keys/<action>, a
// list of sequences separated by "; ".
struct KeyEntry {
  const char* action;
  const char* keys;  // separated by "; "
};
std::span<const KeyEntry> key_table();

// The keys of an action of the table; none if it has none there.
QList<QKeySequence> keys_of(const char* action);

}  // namespace brume
