#include "app/viewport/surface_picker.h"

#include <chrono>

#include "app/document/document.h"

namespace brume {

SurfacePicker::SurfacePicker(const Document& document)
    : document_(document), thread_([](const Job& job, const std::stop_token&) {
        try {
          job.promise->set_value(std::make_shared<const RayCaster>(job.surfaces));
        } catch (...) {
          job.promise->set_exception(std::current_exception());
        }
      }) {
  connect(&document, &Document::scene_replaced, this, &SurfacePicker::prepare);
  connect(&document, &Document::part_changed, this, &SurfacePicker::prepare);
  prepare();
}

void SurfacePicker::prepare() {
  if (document_.scene().surfaces == surfaces_) return;
  surfaces_ = document_.scene().surfaces;
  auto promise = std::make_shared<std::promise<Built>>();
  built_ = promise->get_future().share();
  thread_.start({surfaces_, std::move(promise)});
}

bool SurfacePicker::is_ready() {
  prepare();  // others hear of a change sooner than this
  return !built_.valid() || built_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::optional<SurfacePoint> SurfacePicker::hit(const glm::dvec3& origin,
                                               const glm::dvec3& direction) {
  if (!is_ready() || surfaces_.empty()) return std::nullopt;
  const RayCaster& ray_caster = *built_.get();
  const SurfaceHit hit = ray_caster.first_hit(origin, direction);
  if (!hit) return std::nullopt;
  return ray_caster.point(hit, origin, direction, surfaces_);
}

}  // namespace brume
