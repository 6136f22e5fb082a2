#pragma once

#include <QObject>
#include <future>
#include <memory>

#include "app/jobs/job_thread.h"
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
  using Built = std::shared_ptr<const RayCaster>;
  struct Job {
    std::vector<Surface> surfaces;
    std::shared_ptr<std::promise<Built>> promise;
  };
  void prepare();

  const Document& document_;
  std::vector<Surface> surfaces_;  // input of built_
  std::shared_future<Built> built_;
  JobThread<Job> thread_;
};

}  // namespace brume
