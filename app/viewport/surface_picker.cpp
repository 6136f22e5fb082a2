#include "app/viewport/surface_picker.h"

#include "app/document/document.h"

namespace brume {

std::optional<SurfacePoint> SurfacePicker::hit(const glm::dvec3& origin,
                                               const glm::dvec3& direction) {
  const auto& surfaces = document_.scene().surfaces;
  if (surfaces.empty()) return std::nullopt;
  if (!visibility_ || !visibility_->shows(surfaces)) {
    visibility_ = std::make_unique<Visibility>(surfaces);
  }
  const SurfaceHit hit = visibility_->first_hit(origin, direction);
  if (!hit) return std::nullopt;
  return visibility_->point(hit, origin, direction, surfaces);
}

}  // namespace brume
