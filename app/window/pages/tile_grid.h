#pragma once

#include <QIcon>
#include <QWidget>
#include <vector>

class QToolButton;

namespace brume {

// Buttons with a picture and a title below it, in as many columns as fit; as high as they need.
class TileGrid : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;

  static constexpr QSize picture_size{138, 92};
  // Scales the picture to fill the tile.
  QToolButton* add(const QPixmap& picture, const QString& title);
  void clear();
  [[nodiscard]] bool is_empty() const { return tiles_.empty(); }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  std::vector<QToolButton*> tiles_;
};

}  // namespace brume
