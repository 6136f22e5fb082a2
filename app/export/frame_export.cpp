#include "app/export/frame_export.h"

#include "app/document/paths.h"
#include "app/export/frame_source.h"
#include "app/export/video_file.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"

namespace brume {
namespace {

struct Cancelled {};

// The work of one export, in its thread. Every function throws InputError, and Cancelled.
class Exporter {
 public:
  Exporter(const FrameExportRequest& request, const Job& job, int& written)
      : request_(request),
        job_(job),
        written_(written),
        source_(request.scene, request.camera, request.settings, request.backend) {}

  void run() {
    if (!request_.range) {
      write(request_.file, frame(request_.time, 0, 1));
    } else if (lower_case_extension(request_.file) == ".mp4") {
      write_video();
    } else {
      for_each_frame([this](int number, const Frame& frame) {
        write(numbered_file(request_.file, number), frame);
      });
    }
  }

 private:
  // The k-th of `count` frames.
  Frame frame(double time, int k, int count) {
    auto frame = source_.at(time, job_.subrange(static_cast<double>(k) / count, (k + 1.0) / count));
    if (!frame || job_.stop.stop_requested()) throw Cancelled();
    return std::move(*frame);
  }

  void for_each_frame(const std::function<void(int, const Frame&)>& take) {
    const FrameExportRequest::Range& range = *request_.range;
    const int count = range.last - range.first + 1;
    for (int k = 0; k < count; ++k) {
      const int number = range.first + k;
      take(number, frame(number / range.frames_per_second, k, count));
    }
  }

  void write(const std::filesystem::path& file, const Frame& frame) {
    FrameInfo info = request_.info;
    info.backend = frame.statistics.backend;
    info.noise = relative_noise(frame);
    write_frame(file, frame, info);
    ++written_;
  }

  void write_video() {
    write_atomically(request_.file, [this](const std::filesystem::path& temporary) {
      VideoFile video(request_.file, temporary, request_.scene->film,
                      request_.range->frames_per_second);
      for_each_frame([&](int, const Frame& frame) {
        video.add(to_display(frame, request_.info.exposure), job_.stop);
      });
      video.finish(job_.stop);
      if (job_.stop.stop_requested()) throw Cancelled();
    });
    ++written_;
  }

  const FrameExportRequest& request_;
  const Job& job_;
  int& written_;
  FrameSource source_;
};

}  // namespace

FrameExport::FrameExport(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::cancelled, this, [this] { Q_EMIT cancelled(written_); });
  connect(&job_, &BackgroundJob::failed, this, &FrameExport::failed);
}

void FrameExport::start(const FrameExportRequest& request) {
  const auto work = [this, request](const Job& job) {
    written_ = 0;
    Exporter(request, job, written_).run();
    return [this, file = to_qstring(request.file)] { Q_EMIT finished(file); };
  };
  job_.start(work, tr("Exporting %1").arg(to_qstring(request.file.filename())));
}

}  // namespace brume
