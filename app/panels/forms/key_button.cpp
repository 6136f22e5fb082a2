#include "app/panels/forms/key_button.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/edit_keys.h"
#include "app/document/document.h"
#include "app/widgets/icons.h"

namespace brume {

KeyButton::KeyButton(Document& document, std::function<Track(const Scene&)> track, QWidget* parent)
    : QToolButton(parent), document_(document), track_(std::move(track)) {
  setIcon(load_icon("key"));
  setAutoRaise(true);
  setCheckable(true);
  connect(this, &QToolButton::clicked, this, [this] {
    const Track value = track_(document_.scene());
    if (has_key_now()) {
      delete_keys(document_, value, std::array{document_.time()});
    } else {
      set_keys(document_, value);
    }
    refresh();
  });
}

QSize KeyButton::sizeHint() const {
  const int side = fontMetrics().height() + 2;  // of a field, which it is not to heighten
  return {side, side};
}

void KeyButton::refresh() {
  const bool has_key = has_key_now();
  setChecked(has_key);
  setToolTip(has_key ? tr("Delete the keyframe at this time") : tr("Set a keyframe at this time"));
}

bool KeyButton::has_key_now() const {
  const std::vector<Keyframe> keys = keyframes_of(document_.scene(), track_(document_.scene()));
  return std::ranges::any_of(keys, [this](const Keyframe& key) {
    return std::abs(key.time - document_.time()) < min_key_distance;
  });
}

}  // namespace brume
