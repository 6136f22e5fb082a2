#pragma once

#include <QFrame>

class QLabel;
class QMainWindow;

namespace brume {

class Document;
class SceneFiles;
class TileGrid;

// Covers the window, whose panels belong to the scene behind, with what one may begin with:
// templates, recent scenes and samples, each with a picture. Not modal: Escape, a change of the
// scene or another scene closes it. Templates and samples open as new scenes without a file, so
// that saving never replaces them.
class StartPage : public QFrame {
  Q_OBJECT
 public:
  // `bars`: messages of the window, which stay; `views`: get the focus when it closes.
  StartPage(Document& document, SceneFiles& files, QMainWindow& window, QWidget& bars,
            QWidget& views);

  void open();
  void close_page();

  // Whether to show it at start when no scene is named; a setting.
  [[nodiscard]] static bool is_wanted();

 Q_SIGNALS:
  void covers(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void cover();
  void fill_templates();
  void fill_samples();
  void fill_recent();

  SceneFiles& files_;
  QMainWindow& window_;
  QWidget& bars_;
  QWidget& views_;
  TileGrid* templates_;
  TileGrid* recent_;
  TileGrid* samples_;
  QLabel* recent_title_;
  bool is_filled_ = false;
};

}  // namespace brume
