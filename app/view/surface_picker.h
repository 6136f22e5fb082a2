#pragma once

#include <memory>

#include "app/jobs/background_job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

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

 private:
  void prepare();

  const Document& document_;
  std::vector<Surface> all_;       // of the document
  std::vector<Surface> surfaces_;  // of caster_: the visible ones
  std::shared_ptr<const RayCaster> caster_;
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
