#include "app/tools/brushes/eraser_tool.h"
#include "core/number_domain.h"
#include "core/scene/camera_rays.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/tools/option_widgets.h"
#include "app/view/drawing/overlay.h"
#include "app/view/view.h"
#include "app/widgets/application.h"

namespace brume {
namespace {

constexpr NumberDomain strength_domain{0.01, 1.0, "a number from 0.01 to 1"};
constexpr double touch_spacing = 0.25;  // over the radius

}  // namespace

QString EraserTool::hint() const {
  return tr(
      "Drag to thin the fog; Gaussians of zero density are deleted. [ and ] change the radius, "
      "with Shift the strength.");
}

void EraserTool::add_options(QHBoxLayout& row) {
  add_number(
      row, *this,
      {tr("Radius, px"), "eraser_radius", screen_radius_domain, ValueField::Scale::logarithmic,
       0.01},
      [this] { return radius_; }, [this](double value) { set(value, strength_); });
  add_number(
      row, *this,
      {tr("Strength"), "eraser_strength", strength_domain, ValueField::Scale::linear, 0.01},
      [this] { return strength_; }, [this](double value) { set(radius_, value); });
}

void EraserTool::change_size(double factor) {
  set(radius_ * factor, strength_);
}

void EraserTool::change_strength(double factor) {
  set(radius_, strength_ * factor);
}

void EraserTool::set(double radius, double strength) {
  radius_ = std::clamp(radius, screen_radius_domain.min_value, screen_radius_domain.max_value);
  strength_ = std::clamp(strength, strength_domain.min_value, strength_domain.max_value);
  Q_EMIT options_changed();
}

void EraserTool::draw_on_film(Overlay& overlay) const {
  if (const auto& center = cursor_position()) {
    overlay.add_circle(center->x(), center->y(), radius_, accent_color().rgba());
  }
}

void EraserTool::begin_stroke(QPointF position) {
  stroke_.emplace(strength_);
  last_touch_ = position;
  touch({position});
}

void EraserTool::extend_stroke(std::span<const QPointF> curve) {
  // Touches at equal distances, however often the mouse is heard.
  const double spacing = touch_spacing * radius_;
  std::vector<QPointF> places;
  for (const QPointF position : curve) {
    while (QLineF(last_touch_, position).length() >= spacing) {
      const QPointF way = position - last_touch_;
      last_touch_ += way * (spacing / QLineF(last_touch_, position).length());
      places.push_back(last_touch_);
    }
  }
  touch(places);
}

void EraserTool::touch(const std::vector<QPointF>& places) {
  const CameraRays rays = view().rays();
  std::vector<EraserCone> cones;
  cones.reserve(places.size());
  for (const QPointF place : places) {
    cones.push_back({rays.origin(place.x(), place.y()), rays.direction(place.x(), place.y()),
                     cone_slope(rays), radius_ * rays.pixel_width()});
  }
  MediumEdit edit = stroke_->touch(document_.medium(), cones,
                                   [this](GaussianId id) { return document_.is_editable(id); });
  gesture_.apply(std::move(edit), [](const MediumEdit& all) {
    return tr("Erase %1").arg(gaussians_text(all.changed().size() + all.removed().size()));
  });
}

double EraserTool::cone_slope(const CameraRays& rays) const {
  return radius_ * std::tan(2.0 * rays.pixel_half_angle());
}

}  // namespace brume
