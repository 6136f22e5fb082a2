#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "app/files/numbered_file.h"
#include "app/jobs/background_job.h"
#include "app/pictures/picture.h"
#include "brume/scene.h"
#include "render/gl_renderer.h"
#include "render/output/frame_file.h"
#include "render/samples/exposure.h"
#include "render/settings.h"

namespace brume {

// Parameters of an export.
struct FrameExportRequest {
  std::shared_ptr<const Scene> scene;  // with its animation
  std::optional<Camera> camera;        // nullopt: the scene's camera at each time
  Settings settings;
  FrameInfo info;  // without backend, noise, settings and number, set per frame
  Exposure exposure{};
  Backend backend = Backend::auto_;
  // The extension decides the format: .exr or .png, or .mp4 of several frames. Empty: no file.
  std::filesystem::path file;
  struct Range {
    int first = 0;
    int last = 0;
    double frames_per_second = default_frame_rate;
  };
  std::optional<Range> range;  // nullopt: one frame
  double time = 0.0;           // of that [s]
  QString title{};             // of its pictures
  std::optional<Film> film{};  // absent: the scene's; or a region of that
};

// A frame of an export, to be looked at.
struct ExportedFrame {
  std::shared_ptr<const Picture> picture;
  double milliseconds = 0.0;
};

// Renders a frame, a sequence or a video to files in the background. Files are written atomically;
// complete frames of a cancelled sequence stay.
class FrameExport : public QObject {
  Q_OBJECT
 public:
  explicit FrameExport(QObject* parent = nullptr);

  void start(const FrameExportRequest& request);  // one at a time
  [[nodiscard]] BackgroundJob& job() { return job_; }

 Q_SIGNALS:
  void finished(const QString& file);
  // Each frame, also one that is not written.
  void rendered(const brume::ExportedFrame& frame);
  void cancelled(int written);  // number of written files
  void failed(const QString& message);

 private:
  int written_ = 0;  // by the work
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
};

}  // namespace brume
