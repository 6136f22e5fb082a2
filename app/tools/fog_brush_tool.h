#pragma once

#include "app/tools/brush_tool.h"

namespace brume {

// What paintbrush and airbrush have in common: they add Gaussians of a radius and a density on a
// plane or on surfaces, by chance with a seed.
class FogBrushTool : public BrushTool {
  Q_OBJECT
 public:
  FogBrushTool(Document& document, Viewport& view);

  void set_plane(PaintPlane plane) { set_target({plane, target_.position}); }
  void set_target(const PaintTarget& target);

  // Alt takes radius and density from the fog under the mouse.
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  [[nodiscard]] bool takes_alt() const override { return true; }
  void change_size(double factor) override;
  void change_strength(double factor) override;

 protected:
  // Of the Gaussians that are added; what is set is within their domains.
  [[nodiscard]] virtual double radius() const = 0;
  [[nodiscard]] virtual double density() const = 0;
  virtual void set_gaussian(double radius, double density) = 0;
  // Sizes that suit a scene seen from `distance` [u].
  virtual void fit_to(double distance) = 0;

  [[nodiscard]] double cursor_radius() const override { return radius(); }
  [[nodiscard]] PaintTarget target() const override { return target_; }

  // Widgets of radius and density, and of seed and plane; `prefix` of their names.
  void add_gaussian_options(QHBoxLayout& row, const QString& prefix);
  void add_place_options(QHBoxLayout& row, const QString& prefix);

  // By the user's seed and the document, so that the same strokes give the same fog, and two
  // strokes are not alike.
  [[nodiscard]] std::uint64_t stroke_seed() const;

 private:
  void set_both(double radius, double density);

  PaintTarget target_;
  int seed_ = 1;
};

// To two digits: sizes that a tool begins with should read well.
double two_digits(double value);

}  // namespace brume
