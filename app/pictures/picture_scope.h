#pragma once

#include <QImage>
#include <QWidget>

namespace brume {

// Shows how the values of a picture are spread: how many pixels have each value, or the values of
// each column of pixels.
class PictureScope : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { none, histogram, waveform };
  explicit PictureScope(QWidget* parent = nullptr);

  void set_kind(Kind kind);
  void show_image(const QImage& image);  // null: nothing

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void update_scope();

  Kind kind_ = Kind::none;
  QImage image_;
  QImage scope_;  // 256 rows, the largest value on top
};

}  // namespace brume
