#pragma once

#include "app/tools/brush_tool.h"

namespace brume {

// Base of brushes that add Gaussians of a radius and density on a plane or surfaces, randomized by
// a seed.
class FogBrushTool : public BrushTool {
  Q_OBJECT
 public:
  FogBrushTool(Document& document, View& view);

  void set_plane(PaintPlane plane) { set_target({plane, target_.position}); }
  void set_target(const PaintTarget& target);

  // Alt picks radius, density and colours from the Gaussian under the mouse.
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  [[nodiscard]] bool uses_alt() const override { return true; }
  void change_size(double factor) override;
  void change_strength(double factor) override;

 protected:
  // Attributes of added Gaussians; setters clamp to their domains.
  [[nodiscard]] virtual double radius() const = 0;
  [[nodiscard]] virtual double density() const = 0;
  virtual void set_gaussian(double radius, double density) = 0;
  // Sets default sizes for a view distance [u].
  virtual void fit_to(double distance) = 0;

  [[nodiscard]] double cursor_radius() const override { return radius(); }
  [[nodiscard]] PaintTarget target() const override { return target_; }

  // The Gaussians as they are added: within their domains, with the brush's albedo and emission,
  // in the active group.
  [[nodiscard]] Gaussian coloured(const Gaussian& gaussian) const;

  // Widgets of radius, density and colours, and of seed and plane; `prefix` of their object names.
  void add_gaussian_options(QHBoxLayout& row, const QString& prefix);
  void add_place_options(QHBoxLayout& row, const QString& prefix);

  // Derived from the user's seed and the document: reproducible, but different for each stroke.
  [[nodiscard]] std::uint64_t stroke_seed() const;

 private:
  void set_both(double radius, double density);

  void add_optics_button(QHBoxLayout& row, const QString& prefix);

  PaintTarget target_;
  GaussianOptics optics_;
  int seed_ = 1;
};

// Rounds to two digits, for default sizes.
double two_digits(double value);

}  // namespace brume
