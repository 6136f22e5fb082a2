#include "app/view/surface_picker.h"

#include <cmath>

#include "app/document/document.h"
#include "core/scene/camera_rays.h"
#include "core/scene/copies.h"

namespace brume {

SurfacePicker::SurfacePicker(const Document& document) : document_(document) {
  on_change(document, Change::scene | Change::part, this, &SurfacePicker::prepare);
  prepare();
}

void SurfacePicker::prepare() {
  if (document_.scene().surfaces == all_) return;
  all_ = document_.scene().surfaces;
  surfaces_.clear();
  indices_.clear();
  const std::vector<Surface> placed = with_placed_copies(all_);
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (!placed[k].visible) continue;
    surfaces_.push_back(placed[k]);
    indices_.push_back(k);
  }
  caster_.reset();
  job_.start([this, surfaces = surfaces_](const Job&) {
    return [this, built = shared_ray_caster(surfaces)] { caster_ = built; };
  });
}

bool SurfacePicker::is_ready() {
  prepare();  // others hear of a change sooner than this
  return !job_.is_running();
}

std::optional<SurfacePoint> SurfacePicker::hit(const glm::dvec3& origin,
                                               const glm::dvec3& direction) {
  if (!is_ready() || !caster_) return std::nullopt;
  const SurfaceHit hit = caster_->first_hit(origin, direction);
  if (!hit) return std::nullopt;
  return caster_->point(hit, origin, direction, surfaces_);
}

std::optional<SurfacePoint> SurfacePicker::hit_in_view(const CameraRays& rays,
                                                       const glm::dvec3& origin,
                                                       const glm::dvec3& direction) {
  const double start = rays.clip_end(origin, direction);
  if (!std::isfinite(start)) return std::nullopt;
  return hit(origin + start * direction, direction);
}

std::size_t SurfacePicker::index_of(const SurfacePoint& point) const {
  return indices_.at(static_cast<std::size_t>(point.surface - surfaces_.data()));
}

}  // namespace brume
