#pragma once

#include <QWidget>

#include "app/frames/view_mode.h"

namespace brume {

// Legend of a false-colour view.
class Legend : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent);

  void show_scale(const ColorScale& scale);  // hidden if empty
  [[nodiscard]] const ColorScale& scale() const { return scale_; }
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ColorScale scale_;
};

}  // namespace brume
