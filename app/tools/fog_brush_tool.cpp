#include "app/tools/fog_brush_tool.h"

#include <algorithm>
#include <cmath>

#include "app/document/document.h"
#include "app/tools/option_widgets.h"
#include "app/view/navigation.h"
#include "app/view/view.h"

namespace brume {
namespace {

constexpr NumberDomain seed_domain{0.0, 1e9, "an integer from 0 to 1e9"};

}  // namespace

FogBrushTool::FogBrushTool(Document& document, View& view) : BrushTool(document, view) {
  connect(&document, &Document::scene_replaced, this,
          [this] { fit_to(target_distance(document_.scene().camera)); });
}

void FogBrushTool::set_target(const PaintTarget& target) {
  target_ = target;
  Q_EMIT options_changed();
}

void FogBrushTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  if (!modifiers.testFlag(Qt::AltModifier)) {
    BrushTool::press(position, modifiers);
    return;
  }
  if (const auto id = view().max_visible(position)) {
    const Gaussian gaussian = document_.medium().gaussian(*document_.medium().index_of(*id));
    set_both(gaussian.radius, gaussian.density);
  }
}

void FogBrushTool::change_size(double factor) {
  set_both(factor * radius(), density());
}

void FogBrushTool::change_strength(double factor) {
  set_both(radius(), factor * density());
}

void FogBrushTool::set_both(double radius, double density) {
  set_gaussian(std::clamp(radius, domain::length.min_value, domain::length.max_value),
               std::clamp(density, domain::density.min_value, domain::density.max_value));
  Q_EMIT options_changed();
}

void FogBrushTool::add_gaussian_options(QHBoxLayout& row, const QString& prefix) {
  using Scale = ValueField::Scale;
  add_number(
      row, *this, {tr("Radius"), prefix + "_radius", domain::length, Scale::logarithmic, 0.01},
      [this] { return radius(); }, [this](double value) { set_both(value, density()); });
  add_number(
      row, *this, {tr("Density"), prefix + "_density", domain::density, Scale::logarithmic, 0.01},
      [this] { return density(); }, [this](double value) { set_both(radius(), value); });
}

void FogBrushTool::add_place_options(QHBoxLayout& row, const QString& prefix) {
  add_number(
      row, *this, {tr("Seed"), prefix + "_seed", seed_domain, ValueField::Scale::linear, 1.0},
      [this] { return static_cast<double>(seed_); },
      [this](double value) {
        seed_ = static_cast<int>(std::round(value));
        Q_EMIT options_changed();
      });
  add_target(
      row, *this, prefix, [this] { return target_; },
      [this](const PaintTarget& target) { set_target(target); });
}

std::uint64_t FogBrushTool::stroke_seed() const {
  return static_cast<std::uint64_t>(seed_) * 0x9e3779b97f4a7c15U + document_.medium().next_id();
}

double two_digits(double value) {
  return QString::number(value, 'g', 2).toDouble();
}

}  // namespace brume
