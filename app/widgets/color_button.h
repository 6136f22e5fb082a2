#pragma once

#include <QPixmap>
#include <QToolButton>
#include <glm/vec3.hpp>
#include <optional>

#include "app/commands/merge_id.h"

class QColorDialog;

namespace brume {

// Conversion between sRGB of colour dialogs and linear RGB in [0, 1].
QColor to_color(const glm::dvec3& linear);
glm::dvec3 to_linear(const QColor& color);

// A typed colour: linear numbers "0.9 0.2 0.1", sRGB "#e63" or "#e6331a", or that of a black body
// "2700 K".
struct TypedColor {
  glm::dvec3 linear;
  bool is_shade;  // its brightness means nothing: it is no numbers
};
std::optional<TypedColor> parse_color(const QString& text);

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
