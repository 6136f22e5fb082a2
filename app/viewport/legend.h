#pragma once

#include <QWidget>

#include "app/viewport/view_mode.h"

namespace brume {

// What the false colours over which it lies mean.
class Legend : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent);

  void show_scale(const ColorScale& scale);  // hides itself where there is none
  [[nodiscard]] const ColorScale& scale() const { return scale_; }
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ColorScale scale_;
};

}  // namespace brume
