#include "app/view/drawing/camera_outline.h"
#include "core/scene/camera_rays.h"

#include <array>
#include <glm/geometric.hpp>

namespace brume {

void add_camera_outline(Overlay& overlay, const CameraRays& rays, const Camera& camera,
                        const Film& film) {
  const QRgb color = qRgba(235, 238, 242, 90);
  const CameraRays seen(camera, film);
  const double distance = glm::distance(camera.eye, camera.target);
  const auto corner_at = [&](double x, double y) {
    const glm::dvec3 direction = seen.direction(x * film.width, y * film.height);
    return seen.origin(x * film.width, y * film.height) +
           distance / glm::dot(direction, seen.forward()) * direction;
  };
  const std::array<glm::dvec2, 4> places{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const glm::dvec2& next = places[(k + 1) % places.size()];
    const glm::dvec3 corner = corner_at(places[k].x, places[k].y);
    const glm::dvec3 start = seen.origin(places[k].x * film.width, places[k].y * film.height);
    overlay.add_line(rays, start, corner, color);
    overlay.add_line(rays, corner, corner_at(next.x, next.y), color);
  }
  // A mark above the picture says which way is up.
  overlay.add_line(rays, corner_at(0.4, 0.0), corner_at(0.5, -0.1), color);
  overlay.add_line(rays, corner_at(0.5, -0.1), corner_at(0.6, 0.0), color);
}

}  // namespace brume
