#include "app/frame_export.h"

#include <exception>

#include "app/document/paths.h"
#include "render/frame_file.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_cache.h"
#include "render/transfer/transfer_store.h"

namespace brume {

FrameExport::FrameExport(QWidget* parent) : JobBar(parent) {
  connect(this, &JobBar::cancel_clicked, this, &FrameExport::cancel);
}

FrameExport::~FrameExport() = default;

void FrameExport::start(std::shared_ptr<const Scene> scene, const Camera& camera,
                        const Settings& settings, const FrameInfo& info,
                        const std::filesystem::path& file) {
  if (running_) return;
  running_ = true;
  show_job(tr("Exporting %1").arg(to_qstring(file.filename())));
  thread_ = std::jthread([=, this](const std::stop_token& stop) {
    Outcome outcome = Outcome::cancelled;
    QString text = to_qstring(file);
    try {
      int told = 0;  // per cent
      const auto progress = [this, &told](double done) {
        const int percent = static_cast<int>(100.0 * done);
        if (percent == told) return;
        told = percent;
        QMetaObject::invokeMethod(
            this, [this, percent] { show_progress(percent); }, Qt::QueuedConnection);
      };
      const Job job{stop, progress};
      const std::vector<TransferRequest> needed = RenderPlan(*scene, settings.airlight).transfers;
      const double first = needed.empty() ? 0.0 : 0.5;
      const auto transfers = std::make_shared<TransferStore>();
      transfers->make(needed, cache_folder(), job.part(0.0, first));
      Renderer renderer(transfers);
      const auto frame = renderer.render(*scene, camera, scene->film, settings, stop,
                                         job.part(first, 1.0).progress);
      if (frame && !stop.stop_requested()) {
        write_frame(file, *frame, info);
        outcome = Outcome::written;
      }
    } catch (const std::exception& error) {
      outcome = Outcome::failed;
      text = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this, [this, outcome, text] { end(outcome, text); }, Qt::QueuedConnection);
  });
}

void FrameExport::cancel() {
  thread_.request_stop();
}

void FrameExport::end(Outcome outcome, const QString& text) {
  thread_.join();
  running_ = false;
  hide();
  switch (outcome) {
    case Outcome::written:
      Q_EMIT finished(text);
      break;
    case Outcome::cancelled:
      Q_EMIT cancelled();
      break;
    case Outcome::failed:
      Q_EMIT failed(text);
      break;
  }
}

}  // namespace brume
