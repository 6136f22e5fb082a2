#include "app/view/surface_picker.h"

#include <functional>

#include "app/document/document.h"

namespace brume {

SurfacePicker::SurfacePicker(const Document& document) : document_(document) {
  connect(&document, &Document::scene_replaced, this, &SurfacePicker::prepare);
  connect(&document, &Document::part_changed, this, &SurfacePicker::prepare);
  prepare();
}

void SurfacePicker::prepare() {
  if (document_.scene().surfaces == all_) return;
  all_ = surfaces_ = document_.scene().surfaces;
  std::erase_if(surfaces_, std::not_fn(&Surface::visible));
  caster_.reset();
  job_.start([this, surfaces = surfaces_](const Job&) {
    return [this, built = std::make_shared<const RayCaster>(surfaces)] { caster_ = built; };
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

}  // namespace brume
