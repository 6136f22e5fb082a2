#include "app/tools/paintbrush_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/document/document.h"
#include "app/document/gaussian_field.h"
#include "app/tools/option_widgets.h"
#include "app/viewport/navigation.h"
#include "app/viewport/viewport.h"

namespace brume {
namespace {

constexpr NumberDomain spacing_domain{0.05, 100.0, "a number from 0.05 to 100"};
constexpr NumberDomain seed_domain{0.0, 1e9, "a whole number from 0 to 1e9"};

}  // namespace

PaintbrushTool::PaintbrushTool(Document& document, Viewport& viewport)
    : BrushTool(document, viewport) {
  connect(&document, &Document::scene_replaced, this, &PaintbrushTool::fit_to_view);
  fit_to_view();
}

void PaintbrushTool::set_brush(const Paintbrush& brush) {
  brush_ = brush;
  brush_.radius = std::clamp(brush.radius, domain::length.least, domain::length.greatest);
  brush_.density = std::clamp(brush.density, domain::density.least, domain::density.greatest);
  Q_EMIT options_changed();
}

void PaintbrushTool::set_plane(PaintPlane plane) {
  plane_ = plane;
  Q_EMIT options_changed();
}

QString PaintbrushTool::hint() const {
  return tr(
      "Drag paints fog. [ and ] change the radius, with Shift the density; Alt + click takes "
      "both from the fog.");
}

void PaintbrushTool::add_options(QHBoxLayout& row) {
  using Scale = ValueField::Scale;
  const auto add = [&](const QString& title, const char* name, const NumberDomain& domain,
                       Scale scale, double step, double Paintbrush::*number) {
    add_number(
        row, *this, {title, name, domain, scale, step}, [this, number] { return brush_.*number; },
        [this, number](double value) {
          brush_.*number = value;
          Q_EMIT options_changed();
        });
  };
  add(tr("Radius"), "brush_radius", domain::length, Scale::logarithmic, 0.01, &Paintbrush::radius);
  add(tr("Density"), "brush_density", domain::density, Scale::logarithmic, 0.01,
      &Paintbrush::density);
  add(tr("Spacing"), "brush_spacing", spacing_domain, Scale::logarithmic, 0.01,
      &Paintbrush::spacing);
  add(tr("Scatter"), "brush_scatter", domain::unit, Scale::linear, 0.01, &Paintbrush::scatter);
  add_number(
      row, *this, {tr("Seed"), "brush_seed", seed_domain, Scale::linear, 1.0},
      [this] { return static_cast<double>(seed_); },
      [this](double value) {
        seed_ = static_cast<int>(std::round(value));
        Q_EMIT options_changed();
      });
  add_choice(
      row, *this, {tr("On"), "brush_plane"}, {tr("View plane"), tr("Ground"), tr("Surfaces")},
      [this] { return static_cast<int>(plane_); },
      [this](int index) { set_plane(static_cast<PaintPlane>(index)); });
}

void PaintbrushTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  if (modifiers.testFlag(Qt::AltModifier)) {
    pick(position);
  } else {
    BrushTool::press(position, modifiers);
  }
}

void PaintbrushTool::change_size(double factor) {
  Paintbrush brush = brush_;
  brush.radius *= factor;
  set_brush(brush);
}

void PaintbrushTool::change_strength(double factor) {
  Paintbrush brush = brush_;
  brush.density *= factor;
  set_brush(brush);
}

void PaintbrushTool::begin_stroke(QPointF position) {
  // The seed and the document decide, so that the same strokes give the same fog, and two strokes
  // are not alike.
  stroke_.emplace(brush_, static_cast<std::uint64_t>(seed_) * 0x9e3779b97f4a7c15U +
                              document_.medium().next_id());
  extend_stroke(position);
}

void PaintbrushTool::extend_stroke(QPointF position) {
  const auto point = paint_at(position);
  if (!point) return;
  std::vector<Gaussian> gaussians = stroke_->to(point->position);
  for (Gaussian& gaussian : gaussians) gaussian = within_domains(gaussian);
  const std::size_t count = gesture_.edit().added().size() + gaussians.size();
  gesture_.apply(MediumEdit::add(document_.medium(), gaussians),
                 tr("Paint %1").arg(gaussians_text(count)));
}

void PaintbrushTool::pick(QPointF position) {
  const auto id = view().most_visible(position);
  if (!id) return;
  const Gaussian gaussian = document_.medium().gaussian(*document_.medium().index_of(*id));
  Paintbrush brush = brush_;
  brush.radius = gaussian.radius;
  brush.density = gaussian.density;
  set_brush(brush);
}

void PaintbrushTool::fit_to_view() {
  Paintbrush brush = brush_;
  const auto rounded = [](double value) { return QString::number(value, 'g', 2).toDouble(); };
  brush.radius = rounded(0.06 * target_distance(document_.scene().camera));
  // Optical depth 1 straight through a few that overlap.
  brush.density = rounded(0.5 / (std::sqrt(std::numbers::pi) * brush.radius));
  set_brush(brush);
}

}  // namespace brume
