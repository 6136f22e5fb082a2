#include "app/view/handles.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "app/widgets/application.h"
#include "app/widgets/interface_settings.h"

namespace brume {
namespace {

constexpr double pick_radius = 8.0;  // logical pixels
constexpr std::size_t max_outlines = 2000;
constexpr std::size_t max_marks = 500;

// Alpha for each of `count` shapes: the more there are, the fainter, or they would hide the fog.
int crowd_alpha(std::size_t count, int few, int many) {
  constexpr double crowd = 100.0;
  return std::clamp(static_cast<int>(few * crowd / std::max(1.0, static_cast<double>(count))), many,
                    few);
}

QRgb with_alpha(QRgb color, int alpha) {
  return qRgba(qRed(color), qGreen(color), qBlue(color), alpha);
}

}  // namespace

void Handles::project(const Medium& medium, const CameraRays& rays,
                      std::span<const GaussianId> hidden, std::span<const GaussianId> locked) {
  positions_.resize(medium.size());
  std::transform(medium.centers().begin(), medium.centers().end(), positions_.begin(),
                 [&rays](const glm::dvec3& center) { return rays.project(center); });
  for (const GaussianId id : hidden) positions_[*medium.index_of(id)] = glm::dvec3(0.0);
  locked_.assign(medium.size(), false);
  for (const GaussianId id : locked) locked_[*medium.index_of(id)] = true;
}

void Handles::classify_depth(const Medium& medium, const CameraRays& rays, const Frame& frame) {
  behind_.assign(medium.size(), false);
  if (frame.depth.empty()) return;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const glm::dvec3& center = medium.centers()[i];
    const glm::dvec3 at = rays.project(center);
    const double x = std::floor(at.x);
    const double y = std::floor(at.y);
    if (at.z <= 0.0 || x < 0.0 || y < 0.0 || x >= frame.film.width || y >= frame.film.height) {
      continue;
    }
    const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.film.width) +
                       static_cast<std::size_t>(x);
    behind_[i] = glm::distance(center, rays.eye()) > static_cast<double>(frame.depth[pixel]);
  }
}

std::optional<std::size_t> Handles::pick(QPointF position) const {
  const double reach = pick_radius * handle_scale();
  std::optional<std::size_t> best;
  double best_distance = 0.0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const glm::dvec3& p = positions_[i];
    const double distance = std::hypot(p.x - position.x(), p.y - position.y());
    if (p.z <= 0.0 || locked_[i] || !(distance <= reach)) continue;
    // Less than two pixels nearer is no reason to take one from behind.
    const bool nearer = !best || distance < best_distance - 2.0 ||
                        (distance < best_distance + 2.0 && p.z < positions_[*best].z);
    if (nearer) {
      best = i;
      best_distance = distance;
    }
  }
  return best;
}

std::vector<std::size_t> Handles::inside(const std::function<bool(QPointF)>& area) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const glm::dvec3& p = positions_[i];
    if (p.z > 0.0 && !locked_[i] && area(QPointF(p.x, p.y))) indices.push_back(i);
  }
  return indices;
}

void Handles::draw(Overlay& overlay, const Medium& medium, const CameraRays& rays,
                   std::span<const GaussianId> selected, std::optional<GaussianId> hovered,
                   bool with_centers) const {
  const QRgb accent = accent_color().rgb();
  const QRgb plain = qRgb(235, 238, 242);
  auto next_selected = selected.begin();
  std::size_t outlines = 0;
  const int outline_alpha = crowd_alpha(selected.size(), 220, 28);
  const int mark_alpha = crowd_alpha(selected.size() / 4, 255, 120);
  const int dot_alpha = crowd_alpha(positions_.size() / 4, 190, 90);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const GaussianId id = medium.ids()[i];
    while (next_selected != selected.end() && *next_selected < id) ++next_selected;
    const bool is_selected = next_selected != selected.end() && *next_selected == id;
    const glm::dvec3& p = positions_[i];
    const bool dim = locked_[i] || (i < behind_.size() && behind_[i]);
    if (is_selected && outlines < max_outlines) {
      overlay.add_ball_outline(rays, medium.centers()[i], medium.radii()[i],
                               with_alpha(accent, dim ? outline_alpha / 2 : outline_alpha));
      ++outlines;
    }
    if (p.z <= 0.0 || !with_centers) continue;
    const auto x = static_cast<float>(p.x);
    const auto y = static_cast<float>(p.y);
    if (is_selected) {
      // Small ones in a crowd, for the same reason.
      auto& shapes = selected.size() > max_marks ? overlay.dots : overlay.marks;
      shapes.push_back({x, y, with_alpha(accent, dim ? mark_alpha / 2 : mark_alpha)});
    } else {
      overlay.dots.push_back(
          {x, y, with_alpha(color_of(i, plain), dim ? dot_alpha / 3 : dot_alpha)});
    }
    if (hovered == id && !is_selected) {
      overlay.add_ball_outline(rays, medium.centers()[i], medium.radii()[i], with_alpha(plain, 90));
    }
    if (hovered == id) overlay.add_circle(p.x, p.y, 7.0, with_alpha(plain, 255));
  }
}

void Handles::draw_outlines(Overlay& overlay, const Medium& medium, const CameraRays& rays) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].z > 0.0) indices.push_back(i);
  }
  if (indices.size() > max_outlines) {
    std::nth_element(
        indices.begin(), indices.begin() + max_outlines, indices.end(),
        [this](std::size_t a, std::size_t b) { return positions_[a].z < positions_[b].z; });
    indices.resize(max_outlines);
  }
  const int alpha = crowd_alpha(indices.size(), 200, 40);
  for (const std::size_t i : indices) {
    const QRgb color = with_alpha(color_of(i, qRgb(190, 215, 240)), alpha);
    overlay.add_ball_outline(rays, medium.centers()[i], medium.radii()[i], color);
  }
}

}  // namespace brume
