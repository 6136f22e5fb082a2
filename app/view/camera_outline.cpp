#include "app/view/camera_outline.h"
#include "core/scene/camera_rays.h"

#include <array>
#include <glm/geometric.hpp>

namespace brume {

void add_camera_outline(Overlay& overlay, const CameraRays& rays, const Camera& camera,
                        const Film& film) {
  const QRgb color = qRgba(235, 238, 242, 90);
  const CameraRays seen(camera, film);
  const double distance = glm::distance(camera.eye, camera.target);
  const auto at = [&](double x, double y) {
    const glm::dvec3 direction = seen.direction(x * film.width, y * film.height);
    return camera.eye + distance / glm::dot(direction, seen.forward()) * direction;
  };
  const std::array corners{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    overlay.add_line(rays, camera.eye, corners[k], color);
    overlay.add_line(rays, corners[k], corners[(k + 1) % corners.size()], color);
  }
  // A mark above the picture says which way is up.
  overlay.add_line(rays, at(0.4, 0.0), at(0.5, -0.1), color);
  overlay.add_line(rays, at(0.5, -0.1), at(0.6, 0.0), color);
}

}  // namespace brume
