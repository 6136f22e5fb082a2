#pragma once

#include <QToolBar>

class QLabel;
class QMenu;
class QToolButton;

namespace brume {

class ValueField;
class Viewport;

// The header over the upper edge of a view says what it shows, with the menus to change that:
// quantity, quality, exposure, colour view, camera, overlays, and the resolution of the picture.
// The button at the end has what finds no room.
class ViewHeader : public QToolBar {
  Q_OBJECT
 public:
  explicit ViewHeader(Viewport& pane);

  // The menus that the window shares among all headers.
  struct Menus {
    QMenu* quality;
    QMenu* color;
    QMenu* camera;
    QMenu* overlays;
  };
  void set_menus(const Menus& menus);
  // `is_marked`: it is the active one of several views.
  void refresh(bool is_marked);
  // Fits into the pane.
  void place();

 Q_SIGNALS:
  void refused(const QString& problem);

 private:
  QToolButton* add_button(const char* name, const QString& tip);
  void add_exposure();

  Viewport& pane_;
  QToolButton* mode_;
  QToolButton* quality_;
  ValueField* exposure_ = nullptr;
  QToolButton* reset_ = nullptr;
  QToolButton* color_ = nullptr;
  QToolButton* camera_ = nullptr;
  QToolButton* overlays_ = nullptr;
  QLabel* resolution_ = nullptr;
};

}  // namespace brume
