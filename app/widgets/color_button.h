#pragma once

#include <QPixmap>
#include <QToolButton>
#include <glm/vec3.hpp>

#include "app/commands/merge_id.h"

class QColorDialog;

namespace brume {

// Conversion between sRGB of colour dialogs and linear RGB in [0, 1].
QColor to_color(const glm::dvec3& linear);
glm::dvec3 to_linear(const QColor& color);

// A swatch with a border, to be seen on any background.
QPixmap color_swatch(const glm::dvec3& linear, const QSize& size = {12, 12});

// A colour swatch, linear RGB in [0, 1], with the colour's numbers as its tool tip; opens a
// modeless colour dialog, which has swatches of colour temperatures, and fields of linear numbers
// if those were chosen.
class ColorButton : public QToolButton {
  Q_OBJECT
 public:
  explicit ColorButton(QWidget* parent = nullptr);

  void show_color(const glm::dvec3& linear);

 Q_SIGNALS:
  void edited(const glm::dvec3& linear, brume::MergeId gesture);

 private:
  void open_dialog();
  void add_temperatures(QColorDialog& dialog);
  void add_linear_fields(QColorDialog& dialog, MergeId gesture);

  glm::dvec3 color_{1.0};
};

}  // namespace brume
