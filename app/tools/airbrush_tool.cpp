#include "app/tools/airbrush_tool.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/document/document.h"
#include "app/document/gaussian_field.h"
#include "app/tools/option_widgets.h"
#include "app/viewport/navigation.h"
#include "app/viewport/viewport.h"

namespace brume {
namespace {

constexpr double step = 1.0 / 30.0;  // seconds
constexpr int most_steps = 6;        // at once, however long a picture took
constexpr NumberDomain rate_domain{0.0, 1e4, "a number from 0 to 10000"};
constexpr NumberDomain seed_domain{0.0, 1e9, "a whole number from 0 to 1e9"};

}  // namespace

AirbrushTool::AirbrushTool(Document& document, Viewport& viewport) : BrushTool(document, viewport) {
  timer_.setInterval(static_cast<int>(1000.0 * step));
  connect(&timer_, &QTimer::timeout, this, &AirbrushTool::spray);
  connect(&document, &Document::scene_replaced, this, &AirbrushTool::fit_to_view);
  fit_to_view();
}

void AirbrushTool::set_airbrush(const Airbrush& airbrush) {
  airbrush_ = airbrush;
  airbrush_.radius = std::clamp(airbrush.radius, domain::length.least, domain::length.greatest);
  airbrush_.density = std::clamp(airbrush.density, domain::density.least, domain::density.greatest);
  Q_EMIT options_changed();
}

void AirbrushTool::set_plane(PaintPlane plane) {
  plane_ = plane;
  Q_EMIT options_changed();
}

void AirbrushTool::set_inside(bool inside) {
  inside_ = inside;
  Q_EMIT options_changed();
}

QString AirbrushTool::hint() const {
  return tr(
      "Hold to spray fog that bounces off the surfaces; it stays where it is when you let "
      "go. Inside fills a closed mesh.");
}

void AirbrushTool::add_options(QHBoxLayout& row) {
  using Scale = ValueField::Scale;
  const auto add = [&](const QString& title, const char* name, const NumberDomain& domain,
                       Scale scale, double field_step, double Airbrush::*number) {
    add_number(
        row, *this, {title, name, domain, scale, field_step},
        [this, number] { return airbrush_.*number; },
        [this, number](double value) {
          airbrush_.*number = value;
          Q_EMIT options_changed();
        });
  };
  add(tr("Radius"), "air_radius", domain::length, Scale::logarithmic, 0.01, &Airbrush::radius);
  add(tr("Density"), "air_density", domain::density, Scale::logarithmic, 0.01, &Airbrush::density);
  add(tr("Rate"), "air_rate", rate_domain, Scale::logarithmic, 0.01, &Airbrush::rate);
  add(tr("Speed"), "air_speed", domain::not_negative, Scale::logarithmic, 0.01, &Airbrush::speed);
  add_number(
      row, *this, {tr("Seed"), "air_seed", seed_domain, Scale::linear, 1.0},
      [this] { return static_cast<double>(seed_); },
      [this](double value) {
        seed_ = static_cast<int>(std::round(value));
        Q_EMIT options_changed();
      });
  add_choice(
      row, *this, {tr("On"), "air_plane"}, {tr("View plane"), tr("Ground"), tr("Surfaces")},
      [this] { return static_cast<int>(plane_); },
      [this](int index) { set_plane(static_cast<PaintPlane>(index)); });
  add_choice(
      row, *this, {{}, "air_side"}, {tr("Outside"), tr("Inside")},
      [this] { return inside_ ? 1 : 0; }, [this](int index) { set_inside(index == 1); });
}

void AirbrushTool::change_size(double factor) {
  Airbrush airbrush = airbrush_;
  airbrush.radius *= factor;
  set_airbrush(airbrush);
}

void AirbrushTool::change_strength(double factor) {
  Airbrush airbrush = airbrush_;
  airbrush.density *= factor;
  set_airbrush(airbrush);
}

void AirbrushTool::begin_stroke(QPointF position) {
  spray_.emplace(airbrush_, static_cast<std::uint64_t>(seed_) * 0x9e3779b97f4a7c15U +
                                document_.medium().next_id());
  nozzle_.reset();
  ids_.clear();
  extend_stroke(position);
  steps_ = 0;
  clock_.start();
  timer_.start();
}

void AirbrushTool::extend_stroke(QPointF position) {
  nozzle_ = paint_at(position);
}

void AirbrushTool::end_stroke() {
  timer_.stop();
}

void AirbrushTool::spray() {
  const auto due = static_cast<qint64>(1e-3 * static_cast<double>(clock_.elapsed()) / step);
  const auto missed = std::min<qint64>(due - steps_, most_steps);
  steps_ = due;
  if (!nozzle_) return;
  const glm::dvec3 direction = inside_ ? -nozzle_->normal : nozzle_->normal;
  // Off the surface, on the side that is sprayed.
  const glm::dvec3 from = nozzle_->position + 0.05 * airbrush_.radius * direction;
  const auto obstacle = [this](const glm::dvec3& origin,
                               const glm::dvec3& way) -> std::optional<Obstacle> {
    const auto hit = view().surfaces().hit(origin, way);
    if (!hit) return std::nullopt;
    return Obstacle{glm::distance(hit->position, origin), hit->normal};
  };
  for (qint64 k = 0; k < missed; ++k) spray_->advance(step, from, direction, obstacle);
  std::vector<Gaussian> gaussians = spray_->frozen();
  for (Gaussian& gaussian : gaussians) gaussian = within_domains(gaussian);
  const std::span<const Gaussian> all(gaussians);
  const Medium& medium = document_.medium();
  MediumEdit edit = MediumEdit::change(medium, ids_, all.first(ids_.size()));
  edit.merge(MediumEdit::add(medium, all.subspan(ids_.size())));
  for (const MediumEdit::Entry& entry : edit.added()) ids_.push_back(entry.id);
  gesture_.apply(std::move(edit), tr("Spray %1").arg(gaussians_text(gaussians.size())));
}

void AirbrushTool::fit_to_view() {
  Airbrush airbrush = airbrush_;
  const auto rounded = [](double value) { return QString::number(value, 'g', 2).toDouble(); };
  const double distance = target_distance(document_.scene().camera);
  airbrush.radius = rounded(0.04 * distance);
  airbrush.density = rounded(0.3 / (std::sqrt(std::numbers::pi) * airbrush.radius));
  airbrush.speed = rounded(0.2 * distance);
  airbrush.wander = rounded(0.1 * distance);
  set_airbrush(airbrush);
}

}  // namespace brume
