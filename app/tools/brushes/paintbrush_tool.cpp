#include "app/tools/brushes/paintbrush_tool.h"

#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/tools/option_widgets.h"
#include "app/view/camera/navigation.h"
#include "core/number_domain.h"

namespace brume {
namespace {

// The members that presets have as they are.
constexpr std::array kept_by_paintbrush{std::pair(&BrushPreset::jitter, &Paintbrush::jitter),
                                        std::pair(&BrushPreset::stretch, &Paintbrush::stretch),
                                        std::pair(&BrushPreset::spacing, &Paintbrush::spacing),
                                        std::pair(&BrushPreset::scatter, &Paintbrush::scatter),
                                        std::pair(&BrushPreset::falloff, &Paintbrush::falloff),
                                        std::pair(&BrushPreset::flow, &Paintbrush::flow)};

}  // namespace
PaintbrushTool::PaintbrushTool(Document& document, View& view) : FogBrushTool(document, view) {
  PaintbrushTool::fit_to(target_distance(document.scene().camera));
}

void PaintbrushTool::set_brush(const Paintbrush& brush) {
  brush_ = brush;
  Q_EMIT options_changed();
}

void PaintbrushTool::set_gaussian(double radius, double density) {
  brush_.radius = radius;
  brush_.density = density;
}

QString PaintbrushTool::hint() const {
  return tr(
      "Drag to paint fog. [ and ] change the radius, with Shift the density; Alt + click picks "
      "both and the colours from the fog.");
}

void PaintbrushTool::add_options(QHBoxLayout& row) {
  add_brush_options(row, "brush");
}

void PaintbrushTool::add_brush_options(QHBoxLayout& row, const QString& prefix) {
  using Scale = ValueField::Scale;
  const auto number = [this, &prefix](double& value, const QString& title, const char* name,
                                      const NumberDomain& domain, Scale scale, const QString& tip) {
    return number_of(value, {title, prefix + '_' + name, domain, scale, 0.01}, tip);
  };
  add_gaussian_options(row, prefix);
  add_place_options(
      row, prefix,
      {number(brush_.spacing, tr("Spacing"), "spacing", domain::brush_spacing, Scale::logarithmic,
              tr("Distance between Gaussians along the stroke, relative to their radius along it")),
       number(brush_.scatter, tr("Scatter"), "scatter", domain::brush_scatter, Scale::linear,
              tr("Maximum random offset across the stroke, relative to the radius")),
       number(brush_.stretch, tr("Stretch"), "stretch", domain::brush_stretch, Scale::logarithmic,
              stretch_tip()),
       number(brush_.flow, tr("Flow"), "flow", domain::unit, Scale::linear,
              tr("Share of the density that one pass adds: 1 all of it, less builds up")),
       number(brush_.falloff, tr("Soft edge"), "falloff", domain::unit, Scale::linear,
              tr("How much thinner fog is at the rim of the scatter: 0 as dense, 1 nothing")),
       number(brush_.jitter, tr("Jitter"), "jitter", domain::unit, Scale::linear,
              tr("Random variation of radius and density: at 1 from half to double"))});
}

void PaintbrushTool::begin_stroke(QPointF position) {
  stroke_.emplace(brush_, stroke_seed());
  extend_stroke({&position, 1});
}

void PaintbrushTool::extend_stroke(std::span<const QPointF> curve) {
  std::vector<Gaussian> gaussians;
  double count_so_far = 0.0;
  for (const QPointF position : curve) {
    const PenScale pen = pen_scale(++count_so_far / static_cast<double>(curve.size()));
    const auto point = extend_to(position);
    if (!point) continue;
    if (has_jumped()) stroke_->lift();
    for (const Gaussian& gaussian : stroke_->extend(point->position, pen.size, pen.strength)) {
      append_images(gaussians, gaussian, false);
    }
  }
  const std::size_t count = gesture_.edit().added().size() + gaussians.size();
  gesture_.apply(MediumEdit::add(document_.medium(), gaussians),
                 tr("Paint %1").arg(gaussians_text(count)));
}

BrushPreset PaintbrushTool::preset() const {
  BrushPreset preset = common_preset();
  for (const auto& [of_preset, of_brush] : kept_by_paintbrush) preset.*of_preset = brush_.*of_brush;
  return preset;
}

void PaintbrushTool::apply_preset(const BrushPreset& preset) {
  brush_ = {};
  for (const auto& [of_preset, of_brush] : kept_by_paintbrush) brush_.*of_brush = preset.*of_preset;
  apply_common(preset);
}

// Optical depth 1 through a few overlapping Gaussians.
void PaintbrushTool::fit_to(double distance) {
  fit_gaussian(0.06 * distance, 0.5);
  Q_EMIT options_changed();
}

}  // namespace brume
