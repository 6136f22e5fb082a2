#include "app/export/frame_export.h"

#include <QElapsedTimer>

#include "app/document/paths.h"
#include "app/export/export_frames.h"
#include "app/export/render_record.h"
#include "app/export/video_file.h"
#include "app/files/picture_format.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "render/deep/deep_file.h"
#include "render/request.h"

namespace brume {
namespace {

// The work of one export, in its thread. Every function throws InputError, and Cancelled.
class Exporter {
 public:
  // Hands on each frame when it is done with it, and the number of each that is written.
  using Deliver = std::function<void(ExportedFrame)>;
  using Written = std::function<void(std::optional<int> number)>;
  struct Told {
    Written written;
    Deliver deliver;
    FrameFailed failed;
  };
  Exporter(const FrameExportRequest& request, const Job& job, Told told)
      : request_(request), job_(job), told_(std::move(told)) {}

  void run() {
    if (!request_.range) {
      writing(request_.file, frame(request_.request.time, request_.title, 0, 1))();
    } else if (lower_case_extension(request_.file) == ".mp4") {
      write_video();
    } else {
      export_frames(
          request_.range->first, request_.range->last, job_,
          [this](int number, int k, int count) {
            const std::filesystem::path file =
                request_.file.empty() ? request_.file : numbered_file(request_.file, number);
            return writing(file, numbered_frame(number, k, count), number);
          },
          written_frames(), told_.failed);
    }
  }

 private:
  // Those of an earlier start whose files are still there: who removes one wants it anew.
  [[nodiscard]] std::set<int> written_frames() const {
    std::set<int> frames = request_.complete;
    std::erase_if(frames, [&](int number) {
      return !std::filesystem::is_regular_file(numbered_file(request_.file, number));
    });
    return frames;
  }

  // The k-th of `count` frames.
  Frame frame(double time, const QString& title, int k, int count) {
    QElapsedTimer timer;
    timer.start();
    RenderRequest request = request_.request;
    request.time = time;
    // Other files have none.
    if (picture_format(request_.file) != ".exr") request.layers = {};
    if (!denoise_problem(request).empty()) request.denoise = Denoising::none;
    if (is_deep_file(request_.file)) request.deep_error = DeepSettings{}.error;
    const Job job = job_.subrange(static_cast<double>(k) / count, (k + 1.0) / count);
    auto frame = renderer_.render(*request_.scene, request, job.stop, job.progress);
    if (!frame || job_.stop.stop_requested()) throw Cancelled();
    const double milliseconds = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    const QString details = picture_details(*frame, settings_of(*frame->request), milliseconds);
    told_.deliver({make_picture(*frame, request_.info.look, title, details), milliseconds});
    return std::move(*frame);
  }

  Frame numbered_frame(int number, int k, int count) {
    const QString title = QString("%1, frame %2").arg(request_.title).arg(number);
    return frame(number / request_.range->frames_per_second, title, k, count);
  }

  // Returns a function that writes a frame. A deep file is rendered at once.
  FrameLoop::Write writing(const std::filesystem::path& file, Frame frame,
                           std::optional<int> number = {}) {
    if (file.empty()) return [] {};
    FrameInfo info = request_.info;
    info.frame = number;
    if (is_deep_file(file)) {
      if (!renderer_.write_deep(file, *request_.scene, frame, info, job_.stop)) throw Cancelled();
      return [this, number] { told_.written(number); };
    }
    const auto content = std::make_shared<const Frame>(std::move(frame));
    return [this, file, info, content] {
      write_frame(file, *content, info);
      told_.written(info.frame);
    };
  }

  void write_video() {
    write_atomically(request_.file, [this](const std::filesystem::path& temporary) {
      VideoFile video(request_.file, temporary,
                      request_.request.film.value_or(request_.scene->film),
                      request_.range->frames_per_second);
      const int count = request_.range->last - request_.range->first + 1;
      for (int k = 0; k < count; ++k) {
        video.add(
            to_display(numbered_frame(request_.range->first + k, k, count), request_.info.look),
            job_.stop);
      }
      video.finish(job_.stop);
      if (job_.stop.stop_requested()) throw Cancelled();
    });
    told_.written({});
  }

  const FrameExportRequest& request_;
  const Job& job_;
  Told told_;
  SceneRenderer renderer_;
};

}  // namespace

FrameExport::FrameExport(QObject* parent) : QObject(parent) {
  connect(&job_, &BackgroundJob::cancelled, this, [this] { Q_EMIT cancelled(written_); });
  connect(&job_, &BackgroundJob::failed, this, &FrameExport::failed);
}

void FrameExport::start(const FrameExportRequest& request) {
  const auto work = [this, request](const Job& job) {
    written_ = 0;
    FrameExportRequest loaded = request;
    if (!loaded.scene) load_kept_scene(loaded);
    const auto written = [this, &job](std::optional<int> number) {
      ++written_;
      if (number) job_.deliver(job, [this, frame = *number] { Q_EMIT this->written(frame); });
    };
    const auto deliver = [this, &job](ExportedFrame frame) {
      job_.deliver(job, [this, frame = std::move(frame)] { Q_EMIT rendered(frame); });
    };
    const auto failed = [this, &job](int frame, const std::string& why) {
      job_.deliver(job, [this, frame, text = QString::fromStdString(why)] {
        Q_EMIT frame_failed(frame, text);
      });
    };
    Exporter(loaded, job, {written, deliver, failed}).run();
    return [this, file = to_qstring(request.file)] { Q_EMIT finished(file); };
  };
  job_.start(work, request.file.empty()
                       ? tr("Rendering")
                       : tr("Exporting %1").arg(to_qstring(request.file.filename())));
}

}  // namespace brume
