#include "app/tools/brushes/airbrush_tool.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/tools/option_widgets.h"
#include "app/view/camera/navigation.h"
#include "app/view/surface_picker.h"
#include "app/view/view.h"
#include "core/number_domain.h"

namespace brume {
namespace {

constexpr qint64 steps_per_second = 30;
constexpr qint64 max_steps = 20 * steps_per_second;  // at once: the computer may have slept
constexpr NumberDomain rate_domain{0.0, 1e4, "a number from 0 to 10000"};

// The members that presets have as they are, and those relative to the distance of the view.
constexpr std::array kept_by_airbrush{std::pair(&BrushPreset::jitter, &Airbrush::jitter),
                                      std::pair(&BrushPreset::stretch, &Airbrush::stretch),
                                      std::pair(&BrushPreset::rate, &Airbrush::rate),
                                      std::pair(&BrushPreset::spread, &Airbrush::spread)};
constexpr std::array relative{std::pair(&BrushPreset::speed, &Airbrush::speed),
                              std::pair(&BrushPreset::wander, &Airbrush::wander)};

qint64 now() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

AirbrushTool::AirbrushTool(Document& document, View& view)
    : FogBrushTool(document, view), clock_(now) {
  timer_.setInterval(static_cast<int>(1000 / steps_per_second));
  connect(&timer_, &QTimer::timeout, this, &AirbrushTool::spray);
  AirbrushTool::fit_to(target_distance(document.scene().camera));
}

void AirbrushTool::set_airbrush(const Airbrush& airbrush) {
  airbrush_ = airbrush;
  Q_EMIT options_changed();
}

void AirbrushTool::set_gaussian(double radius, double density) {
  airbrush_.radius = radius;
  airbrush_.density = density;
}

void AirbrushTool::set_inside(bool inside) {
  inside_ = inside;
  Q_EMIT options_changed();
}

QString AirbrushTool::hint() const {
  return tr(
      "Hold to spray fog that bounces off surfaces; release to leave it in place. Inside fills a "
      "closed mesh.");
}

void AirbrushTool::add_options(QHBoxLayout& row) {
  using Scale = ValueField::Scale;
  const auto add = [&](double& value, const QString& title, const char* name,
                       const NumberDomain& domain) {
    const StrokeNumber number = number_of(value, {title, name, domain, Scale::logarithmic, 0.01});
    add_number(row, *this, number.option, number.get, number.set);
  };
  add_gaussian_options(row, "air");
  add(airbrush_.rate, tr("Rate"), "air_rate", rate_domain);
  add(airbrush_.speed, tr("Speed"), "air_speed", domain::not_negative);
  add_place_options(
      row, "air",
      {number_of(airbrush_.stretch,
                 {tr("Stretch"), "air_stretch", domain::brush_stretch, Scale::logarithmic, 0.01},
                 stretch_tip()),
       number_of(airbrush_.jitter, {tr("Jitter"), "air_jitter", domain::unit, Scale::linear, 0.01},
                 tr("Random variation of radius and density: at 1 from half to double"))});
  add_choice(
      row, *this, {{}, "air_side"}, {tr("Outside"), tr("Inside")},
      [this] { return inside_ ? 1 : 0; }, [this](int index) { set_inside(index == 1); });
}

void AirbrushTool::begin_stroke(QPointF position) {
  spray_.emplace(airbrush_, stroke_seed());
  ids_.clear();
  way_ = {position};
  steps_ = 0;
  begun_ = clock_();
  timer_.start();
}

void AirbrushTool::extend_stroke(std::span<const QPointF> curve) {
  way_.insert(way_.end(), curve.begin(), curve.end());
  spray();
}

void AirbrushTool::end_stroke() {
  timer_.stop();
}

void AirbrushTool::spray() {
  const qint64 due = (clock_() - begun_) * steps_per_second / 1000;
  const qint64 missed = std::min(due - steps_, max_steps);
  steps_ = due;
  if (missed <= 0) return;
  const auto obstacle = [this](const glm::dvec3& origin,
                               const glm::dvec3& way) -> std::optional<Obstacle> {
    const auto hit = view().surfaces().hit(origin, way);
    if (!hit) return std::nullopt;
    return Obstacle{glm::distance(hit->position, origin), hit->normal};
  };
  const PenScale pen = pen_scale(1.0);
  spray_->set_scale(pen.size, pen.strength);
  for (qint64 k = 0; k < missed; ++k) {
    const auto nozzle = [&](double moment) {
      return nozzle_at((static_cast<double>(k) + moment) / static_cast<double>(missed));
    };
    spray_->advance(1.0 / steps_per_second, nozzle, obstacle);
  }
  way_ = {way_.back()};
  std::vector<Gaussian> gaussians;
  for (const Gaussian& gaussian : spray_->frozen()) append_images(gaussians, gaussian, true);
  const std::span<const Gaussian> all(gaussians);
  const Medium& medium = document_.medium();
  MediumEdit edit = MediumEdit::change(medium, ids_, all.first(ids_.size()));
  edit.merge(MediumEdit::add(medium, all.subspan(ids_.size())));
  for (const MediumEdit::Entry& entry : edit.added()) ids_.push_back(entry.id);
  gesture_.apply(std::move(edit), tr("Spray %1").arg(gaussians_text(gaussians.size())));
}

std::optional<Nozzle> AirbrushTool::nozzle_at(double fraction) {
  const double place = fraction * static_cast<double>(way_.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), way_.size() - 1);
  const auto after = std::min(before + 1, way_.size() - 1);
  const double share = place - static_cast<double>(before);
  const auto point = extend_to(way_[before] + share * (way_[after] - way_[before]));
  if (!point) return std::nullopt;
  const glm::dvec3 direction = inside_ ? -point->normal : point->normal;
  // Off the surface, on the side that is sprayed.
  return Nozzle{point->position + 0.05 * airbrush_.radius * direction, direction};
}

BrushPreset AirbrushTool::preset() const {
  BrushPreset preset = common_preset();
  preset.sprays = true;
  for (const auto& [of_preset, of_brush] : kept_by_airbrush)
    preset.*of_preset = airbrush_.*of_brush;
  for (const auto& [of_preset, of_brush] : relative) {
    preset.*of_preset = airbrush_.*of_brush / view_distance();
  }
  return preset;
}

void AirbrushTool::apply_preset(const BrushPreset& preset) {
  airbrush_ = {};
  for (const auto& [of_preset, of_brush] : kept_by_airbrush)
    airbrush_.*of_brush = preset.*of_preset;
  for (const auto& [of_preset, of_brush] : relative) {
    airbrush_.*of_brush = two_digits(preset.*of_preset * view_distance());
  }
  apply_common(preset);
}

void AirbrushTool::fit_to(double distance) {
  fit_gaussian(0.04 * distance, 0.3);
  airbrush_.speed = two_digits(0.2 * distance);
  airbrush_.wander = two_digits(0.1 * distance);
  Q_EMIT options_changed();
}

}  // namespace brume
