#include "app/widgets/keys.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QSettings>
#include <array>
#include <string_view>
#include <utility>

namespace brume {
namespace {

constexpr std::array table = std::to_array<KeyEntry>({
    {"file.new", "Ctrl+N"},
    {"file.open", "Ctrl+O"},
    {"file.save", "Ctrl+S"},
    {"file.save_as", "Ctrl+Shift+S"},
    {"file.import", "Ctrl+Shift+I"},
    {"file.export", "Ctrl+E"},
    {"file.quit", "Ctrl+Q"},
    {"edit.undo", "Ctrl+Z"},
    {"edit.redo", "Ctrl+Shift+Z; Ctrl+Y"},
    {"edit.add_gaussian", "Shift+A"},
    {"edit.delete", "Del; X"},
    {"edit.rename", "F2"},
    {"edit.find_command", "F3; Ctrl+Shift+P"},
    {"edit.preferences", "Ctrl+,"},
    {"edit.cut", "Ctrl+X"},
    {"edit.copy", "Ctrl+C"},
    {"edit.paste", "Ctrl+V"},
    {"edit.paste_in_place", "Ctrl+Shift+V"},
    {"edit.duplicate", "Ctrl+D"},
    {"edit.drop", "End"},
    {"select.all", "Ctrl+A"},
    {"select.none", "Ctrl+Shift+A"},
    {"select.invert", "Ctrl+I"},
    {"select.grow", "Ctrl++; Ctrl+="},
    {"select.shrink", "Ctrl+-"},
    {"select.group", "Ctrl+G"},
    {"select.ungroup", "Ctrl+Shift+G"},
    {"select.hide", "H"},
    {"select.show_all", "Shift+H"},
    {"select.isolate", "/"},
    {"select.lock", "K"},
    {"select.unlock_all", "Shift+K"},
    {"tool.select", "V"},
    {"tool.lasso", "L"},
    {"tool.brush_select", "C"},
    {"tool.move", "G"},
    {"tool.rotate", "R"},
    {"tool.scale", "S"},
    {"tool.paintbrush", "B"},
    {"tool.eraser", "E"},
    {"tool.airbrush", "A"},
    {"tool.emitter", "P"},
    {"tool.spline", "Shift+B"},
    {"tool.smaller", "["},
    {"tool.larger", "]"},
    {"tool.weaker", "Shift+[; {"},
    {"tool.stronger", "Shift+]; }"},
    {"light.point", "Ctrl+1"},
    {"light.spot", "Ctrl+2"},
    {"light.directional", "Ctrl+3"},
    {"light.rectangle", "Ctrl+4"},
    {"light.disk", "Ctrl+5"},
    {"light.sphere", "Ctrl+6"},
    {"light.look_through", "Shift+L"},
    {"time.play", "Space"},
    {"time.next", "."},
    {"time.previous", ","},
    {"time.first", "Shift+Home"},
    {"time.set_key", "I"},
    {"view.frame_all", "Home"},
    {"view.frame_selection", "F"},
    {"view.scene_camera", "0"},
    {"view.store_camera", "Ctrl+0"},
    {"view.four", "Ctrl+Alt+Q"},
    {"view.overlays", "Shift+O"},
    {"view.next_mode", "Tab"},
    {"view.exposure_up", "+; ="},
    {"view.exposure_down", "-"},
    {"render.picture", "F12"},
    {"render.animation", "Ctrl+F12"},
    {"render.region", "Ctrl+B"},
    {"render.whole", "Ctrl+Alt+B"},
    {"render.viewer", "F11"},
    {"render.keep_view", "F9"},
    {"help.manual", "F1"},
    {"help.keys", "?"},
});

QString setting_of(const char* action) {
  return QString("keys/") + action;
}

// FieldFilter keeps the key from the window's action.
class DeleteKey : public QObject {
 public:
  DeleteKey(QAbstractItemView& list, std::function<void()> react)
      : QObject(&list), react_(std::move(react)) {
    list.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::KeyPress) {
      const auto& key = static_cast<const QKeyEvent&>(*event);
      if (is_key_of("edit.delete", key) && !is_typed(key)) {
        react_();
        return true;
      }
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<void()> react_;
};

}  // namespace

std::span<const KeyEntry> key_table() {
  return table;
}

QList<QKeySequence> default_keys_of(const char* action) {
  for (const KeyEntry& entry : table) {
    if (std::string_view(entry.action) == action) {
      return QKeySequence::listFromString(entry.keys, QKeySequence::PortableText);
    }
  }
  return {};
}

QList<QKeySequence> keys_of(const char* action) {
  const QSettings settings;
  if (!settings.contains(setting_of(action))) return default_keys_of(action);
  const QString keys = settings.value(setting_of(action)).toString();
  if (keys.isEmpty()) return {};  // Qt would make one empty sequence of it
  return QKeySequence::listFromString(keys, QKeySequence::PortableText);
}

std::optional<QKeyCombination> latin_key(const QKeyEvent& event) {
  const int key = event.key();
  if (key < 0x80 || key > 0xffff || QChar(key).script() == QChar::Script_Latin) return std::nullopt;
  // Rows of keys by the codes of X11 and Wayland.
  struct Row {
    quint32 first;
    std::string_view keys;
  };
  constexpr std::array<Row, 3> rows{
      {{24, "QWERTYUIOP[]"}, {38, "ASDFGHJKL;'"}, {52, "ZXCVBNM,./"}}};
  for (const Row& row : rows) {
    const quint32 place = event.nativeScanCode() - row.first;
    if (place >= row.keys.size()) continue;
    return QKeyCombination(event.modifiers(), static_cast<Qt::Key>(row.keys[place]));
  }
  return std::nullopt;
}

bool is_key_of(const char* action, const QKeyEvent& event) {
  const QKeyCombination pressed = latin_key(event).value_or(event.keyCombination());
  return keys_of(action).contains(QKeySequence(pressed));
}

bool is_typed(const QKeyEvent& event) {
  constexpr Qt::KeyboardModifiers commands =
      Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  const QString text = event.text();
  return !(event.modifiers() & commands) && !text.isEmpty() && text[0].isPrint() &&
         !text[0].isSpace();
}

bool is_letter(const QKeyEvent& event) {
  return is_typed(event) && event.text()[0].isLetter();
}

void on_delete_key(QAbstractItemView& list, std::function<void()> react) {
  new DeleteKey(list, std::move(react));
}

void remember_keys(const char* action, const QList<QKeySequence>& keys) {
  QSettings settings;
  if (keys == default_keys_of(action)) {
    settings.remove(setting_of(action));
  } else {
    settings.setValue(setting_of(action), QKeySequence::listToString(keys));
  }
}

}  // namespace brume
