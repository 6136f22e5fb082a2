#include "app/view/drawing/handles.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "app/widgets/application.h"
#include "app/widgets/interface_settings.h"
#include "core/scene/camera_rays.h"

namespace brume {
namespace {

constexpr double pick_radius = 8.0;  // logical pixels
constexpr std::size_t max_outlines = 2000;
constexpr std::size_t max_marks = 500;
// More would hide the fog, and cost more than its picture.
constexpr std::size_t max_dots = 20'000;

// Alpha for each of `count` shapes: the more there are, the fainter, or they would hide the fog.
int crowd_alpha(std::size_t count, int few, int many) {
  constexpr double many_shapes = 100.0;
  return std::clamp(static_cast<int>(few * many_shapes / std::max(1.0, static_cast<double>(count))),
                    many, few);
}

// One of so many is drawn.
std::size_t dot_step(std::size_t count) {
  return std::max<std::size_t>((count + max_dots - 1) / max_dots, 1);
}

constexpr double crowd = 1000.0;

// One handle is enough, in a crowd, for what is nearer together than they are wide; the more there
// are, the more room they leave.
class CrowdedFilm {
 public:
  explicit CrowdedFilm(std::size_t count) {
    const double crowds = static_cast<double>(count) / crowd;
    if (crowds > 1.0) side_ = spacing * (1.0 + std::log10(crowds)) * handle_scale();
  }

  // True if there is room for another one, which then takes it.
  bool take(const glm::dvec3& p) {
    if (side_ == 0.0) return true;
    const auto cell = [this](double x) {
      return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(x / side_)));
    };
    return taken_.insert(std::uint64_t{cell(p.x)} << 32U | cell(p.y)).second;
  }

 private:
  static constexpr double spacing = 7.0;  // logical pixels

  double side_ = 0.0;
  std::unordered_set<std::uint64_t> taken_;
};

QRgb with_alpha(QRgb color, int alpha) {
  return qRgba(qRed(color), qGreen(color), qBlue(color), alpha);
}

}  // namespace

void Handles::restrict(const Medium& medium, std::span<const GaussianId> hidden,
                       std::span<const GaussianId> locked) {
  const auto mark = [&medium](std::span<const GaussianId> ids, std::vector<bool>& marks) {
    marks.clear();
    if (ids.empty()) return;
    marks.resize(medium.size());
    for (const GaussianId id : ids) marks[*medium.index_of(id)] = true;
  };
  mark(hidden, hidden_);
  mark(locked, locked_);
}

void Handles::project(const Medium& medium, const CameraRays& rays) {
  positions_.resize(medium.size());
  std::transform(medium.centers().begin(), medium.centers().end(), positions_.begin(),
                 [&rays](const glm::dvec3& center) { return rays.project(center); });
}

void Handles::set_depth(const CameraRays& rays, const Frame& frame) {
  depth_.reset();
  if (!frame.depth.empty()) depth_.emplace(FilmDepth{rays, frame.film, frame.depth});
}

bool Handles::is_behind_surface(const glm::dvec3& center) const {
  if (!depth_) return false;
  const auto& [rays, film, depth] = *depth_;
  const glm::dvec3 projected = rays.project(center);
  const double x = std::floor(projected.x);
  const double y = std::floor(projected.y);
  if (projected.z <= 0.0 || x < 0.0 || y < 0.0 || x >= film.width || y >= film.height) return false;
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
  return rays.distance_to(center) > static_cast<double>(depth[pixel]);
}

std::optional<std::size_t> Handles::pick(QPointF position) const {
  const double reach = pick_radius * handle_scale();
  std::optional<std::size_t> best;
  double best_distance = 0.0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const glm::dvec3& p = positions_[i];
    if (p.z <= 0.0 || !(std::abs(p.x - position.x()) <= reach)) continue;  // as most
    const double distance = std::hypot(p.x - position.x(), p.y - position.y());
    if (is_hidden(i) || is_locked(i) || !(distance <= reach)) continue;
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
    if (p.z > 0.0 && !is_hidden(i) && !is_locked(i) && area(QPointF(p.x, p.y))) {
      indices.push_back(i);
    }
  }
  return indices;
}

void Handles::draw(Overlay& overlay, const Medium& medium, const CameraRays& rays,
                   std::span<const GaussianId> selected, std::optional<GaussianId> hovered,
                   Marks marks) const {
  const bool with_centers = marks != Marks::outlines;
  const bool is_quiet = marks == Marks::quiet || static_cast<double>(selected.size()) > crowd;
  const QRgb accent = accent_color().rgb();
  const QRgb plain = qRgb(235, 238, 242);
  const int outline_alpha = crowd_alpha(selected.size(), 220, 28);
  const int mark_alpha = crowd_alpha(selected.size() / 4, 255, 120);
  const int dot_alpha = crowd_alpha(medium.size() / 4, 190, 90);
  const auto is_dim = [&](std::size_t i) {
    return is_locked(i) || is_behind_surface(medium.centers()[i]);
  };

  const auto add_dot = [&](std::vector<Overlay::Vertex>& shapes, CrowdedFilm& film, std::size_t i,
                           QRgb color) {
    const glm::dvec3 p = rays.project(medium.centers()[i]);
    if (p.z <= 0.0 || !film.take(p)) return;
    shapes.push_back({static_cast<float>(p.x), static_cast<float>(p.y), color});
  };
  CrowdedFilm film(medium.size());
  const std::size_t step = dot_step(medium.size());
  for (std::size_t i = 0; with_centers && i < medium.size(); i += step) {
    if (is_hidden(i) || std::ranges::binary_search(selected, medium.ids()[i])) continue;
    add_dot(overlay.dots, film, i,
            with_alpha(color_of(i, plain), is_dim(i) ? dot_alpha / 3 : dot_alpha));
  }
  // Small ones in a crowd, for the same reason.
  auto& shapes = is_quiet || selected.size() > max_marks ? overlay.dots : overlay.marks;
  CrowdedFilm film_of_selected(selected.size());
  const std::size_t selected_step = dot_step(selected.size());
  for (std::size_t k = 0; k < selected.size(); k += selected_step) {
    const std::size_t i = *medium.index_of(selected[k]);
    const bool dim = is_dim(i);
    if (!is_quiet) {
      overlay.add_outline(rays, medium.gaussian(i),
                          with_alpha(accent, dim ? outline_alpha / 2 : outline_alpha));
    }
    if (with_centers && !is_hidden(i)) {
      add_dot(shapes, film_of_selected, i, with_alpha(accent, dim ? mark_alpha / 2 : mark_alpha));
    }
  }
  const auto hovered_index = hovered && with_centers ? medium.index_of(*hovered) : std::nullopt;
  if (!hovered_index || is_hidden(*hovered_index)) return;
  const glm::dvec3 p = rays.project(medium.centers()[*hovered_index]);
  if (p.z <= 0.0) return;
  if (is_quiet || !std::ranges::binary_search(selected, *hovered)) {
    overlay.add_outline(rays, medium.gaussian(*hovered_index), with_alpha(plain, 90));
  }
  overlay.add_circle(p.x, p.y, 7.0, with_alpha(plain, 255));
}

void Handles::draw_outlines(Overlay& overlay, const Medium& medium, const CameraRays& rays) const {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (positions_[i].z > 0.0 && !is_hidden(i)) indices.push_back(i);
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
    overlay.add_outline(rays, medium.gaussian(i), color);
  }
}

}  // namespace brume
