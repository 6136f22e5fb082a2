#include "app/tools/brushes/brush_cursor.h"

#include <array>
#include <cmath>
#include <glm/ext/scalar_constants.hpp>
#include <glm/gtc/constants.hpp>

#include "app/view/drawing/overlay.h"
#include "app/view/surface_picker.h"
#include "app/widgets/application.h"
#include "app/widgets/color_button.h"
#include "core/math/basis.h"
#include "core/math/infinity.h"
#include "core/transport/optical_depth.h"

namespace brume {
namespace {

// A Gaussian's radius at 1% of its density over that at 1/e.
const double extent = std::sqrt(std::log(100.0));

// The ray through a point.
struct PointRay {
  glm::dvec3 direction, origin;

  PointRay(const CameraRays& rays, const glm::dvec3& point)
      : direction(rays.towards(point)), origin(point - rays.distance_to(point) * direction) {}

  // How far the first surface is [u].
  [[nodiscard]] double end(const CameraRays& rays, SurfacePicker& surfaces) const {
    const auto hit = surfaces.hit_in_view(rays, origin, direction);
    return hit ? glm::distance(hit->position, origin) : infinity;
  }
};

}  // namespace

void add_brush_cursor(Overlay& overlay, const CameraRays& rays, SurfacePicker& surfaces,
                      const Gaussian& laid, const glm::dvec3& normal) {
  const auto is_hidden = [&](const glm::dvec3& point) {
    return rays.distance_to(point) > PointRay(rays, point).end(rays, surfaces);
  };
  const QColor accent = accent_color();
  const auto accented = [&](int alpha) {
    return qRgba(accent.red(), accent.green(), accent.blue(), alpha);
  };
  Gaussian whole = laid;
  whole.radius *= extent;
  overlay.add_outline(rays, laid, accented(230), is_hidden);
  overlay.add_outline(rays, whole, accented(110), is_hidden);
  // The plane as a net around the brush that fades outwards.
  const auto [u, v] = make_basis(normal);
  constexpr int cells = 4;
  for (int k = -cells; k <= cells; ++k) {
    for (int j = -cells; j < cells; ++j) {
      const double center = std::hypot(k, j + 0.5) / cells;
      if (center >= 1.0) continue;
      const QRgb color = qRgba(255, 255, 255, static_cast<int>(70.0 * (1.0 - center)));
      const auto add = [&](const glm::dvec3& along, const glm::dvec3& across) {
        const glm::dvec3 line = laid.center + laid.radius * k * across;
        const double step = laid.radius;
        if (is_hidden(line + step * (j + 0.5) * along)) return;
        overlay.add_line(rays, line + step * j * along, line + step * (j + 1) * along, color);
      };
      add(u, v);
      add(v, u);
    }
  }
}

void add_ghost(Overlay& overlay, const CameraRays& rays, SurfacePicker& surfaces,
               const Gaussian& laid, const glm::dvec3& color) {
  constexpr int ring_count = 8;
  constexpr int side_count = 32;
  constexpr double max_alpha = 150.0;  // the picture stays visible behind dense fog
  const StandaloneTerm term(laid);
  const QColor shown = to_color(color);
  const auto [u, v] = make_basis(rays.towards(laid.center));
  struct Corner {
    Overlay::Vertex vertex;
    bool is_in_front = false;
  };
  const auto corner = [&](int ring, int side) -> Corner {
    const double radius = extent * laid.radius * ring / ring_count;
    const double angle = glm::two_pi<double>() * side / side_count;
    const glm::dvec3 point = laid.center + radius * (std::cos(angle) * u + std::sin(angle) * v);
    const glm::dvec3 projected = rays.project(point);
    if (!(projected.z > 0.0)) return {};
    const PointRay ray(rays, point);
    const LineProfile<double> line = line_profile(*term, ray.origin, ray.direction);
    const double depth = optical_depth(*term, line, ray.end(rays, surfaces));
    const int alpha = static_cast<int>(-max_alpha * std::expm1(-depth));
    return {{static_cast<float>(projected.x), static_cast<float>(projected.y),
             qRgba(shown.red(), shown.green(), shown.blue(), alpha)},
            true};
  };
  std::array<Corner, side_count + 1> inner;
  inner.fill(corner(0, 0));
  for (int ring = 1; ring <= ring_count; ++ring) {
    std::array<Corner, side_count + 1> outer;
    for (int side = 0; side < side_count; ++side) outer[side] = corner(ring, side);
    outer[side_count] = outer[0];
    const auto add = [&](const Corner& a, const Corner& b, const Corner& c) {
      if (!a.is_in_front || !b.is_in_front || !c.is_in_front) return;
      overlay.triangles.insert(overlay.triangles.end(), {a.vertex, b.vertex, c.vertex});
    };
    for (int side = 0; side < side_count; ++side) {
      add(inner[side], outer[side], outer[side + 1]);
      if (ring > 1) add(inner[side], outer[side + 1], inner[side + 1]);
    }
    inner = outer;
  }
}

}  // namespace brume
