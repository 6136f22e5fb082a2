#pragma once

#include <QObject>
#include <future>
#include <memory>

#include "app/job_thread.h"
#include "render/cpu/visibility.h"

namespace brume {

class Document;

// Which surface a ray meets, for tools. What it takes to know that is built in the background as
// soon as the surfaces change; while that lasts rays meet nothing, and nobody waits.
class SurfacePicker : public QObject {
  Q_OBJECT
 public:
  explicit SurfacePicker(const Document& document);

  [[nodiscard]] bool is_ready();
  // Of a ray of unit direction.
  std::optional<SurfacePoint> hit(const glm::dvec3& origin, const glm::dvec3& direction);

 private:
  using Built = std::shared_ptr<const Visibility>;
  struct Job {
    std::vector<Surface> surfaces;
    std::shared_ptr<std::promise<Built>> promise;
  };
  void prepare();

  const Document& document_;
  std::vector<Surface> surfaces_;  // that are being built, or are
  std::shared_future<Built> built_;
  JobThread<Job> thread_;
};

}  // namespace brume
