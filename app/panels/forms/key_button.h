#pragma once

#include <QPointer>
#include <QToolButton>
#include <functional>
#include <vector>

#include "app/document/time/keyframe_tracks.h"

class QMenu;

namespace brume {

class Document;

// Beside the field of a value: sets its keyframe at the document's time, or deletes the one that is
// there; checked if there is one, and in colour if there are others. A right click opens a menu of
// its keyframes.
class KeyButton : public QToolButton {
  Q_OBJECT
 public:
  // `track`: of the value alone.
  KeyButton(Document& document, std::function<Track(const Scene&)> track, QWidget* parent);

  // The field or title of the value: a right click opens the menu there, too, and the keys
  // of "time.set_key" and "select.lock" are the button while the mouse is over it.
  void watch(QWidget& field);
  void refresh();
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  void time_asked_for(double time);  // [s]
  void curve_asked_for(const brume::Track& track);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  [[nodiscard]] std::vector<Keyframe> keys() const;
  [[nodiscard]] bool has_key_now() const;
  void toggle();
  void show_menu(QMenu& menu, const QPoint& global_position);

  Document& document_;
  std::function<Track(const Scene&)> track_;
  std::vector<QPointer<QWidget>> watched_;
};

}  // namespace brume
