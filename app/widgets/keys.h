#pragma once

#include <QKeySequence>
#include <QList>
#include <functional>
#include <optional>
#include <span>

class QAbstractItemView;
class QKeyEvent;

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
// The key of a US keyboard at the place of one whose letter is of another script; nullopt for all
// others.
std::optional<QKeyCombination> latin_key(const QKeyEvent& event);
// Whether it is pressed: for widgets that act themselves while they have the focus.
bool is_key_of(const char* action, const QKeyEvent& event);
// Whether it types a letter, digit or sign, which lists search for or edit with.
bool is_typed(const QKeyEvent& event);
// Whether it types a letter.
bool is_letter(const QKeyEvent& event);
// The key of "edit.delete", unless it types a letter, calls the function while a list has the
// focus.
void on_delete_key(QAbstractItemView& list, std::function<void()> react);
// For this and later sessions; the default ones are no setting.
void remember_keys(const char* action, const QList<QKeySequence>& keys);

}  // namespace brume
