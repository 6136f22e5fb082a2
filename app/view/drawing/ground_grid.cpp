#include "app/view/drawing/ground_grid.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace brume {
namespace {

constexpr int grid_cells = 30;  // from the middle to each side
// Sines of the angle at which the ground is seen: below the first its lines run into a bar, above
// the second none do.
constexpr double edge_on = 0.03;
constexpr double plain_view = 0.12;
constexpr int plain_alpha = 70;
constexpr int strong_alpha = 120;  // of every fifth line
constexpr int axis_alpha = 140;
constexpr double behind_surface = 0.2;  // of the alpha

bool is_behind(const glm::dvec3& point, const glm::dvec3& film_position, const CameraRays& rays,
               const std::optional<GridDepth>& depth, const Film& film) {
  if (!depth || depth->frame.depth.empty()) return false;
  // The frame's film may be coarser than the view.
  const Film& frame_film = depth->frame.film;
  const double x = std::floor(film_position.x * frame_film.width / film.width);
  const double y = std::floor(film_position.y * frame_film.height / film.height);
  if (x < 0.0 || y < 0.0 || x >= frame_film.width || y >= frame_film.height) return false;
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_film.width) +
                     static_cast<std::size_t>(x);
  // A floor at the ground's height does not hide it.
  return rays.distance_to(point) > 1.01 * static_cast<double>(depth->frame.depth[pixel]);
}

}  // namespace

double ground_grid_step(double distance) {
  const double wanted = std::max(0.1 * distance, 1e-9);
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {5.0, 2.0}) {
    if (wanted >= factor * power) return factor * power;
  }
  return power;
}

void add_ground_grid(Overlay& overlay, const Camera& camera, const Film& film, double distance,
                     const std::optional<GridDepth>& depth) {
  const CameraRays rays(camera, film);
  const double step = ground_grid_step(distance);
  const auto middle_x = static_cast<long long>(std::round(camera.target.x / step));
  const auto middle_z = static_cast<long long>(std::round(camera.target.z / step));
  const std::optional<GridDepth> usable = depth && depth->camera == camera ? depth : std::nullopt;
  // Line `k` of those along one axis.
  const auto add_line = [&](bool along_x, long long k) {
    const bool is_axis = k == 0;
    const int alpha = is_axis ? axis_alpha : k % 5 == 0 ? strong_alpha : plain_alpha;
    const QColor color = !is_axis  ? QColor(160, 166, 174)
                         : along_x ? QColor(226, 92, 92)
                                   : QColor(96, 146, 236);
    const long long start = (along_x ? middle_x : middle_z) - grid_cells;
    const double across = static_cast<double>(k) * step;
    const auto line_at = [&](long long i) {
      const double along = static_cast<double>(i) * step;
      return along_x ? glm::dvec3(along, 0.0, across) : glm::dvec3(across, 0.0, along);
    };
    for (long long i = start; i < start + 2 * grid_cells; ++i) {
      const glm::dvec3 a = line_at(i);
      const glm::dvec3 b = line_at(i + 1);
      const glm::dvec3 center = 0.5 * (a + b);
      const double from_middle =
          std::hypot(center.x - camera.target.x, center.z - camera.target.z) / (grid_cells * step);
      const double sine = std::abs(rays.towards(center).y);
      const double flat = std::clamp((sine - edge_on) / (plain_view - edge_on), 0.0, 1.0);
      double fade = flat * std::clamp(1.0 - from_middle, 0.0, 1.0);
      const glm::dvec3 on_film = rays.project(center);
      if (on_film.z > 0.0 && is_behind(center, on_film, rays, usable, film)) fade *= behind_surface;
      const int faded = static_cast<int>(alpha * fade);
      if (faded < 4) continue;
      overlay.add_line(rays, a, b, qRgba(color.red(), color.green(), color.blue(), faded));
    }
  };
  for (long long k = -grid_cells; k <= grid_cells; ++k) {
    add_line(true, middle_z + k);
    add_line(false, middle_x + k);
  }
}

}  // namespace brume
