#pragma once

#include <QToolButton>
#include <functional>

#include "app/document/keyframe_tracks.h"

namespace brume {

class Document;

// Beside the field of a value: sets its keyframe at the document's time, or deletes the one that is
// there; checked if there is one.
class KeyButton : public QToolButton {
  Q_OBJECT
 public:
  // `track`: of the value alone.
  KeyButton(Document& document, std::function<Track(const Scene&)> track, QWidget* parent);

  void refresh();
  [[nodiscard]] QSize sizeHint() const override;

 private:
  [[nodiscard]] bool has_key_now() const;

  Document& document_;
  std::function<Track(const Scene&)> track_;
};

}  // namespace brume
