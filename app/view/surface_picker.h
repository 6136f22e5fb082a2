#pragma once

#include <memory>

#include "app/jobs/background_job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

class CameraRays;
class Document;

// Ray picking of surfaces for tools. The ray caster is rebuilt in the background when surfaces
// change; meanwhile rays hit nothing.
class SurfacePicker : public QObject {
  Q_OBJECT
 public:
  explicit SurfacePicker(const Document& document);

  [[nodiscard]] bool is_ready();
  // First hit of a ray of unit direction.
  std::optional<SurfacePoint> hit(const glm::dvec3& origin, const glm::dvec3& direction);
  // First hit of a ray of a view, beyond the walls that the view leaves out.
  std::optional<SurfacePoint> hit_in_view(const CameraRays& rays, const glm::dvec3& origin,
                                          const glm::dvec3& direction);
  // The surface of a point that one of them gave, of the scene's.
  [[nodiscard]] std::size_t index_of(const SurfacePoint& point) const;

 private:
  void prepare();

  const Document& document_;
  std::vector<Surface> all_;          // of the document
  std::vector<Surface> surfaces_;     // of caster_: the visible ones
  std::vector<std::size_t> indices_;  // of those in all_
  std::shared_ptr<const RayCaster> caster_;
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
