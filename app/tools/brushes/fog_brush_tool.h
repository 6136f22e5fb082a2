#pragma once

#include <array>

#include "app/tools/brushes/brush_preset.h"
#include "app/tools/brushes/brush_tool.h"
#include "app/tools/brushes/stroke_options_button.h"
#include "app/view/paint_point.h"
#include "core/authoring/mirror.h"
#include "core/scene/camera_rays.h"

namespace brume {

// A pen's pressure multiplies this.
enum class PenUse { nothing, size, density, both };

// How strokes follow the mouse or pen, and where else they appear.
struct StrokeOptions {
  double smoothing = 0.0;         // how far the brush trails behind the mouse, >= 0 [pixels]
  std::array<bool, 3> mirrors{};  // planes across x, y and z that mirror the stroke ...
  bool mirrors_at_pivot = false;  // ... through what the view looks at, or else the origin
  PenUse pen = PenUse::both;

  bool operator==(const StrokeOptions&) const = default;
};

// Base of brushes that add Gaussians of a radius and density on a plane or surfaces, randomized by
// a seed.
class FogBrushTool : public BrushTool {
  Q_OBJECT
 public:
  FogBrushTool(Document& document, View& view);

  void set_plane(PaintPlane plane);
  [[nodiscard]] const PaintTarget& paint_target() const { return target_; }
  void set_target(const PaintTarget& target);

  [[nodiscard]] const StrokeOptions& stroke_options() const { return stroke_options_; }
  void set_stroke_options(const StrokeOptions& options);

  // The brush as a preset, its sizes relative to the distance of the view; and back.
  [[nodiscard]] virtual BrushPreset preset() const = 0;
  virtual void apply_preset(const BrushPreset& preset) = 0;

  // Alt picks radius, density and colours from the Gaussian under the mouse, and of one that is
  // longer than wide the stretch.
  void press(QPointF position, Qt::KeyboardModifiers modifiers) override;
  [[nodiscard]] bool uses_alt() const override { return true; }
  void draw(Overlay& overlay, const CameraRays& rays) const override;
  void change_size(double factor) override;
  void change_strength(double factor) override;

 protected:
  // Attributes of added Gaussians; setters clamp to their domains.
  [[nodiscard]] virtual double radius() const = 0;
  [[nodiscard]] virtual double density() const = 0;
  virtual void set_gaussian(double radius, double density) = 0;
  virtual void set_stretch(double stretch) = 0;
  // Sets default sizes for a view distance [u].
  virtual void fit_to(double distance) = 0;

  // How far in front of a surface the center is; 0: on it [u].
  [[nodiscard]] virtual double offset() const { return radius(); }
  // The density of what one click lays [1/u].
  [[nodiscard]] virtual double click_density() const { return density(); }
  // The paint point at a position; of a stroke where that would go on.
  [[nodiscard]] std::optional<PaintPoint> paint_at(QPointF position) const;
  // The same, and the stroke goes on from there.
  std::optional<PaintPoint> extend_to(QPointF position);
  // Whether that has jumped to a thing at another depth.
  [[nodiscard]] bool has_jumped() const { return has_jumped_; }

  [[nodiscard]] double smoothing() const override { return stroke_options_.smoothing; }
  // The pen's factors of radius and density; never 0.
  struct PenScale {
    double size = 1.0;
    double strength = 1.0;
  };
  [[nodiscard]] PenScale pen_scale(double fraction) const;
  // A Gaussian and its mirror images as they are added; `all`: also images that coincide.
  void append_images(std::vector<Gaussian>& images, const Gaussian& gaussian, bool all) const;
  void append_images(std::vector<Gaussian>& images, const Gaussian& gaussian,
                     const MirrorPlanes& planes, bool all) const;
  // The planes of the stroke options, as the view is now.
  [[nodiscard]] MirrorPlanes mirror_planes() const;

  [[nodiscard]] const GaussianOptics& optics() const { return optics_; }
  void set_optics(const GaussianOptics& optics) { optics_ = optics; }

  // The Gaussians as they are added: within their domains, with the brush's albedo and emission,
  // in the active group.
  [[nodiscard]] Gaussian coloured(const Gaussian& gaussian) const;

  // Widgets of radius, density and colours, and of seed and plane; `prefix` of their object names.
  void add_gaussian_options(QHBoxLayout& row, const QString& prefix);
  // An option of the tool that is kept at `value`.
  StrokeNumber number_of(double& value, const NumberOption& option, const QString& tip = {});
  // `numbers` are added to the panel of the stroke.
  void add_place_options(QHBoxLayout& row, const QString& prefix,
                         std::vector<StrokeNumber> numbers);

  static QString stretch_tip();

  // Reads from a preset what all brushes have, and writes it.
  [[nodiscard]] BrushPreset common_preset() const;
  void apply_common(const BrushPreset& preset);
  // Sets a radius, to two digits, and the density of an optical depth through the center.
  void fit_gaussian(double radius, double depth);
  [[nodiscard]] double view_distance() const;

  // Derived from the user's seed and the document: reproducible, but different for each stroke.
  [[nodiscard]] std::uint64_t stroke_seed() const;

 private:
  void set_both(double radius, double density);

  void add_optics_button(QHBoxLayout& row, const QString& prefix);
  // The color of what is added: of its light if it shines, or else its albedo.
  [[nodiscard]] glm::dvec3 color() const;

  PaintTarget target_;
  std::optional<StrokeDepth> depth_;  // of the stroke
  bool has_jumped_ = false;
  StrokeOptions stroke_options_;
  GaussianOptics optics_;
  int seed_ = 1;
};

// Rounds to two digits, for default sizes.
double two_digits(double value);

}  // namespace brume
