#include "app/view/drawing/overlay.h"
#include "core/scene/camera_rays.h"

#include <QLineF>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "app/widgets/interface_settings.h"
#include "core/math/basis.h"

namespace brume {
namespace {

double film_distance(const glm::dvec3& a, const glm::dvec3& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// So many that an ellipse of a diameter [pixels] is at most a tenth of a pixel from them, where 64
// suffice for that. Thousands of outlines are drawn, most of them small.
int outline_segments(double diameter) {
  constexpr double max_distance = 0.1;
  const double half = std::max(0.5 * diameter, 1.0);
  const double segments = glm::pi<double>() * std::sqrt(half / (2.0 * max_distance));
  return segments < 64.0 ? std::max(12, static_cast<int>(std::ceil(segments))) : 64;
}

// From the space in which an ellipsoid is a ball.
glm::dmat3 inverse_warp(const GaussianShape& shape) {
  const glm::dmat3 axes = glm::mat3_cast(shape.rotation);
  glm::dmat3 scaled = axes;
  for (int k = 0; k < 3; ++k) scaled[k] *= shape.stretch[k];
  return scaled * glm::transpose(axes);
}

}  // namespace

float Overlay::dot_size() {
  return 3.0F * static_cast<float>(handle_scale());
}

float Overlay::mark_size() {
  return 5.0F * static_cast<float>(handle_scale());
}

float Overlay::line_width() {
  return 1.25F * static_cast<float>(handle_scale());
}

void Overlay::add_circle(double x, double y, double radius, QRgb color) {
  const int segments = std::clamp(static_cast<int>(radius * 2.0), 12, 64);
  const auto point_at = [&](int k) {
    const double angle = glm::two_pi<double>() * k / segments;
    return Vertex{static_cast<float>(x + radius * std::cos(angle)),
                  static_cast<float>(y + radius * std::sin(angle)), color};
  };
  for (int k = 0; k < segments; ++k) {
    lines.push_back(point_at(k));
    lines.push_back(point_at(k + 1));
  }
}

void Overlay::add_line(const CameraRays& rays, const glm::dvec3& start, const glm::dvec3& end,
                       QRgb color) {
  const glm::dvec3 a = rays.project(start);
  const glm::dvec3 b = rays.project(end);
  if (a.z <= 0.0 || b.z <= 0.0) return;
  lines.push_back({static_cast<float>(a.x), static_cast<float>(a.y), color});
  lines.push_back({static_cast<float>(b.x), static_cast<float>(b.y), color});
}

void Overlay::add_outline(const CameraRays& rays, const Gaussian& gaussian, QRgb color,
                          const std::function<bool(const glm::dvec3&)>& is_hidden) {
  const bool is_ball = gaussian.is_ball();
  const double radius = gaussian.radius;
  // An ellipsoid in the space in which it is a ball, as what is seen of it touches the same rays.
  const glm::dvec3 towards = rays.is_parallel() ? rays.forward() : gaussian.center - rays.eye();
  const glm::dvec3 view = is_ball ? towards : warp(gaussian.shape) * towards;
  const double distance = glm::length(view);
  if (!rays.is_parallel() && !(distance > radius)) return;
  // The circle in which the cone from the eye, or the cylinder of parallel rays, touches the ball,
  // around the center.
  const glm::dvec3 axis = view / distance;
  const double sine = rays.is_parallel() ? 0.0 : radius / distance;
  const double circle = radius * std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const Basis plane = make_basis(axis);
  glm::dmat3 frame(circle * plane.u, circle * plane.v, axis * (-radius * sine));
  if (!is_ball) frame = inverse_warp(gaussian.shape) * frame;
  const glm::dvec3 middle = gaussian.center + frame[2];
  const auto place_at = [&](double turn) {
    const double angle = glm::two_pi<double>() * turn;
    return middle + std::cos(angle) * frame[0] + std::sin(angle) * frame[1];
  };
  const auto point_at = [&](double turn) { return rays.project(place_at(turn)); };
  glm::dvec3 last = point_at(0.0);
  const int segments = outline_segments(
      std::max(film_distance(last, point_at(0.5)), film_distance(point_at(0.25), point_at(0.75))));
  for (int k = 1; k <= segments; ++k) {
    const glm::dvec3 place = place_at(static_cast<double>(k) / segments);
    const glm::dvec3 next = rays.project(place);
    const bool is_gap = k % 2 == 0 && is_hidden && is_hidden(place);
    if (last.z > 0.0 && next.z > 0.0 && !is_gap) {
      lines.push_back({static_cast<float>(last.x), static_cast<float>(last.y), color});
      lines.push_back({static_cast<float>(next.x), static_cast<float>(next.y), color});
    }
    last = next;
  }
}

void add_axes(Overlay& overlay, const CameraRays& rays, const Film& film) {
  constexpr double length = 26.0;
  const glm::dvec3 forward = rays.forward();
  // Right and up of the film, from rays through it: CameraRays keeps its own to itself.
  const auto point_at = [&](double x, double y) {
    const glm::dvec3 d = rays.direction(x, y);
    return rays.offset(x, y) + d / glm::dot(d, forward);
  };
  const double cx = 0.5 * film.width;
  const double cy = 0.5 * film.height;
  const glm::dvec3 right = glm::normalize(point_at(cx + 1.0, cy) - point_at(cx, cy));
  const glm::dvec3 up = glm::normalize(point_at(cx, cy - 1.0) - point_at(cx, cy));
  const float x = 38.0F;
  const float y = static_cast<float>(film.height) - 38.0F;
  struct Axis {
    glm::dvec3 direction;
    QRgb color;
  };
  std::array<Axis, 3> axes{{{{1, 0, 0}, qRgba(226, 92, 92, 230)},
                            {{0, 1, 0}, qRgba(126, 196, 92, 230)},
                            {{0, 0, 1}, qRgba(96, 146, 236, 230)}}};
  // Far ends first, so that the axis towards the eye is on top.
  std::sort(axes.begin(), axes.end(), [&](const Axis& a, const Axis& b) {
    return glm::dot(a.direction, forward) > glm::dot(b.direction, forward);
  });
  for (const Axis& axis : axes) {
    const auto ex = static_cast<float>(x + length * glm::dot(axis.direction, right));
    const auto ey = static_cast<float>(y - length * glm::dot(axis.direction, up));
    overlay.lines.push_back({x, y, axis.color});
    overlay.lines.push_back({ex, ey, axis.color});
    overlay.marks.push_back({ex, ey, axis.color});
  }
}

void paint(const Overlay& overlay, QPainter& painter) {
  painter.setPen(Qt::NoPen);
  for (std::size_t k = 0; k + 2 < overlay.triangles.size(); k += 3) {
    QPolygonF triangle;
    std::array<int, 4> color{};  // the mean: a painter has no gradients of triangles
    for (std::size_t i = k; i < k + 3; ++i) {
      const Overlay::Vertex& v = overlay.triangles[i];
      triangle << QPointF(v.x, v.y);
      color[0] += qRed(v.color);
      color[1] += qGreen(v.color);
      color[2] += qBlue(v.color);
      color[3] += qAlpha(v.color);
    }
    painter.setBrush(QColor(color[0] / 3, color[1] / 3, color[2] / 3, color[3] / 3));
    painter.drawPolygon(triangle);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t k = 0; k + 1 < overlay.lines.size(); k += 2) {
    const auto& a = overlay.lines[k];
    const auto& b = overlay.lines[k + 1];
    painter.setPen(QPen(QColor::fromRgba(a.color), Overlay::line_width()));
    painter.drawLine(QLineF(a.x, a.y, b.x, b.y));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  const auto squares = [&painter](const std::vector<Overlay::Vertex>& vertices, float size) {
    for (const auto& v : vertices) {
      painter.fillRect(QRectF(v.x - 0.5F * size, v.y - 0.5F * size, size, size),
                       QColor::fromRgba(v.color));
    }
  };
  squares(overlay.dots, Overlay::dot_size());
  squares(overlay.marks, Overlay::mark_size());
}

}  // namespace brume
