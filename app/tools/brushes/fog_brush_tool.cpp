#include "app/tools/brushes/fog_brush_tool.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "app/commands/gaussians/edit_groups.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/tools/brushes/brush_cursor.h"
#include "app/tools/option_widgets.h"
#include "app/view/camera/navigation.h"
#include "app/view/view.h"
#include "app/widgets/color_button.h"
#include "app/widgets/number_field.h"
#include "app/widgets/optics_editor.h"
#include "app/widgets/rows.h"
#include "core/math/rounded.h"
#include "core/number_domain.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

constexpr NumberDomain seed_domain{0.0, 1e9, "an integer from 0 to 1e9"};
constexpr NumberDomain smoothing_domain{0.0, 500.0, "a number of pixels from 0 to 500"};
constexpr double min_pressure = 0.02;  // a radius is never 0

// The brush that lays such a Gaussian. One that is longer than wide lies along a stroke; balls,
// which begin one, say nothing about its stretch.
struct Picked {
  double radius;
  std::optional<double> stretch;
};

Picked picked(const Gaussian& gaussian) {
  constexpr double rounding = 1e-3;  // as wide as thick, in files of floats, too
  std::array<double, 3> radii{gaussian.radii().x, gaussian.radii().y, gaussian.radii().z};
  std::ranges::sort(radii);
  if (gaussian.is_ball() || radii[1] > (1.0 + rounding) * radii[0]) {
    return {gaussian.mean_radius(), std::nullopt};
  }
  const NumberDomain& domain = domain::brush_stretch;
  return {radii[0], std::clamp(radii[2] / radii[0], domain.min_value, domain.max_value)};
}

}  // namespace

FogBrushTool::FogBrushTool(Document& document, View& view) : BrushTool(document, view) {
  on_change(document, Change::scene, this,
            [this] { fit_to(target_distance(document_.scene().camera)); });
}

void FogBrushTool::set_target(const PaintTarget& target) {
  target_ = target;
  Q_EMIT options_changed();
}

void FogBrushTool::set_plane(PaintPlane plane) {
  PaintTarget target = target_;
  target.plane = plane;
  set_target(target);
}

void FogBrushTool::set_stroke_options(const StrokeOptions& options) {
  stroke_options_ = options;
  Q_EMIT options_changed();
}

BrushPreset FogBrushTool::common_preset() const {
  BrushPreset preset;
  preset.size = radius() / view_distance();
  preset.depth = std::sqrt(std::numbers::pi) * radius() * density();
  preset.smoothing = stroke_options_.smoothing;
  return preset;
}

void FogBrushTool::apply_common(const BrushPreset& preset) {
  stroke_options_.smoothing = preset.smoothing;
  fit_gaussian(preset.size * view_distance(), preset.depth);
  Q_EMIT options_changed();
}

void FogBrushTool::fit_gaussian(double radius, double depth) {
  const double rounded_radius = two_digits(radius);
  set_gaussian(rounded_radius, two_digits(depth / (std::sqrt(std::numbers::pi) * rounded_radius)));
}

double FogBrushTool::view_distance() const {
  return std::max(view().distance(), 1e-6);
}

FogBrushTool::PenScale FogBrushTool::pen_scale(double fraction) const {
  const double pressure = std::max(pressure_at(fraction), min_pressure);
  const PenUse pen = stroke_options_.pen;
  return {pen == PenUse::size || pen == PenUse::both ? pressure : 1.0,
          pen == PenUse::density || pen == PenUse::both ? pressure : 1.0};
}

MirrorPlanes FogBrushTool::mirror_planes() const {
  return {stroke_options_.mirrors,
          stroke_options_.mirrors_at_pivot ? view().camera().target : glm::dvec3(0.0)};
}

void FogBrushTool::append_images(std::vector<Gaussian>& images, const Gaussian& gaussian,
                                 bool all) const {
  append_images(images, gaussian, mirror_planes(), all);
}

void FogBrushTool::append_images(std::vector<Gaussian>& images, const Gaussian& gaussian,
                                 const MirrorPlanes& planes, bool all) const {
  constexpr double same = 0.05;  // of the radius: one on the plane is painted once
  const Gaussian first = coloured(gaussian);
  std::size_t own_index = 0;
  for (const Gaussian& image : mirror_images(first, planes)) {
    const bool coincides =
        std::any_of(images.end() - static_cast<std::ptrdiff_t>(own_index), images.end(),
                    [&](const Gaussian& other) {
                      return glm::distance(image.center, other.center) < same * first.radius;
                    });
    if (!all && coincides) continue;
    images.push_back(image);
    ++own_index;
  }
}

std::optional<PaintPoint> FogBrushTool::paint_at(QPointF position) const {
  return paint_point(view(), target_, position, offset(),
                     gesture_.is_running() ? depth_ : std::nullopt);
}

std::optional<PaintPoint> FogBrushTool::extend_to(QPointF position) {
  const auto point = paint_at(position);
  if (!point) return point;
  if (depth_) {
    has_jumped_ = is_depth_jump(view().rays(), depth_->last, *point, radius());
    depth_->extend(*point);
  } else {
    depth_.emplace(*point);
    has_jumped_ = false;
  }
  return point;
}

// The cursor also where strokes are mirrored to.
void FogBrushTool::draw(Overlay& overlay, const CameraRays& rays) const {
  if (!cursor_position()) return;
  const auto point = paint_at(*cursor_position());
  if (!point) return;
  const Gaussian laid{point->position, radius(), click_density()};
  add_brush_cursor(overlay, rays, view().surfaces(), laid, point->normal);
  if (!gesture_.is_running()) add_ghost(overlay, rays, view().surfaces(), laid, color());
  if (stroke_options_.mirrors == std::array<bool, 3>{}) return;
  for (const Gaussian& image : mirror_images({point->position, radius(), 1.0}, mirror_planes())) {
    if (image.center == point->position) continue;
    overlay.add_outline(rays, image, qRgba(235, 238, 242, 130));
  }
}

void FogBrushTool::press(QPointF position, Qt::KeyboardModifiers modifiers) {
  if (!modifiers.testFlag(Qt::AltModifier)) {
    if (const QString problem = adding_problem(document_); !problem.isEmpty()) {
      Q_EMIT refused(problem);
      return;
    }
    depth_.reset();
    BrushTool::press(position, modifiers);
    return;
  }
  if (const auto id = view().max_visible(position)) {
    const Gaussian gaussian = document_.medium().gaussian(*document_.medium().index_of(*id));
    optics_ = gaussian.optics;
    const Picked brush = picked(gaussian);
    if (brush.stretch) set_stretch(*brush.stretch);
    set_both(brush.radius, gaussian.density);
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
  add_preset_button(row, *this, prefix);
  add_number(
      row, *this, {tr("Radius"), prefix + "_radius", domain::length, Scale::logarithmic, 0.01},
      [this] { return radius(); }, [this](double value) { set_both(value, density()); })
      ->number()
      .show_length_unit();
  add_number(
      row, *this, {tr("Density"), prefix + "_density", domain::density, Scale::logarithmic, 0.01},
      [this] { return density(); }, [this](double value) { set_both(radius(), value); });
  add_optics_button(row, prefix);
}

void FogBrushTool::add_optics_button(QHBoxLayout& row, const QString& prefix) {
  auto* button = named(new QToolButton, prefix + "_colours");
  button->setText(tr("Colours"));
  button->setToolTip(tr("Albedo and emission of what is added: coloured smoke, fire"));
  button->setPopupMode(QToolButton::InstantPopup);
  button->setMenu(new QMenu(button));
  auto* panel = new QWidget(button);
  // It is coloured as panels are: on a menu's ground an empty box would not be seen.
  panel->setBackgroundRole(QPalette::Window);
  panel->setAutoFillBackground(true);
  auto* form = new QFormLayout(panel);
  form->setContentsMargins(8, 8, 8, 8);
  auto* editor = new OpticsEditor(*form, tr("Emission"), prefix, panel);
  auto* action = new QWidgetAction(button);
  action->setDefaultWidget(panel);
  button->menu()->addAction(action);
  row.addWidget(button);
  const auto show = [this, editor, button] {
    editor->show_optics(optics_, document_.scene().optics.albedo);
    button->setIcon(color_swatch(color()));
  };
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(this, &Tool::options_changed, editor, show);
  on_change(document_, Change::part, editor, show);
  connect(editor, &OpticsEditor::edited, this, [this](const OpticsEditor::Change& change) {
    change(optics_);
    Q_EMIT options_changed();
  });
  show();
}

glm::dvec3 FogBrushTool::color() const {
  return emission_strength(optics_.emission) > 0.0
             ? emission_color(optics_.emission)
             : optics_.albedo.value_or(document_.scene().optics.albedo);
}

Gaussian FogBrushTool::coloured(const Gaussian& gaussian) const {
  Gaussian result = within_domains(gaussian);
  result.optics = optics_;
  result.group = group_of_new(document_);
  return result;
}

StrokeNumber FogBrushTool::number_of(double& value, const NumberOption& option,
                                     const QString& tip) {
  return {option, tip, [&value] { return value; },
          [this, &value](double chosen) {
            value = chosen;
            Q_EMIT options_changed();
          }};
}

void FogBrushTool::add_place_options(QHBoxLayout& row, const QString& prefix,
                                     std::vector<StrokeNumber> numbers) {
  using Scale = ValueField::Scale;
  numbers.push_back(
      number_of(stroke_options_.smoothing,
                {tr("Smoothing, px"), prefix + "_smoothing", smoothing_domain, Scale::linear, 1.0},
                tr("How far the brush trails behind the mouse, in pixels: steadier lines")));
  numbers.push_back({{tr("Seed"), prefix + "_seed", seed_domain, Scale::linear, 1.0},
                     tr("Another number makes other random offsets"),
                     [this] { return static_cast<double>(seed_); },
                     [this](double value) {
                       seed_ = static_cast<int>(std::round(value));
                       Q_EMIT options_changed();
                     }});
  add_stroke_options_button(row, *this, prefix, numbers);
  add_target(
      row, *this, prefix, [this] { return target_; },
      [this](const PaintTarget& target) { set_target(target); });
}

QString FogBrushTool::stretch_tip() {
  return tr(
      "How much longer Gaussians are along their way than across it: 1 lays balls, more as many "
      "times fewer ellipsoids");
}

std::uint64_t FogBrushTool::stroke_seed() const {
  return static_cast<std::uint64_t>(seed_) * 0x9e3779b97f4a7c15U + document_.medium().next_id();
}

double two_digits(double value) {
  return rounded(value, 2);
}

}  // namespace brume
