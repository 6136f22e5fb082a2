#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "app/files/numbered_file.h"
#include "app/jobs/background_job.h"
#include "app/pictures/picture.h"
#include "brume/render.h"
#include "brume/scene.h"
#include "render/output/frame_file.h"

namespace brume {

// Parameters of an export.
struct FrameExportRequest {
  std::shared_ptr<const Scene> scene;  // with its animation
  RenderRequest request{};             // of one frame, or of any of several
  FrameInfo info{};                    // without its number
  // The extension decides the format: .exr or .png, or .mp4 of several frames. Empty: no file.
  std::filesystem::path file;
  struct Range {
    int first = 0;
    int last = 0;
    double frames_per_second = default_frame_rate;
  };
  std::optional<Range> range;  // nullopt: one frame
  std::set<int> complete{};    // frames of the range whose files are written
  QString title{};             // of its pictures
  int priority = 0;            // in the queue: 1 before 0 before -1
  // A render that an earlier session left has the file of its scene instead, and the view that its
  // pictures are shown by. Both are read when it starts.
  std::filesystem::path kept_scene{};
  std::optional<ColorChoice> kept_view{};
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
  void written(int frame);  // of a range, to its file
  void frame_failed(int frame, const QString& why);
  void cancelled(int written);  // number of written files
  void failed(const QString& message);

 private:
  int written_ = 0;  // by the work
  BackgroundJob job_{BackgroundJob::Policy::one_at_a_time};
};

}  // namespace brume
