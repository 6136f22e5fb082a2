#include "app/panels/plots/contribution_panel.h"
#include "core/scene/camera_rays.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/commands/gaussians/select_command.h"
#include "app/commands/objects/edit_lights.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/object_titles.h"
#include "app/document/text/number_text.h"
#include "app/view/surface_picker.h"
#include "app/view/view.h"
#include "app/widgets/application.h"
#include "app/widgets/color_button.h"
#include "core/math/infinity.h"
#include "core/scene/lights/photometry.h"
#include "core/scene/lights/point_lights.h"
#include "render/prepare/fog_extent.h"

namespace brume {
namespace {

constexpr int look_after = 40;        // milliseconds
constexpr std::size_t max_met = 100;  // Gaussians in the list
constexpr double deepest = 4.0;       // optical depth of a full bar
constexpr int title_width = 104;
constexpr int number_width = 64;

QString name_of(GaussianId id) {
  return ContributionPanel::tr("Gaussian %1").arg(id);
}

}  // namespace

ContributionPanel::ContributionPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setMinimumHeight(100);
  timer_.setSingleShot(true);
  timer_.setInterval(look_after);
  connect(&timer_, &QTimer::timeout, this, &ContributionPanel::compute);
  const auto again = [this] { timer_.start(); };
  on_change(document_, Change::scene | Change::medium | Change::part | Change::selection, this,
            again);
}

void ContributionPanel::inspect(View& view, QPointF position) {
  view_ = &view;
  position_ = position;
  if (!timer_.isActive()) timer_.start();
}

void ContributionPanel::compute() {
  if (!isVisible() || !view_) return;
  facts_.reset();
  update();
  const CameraRays rays = view_->rays();
  const glm::dvec3 origin = rays.origin(position_.x(), position_.y());
  const glm::dvec3 direction = rays.direction(position_.x(), position_.y());
  const auto surface = view_->surfaces().hit_in_view(rays, origin, direction);
  const auto scene = view_->shown_scene();
  const FogBall near_fog = fog_of(*scene);
  const FogInterval in_fog = near_fog.interval(origin, direction);
  const std::vector<Contribution> met = contributions(
      scene->medium, scene->optics.albedo, origin, direction,
      surface ? glm::distance(surface->position, origin) : std::numeric_limits<double>::infinity(),
      1e-3, {in_fog.begin, in_fog.end});
  if (met.empty()) return;

  const auto id = [&](const Contribution& c) { return scene->medium.ids()[c.index]; };
  const auto selected =
      std::ranges::find_if(met, [&](const auto& c) { return document_.is_selected(id(c)); });
  Facts facts;
  facts.contribution = selected != met.end() ? *selected : met.front();
  facts.id = id(facts.contribution);
  for (std::size_t k = 0; k < std::min(met.size(), max_met); ++k) {
    facts.met.emplace_back(id(met[k]), met[k]);
  }
  const glm::dvec3 place = origin + facts.contribution.distance * direction;
  // Both read all vertices.
  const bool has_far_light = std::ranges::any_of(
      scene->lights, [](const Light& light) { return light.as<light::Directional>() != nullptr; });
  const LitRegion region = has_far_light ? LitRegion::of(*scene) : LitRegion();
  const FogBall fog = has_far_light ? FogExtent(*scene).ball() : FogBall();
  for (std::size_t k = 0; k < scene->lights.size(); ++k) {
    if (!scene->lights[k].on) continue;
    glm::dvec3 radiance(0.0);
    for (const PointLight& light : point_lights(scene->lights[k], region, LightPoints::few)) {
      const double distance = glm::distance(light.position, place);
      if (!(distance > 0.0)) continue;
      const glm::dvec3 to_light = (light.position - place) / distance;
      const auto between = view_->surfaces().hit(place, to_light);
      if (between && glm::distance(between->position, place) < distance) continue;
      const double fog_length = (light.is_far ? fog : near_fog).length(place, to_light, distance);
      radiance +=
          scattered_radiance(*scene, facts.contribution, origin, direction, light, fog_length);
    }
    facts.lights.push_back(
        {light_title(scene->lights[k], k), to_color(light_color(scene->lights[k])), radiance});
  }
  facts_ = std::move(facts);
}

int ContributionPanel::row_height() const {
  return fontMetrics().height() + 5;
}

void ContributionPanel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QColor text = palette().color(QPalette::WindowText);
  painter.setPen(text);
  const QRect inside = rect().adjusted(8, 6, -8, -4);
  if (!facts_) {
    painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                     tr("Point at fog to see what each Gaussian contributes to the pixel."));
    return;
  }
  int y = inside.top();
  const auto row = [&](const QString& title, double share, const QString& number,
                       const QColor& color) {
    const QRect line(inside.left(), y, inside.width(), row_height());
    painter.setPen(text);
    painter.drawText(line.adjusted(0, 0, title_width - line.width(), 0), Qt::AlignVCenter,
                     fontMetrics().elidedText(title, Qt::ElideRight, title_width - 4));
    painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, number);
    const QRect bar = line.adjusted(title_width, 4, -number_width, -4);
    painter.fillRect(bar, palette().base());
    const int width = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * bar.width()));
    painter.fillRect(bar.left(), bar.top(), width, bar.height(), color);
    y += row_height();
  };
  const Facts& f = *facts_;
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(
      inside.left(), y, inside.width(), row_height(), Qt::AlignVCenter,
      document_.is_selected(f.id) ? tr("%1, selected").arg(name_of(f.id)) : name_of(f.id));
  painter.setFont(font());
  y += row_height();
  const QColor plain = palette().color(QPalette::PlaceholderText);
  const double optical_depth = luminance(f.contribution.optical_depth);
  row(tr("Optical depth"), optical_depth / deepest, number_text(optical_depth, 3), plain);
  row(tr("Attenuates"), f.contribution.fraction, percent_text(f.contribution.fraction), plain);
  const glm::dvec3& emitted = f.contribution.emitted;
  double max_value = luminance(emitted);
  for (const LightShare& light : f.lights)
    max_value = std::max(max_value, luminance(light.radiance));
  const auto radiance_row = [&](const QString& title, const glm::dvec3& rgb, const QColor& color) {
    const double radiance = luminance(rgb);
    row(title, max_value > 0.0 ? radiance / max_value : 0.0, number_text(radiance, 3), color);
  };
  if (emitted != glm::dvec3(0.0)) {
    radiance_row(tr("Emission"), emitted, to_color(emission_color(emitted)));
  }
  for (const LightShare& light : f.lights) radiance_row(light.name, light.radiance, light.color);
  y += 4;
  painter.drawText(inside.left(), y, inside.width(), row_height(), Qt::AlignVCenter,
                   tr("%n Gaussian(s) on this ray", nullptr, static_cast<int>(f.met.size())));
  y += row_height();
  first_met_row_ = y;
  for (const auto& [id, met] : f.met) {
    if (y + row_height() > height()) break;
    const bool shines = met.effect() > met.fraction;  // more than it attenuates
    const QColor color = shines ? to_color(emission_color(met.emitted)) : plain;
    row(name_of(id), met.effect(),
        shines ? number_text(met.effect(), 3) : percent_text(met.fraction),
        document_.is_selected(id) ? accent_color() : color);
  }
}

void ContributionPanel::mousePressEvent(QMouseEvent* event) {
  if (!facts_ || event->position().y() < first_met_row_) return;
  const auto k = static_cast<std::size_t>((event->position().y() - first_met_row_) / row_height());
  if (k < facts_->met.size()) select_gaussians(document_, {facts_->met[k].first});
}

}  // namespace brume
