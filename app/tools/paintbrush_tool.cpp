#include "app/tools/paintbrush_tool.h"

#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/tools/option_widgets.h"
#include "app/view/navigation.h"

namespace brume {
namespace {

constexpr NumberDomain spacing_domain{0.05, 100.0, "a number from 0.05 to 100"};

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
  using Scale = ValueField::Scale;
  const auto add = [&](const QString& title, const char* name, const NumberDomain& domain,
                       Scale scale, double Paintbrush::*number) {
    add_number(
        row, *this, {title, name, domain, scale, 0.01}, [this, number] { return brush_.*number; },
        [this, number](double value) {
          brush_.*number = value;
          Q_EMIT options_changed();
        });
  };
  add_gaussian_options(row, "brush");
  add(tr("Spacing"), "brush_spacing", spacing_domain, Scale::logarithmic, &Paintbrush::spacing);
  add(tr("Scatter"), "brush_scatter", domain::unit, Scale::linear, &Paintbrush::scatter);
  add_place_options(row, "brush");
}

void PaintbrushTool::begin_stroke(QPointF position) {
  stroke_.emplace(brush_, stroke_seed());
  extend_stroke({&position, 1});
}

void PaintbrushTool::extend_stroke(std::span<const QPointF> curve) {
  std::vector<Gaussian> gaussians;
  for (const QPointF position : curve) {
    const auto point = paint_at(position);
    if (!point) continue;
    for (const Gaussian& gaussian : stroke_->extend(point->position)) {
      gaussians.push_back(coloured(gaussian));
    }
  }
  const std::size_t count = gesture_.edit().added().size() + gaussians.size();
  gesture_.apply(MediumEdit::add(document_.medium(), gaussians),
                 tr("Paint %1").arg(gaussians_text(count)));
}

void PaintbrushTool::fit_to(double distance) {
  Paintbrush brush = brush_;
  brush.radius = two_digits(0.06 * distance);
  // Optical depth 1 through a few overlapping Gaussians.
  brush.density = two_digits(0.5 / (std::sqrt(std::numbers::pi) * brush.radius));
  set_brush(brush);
}

}  // namespace brume
