#include "app/jobs/transfer_job.h"

#include <QStringList>
#include <exception>

#include "render/render_plan.h"
#include "render/transfer/transfer_cache.h"

namespace brume {

TransferJob::TransferJob(QWidget* parent) : JobBar(parent) {
  connect(this, &JobBar::cancel_clicked, this, &TransferJob::cancel);
}

TransferJob::~TransferJob() = default;

void TransferJob::follow(const Scene& scene) {
  std::vector<TransferRequest> needed = needed_transfers(scene);
  if (needed == needed_) return;
  needed_ = std::move(needed);
  cancelled_ = false;
  if (running_) {
    thread_.request_stop();  // end() goes on
  } else {
    start();
  }
}

void TransferJob::start() {
  if (transfers_->has(needed_)) {
    transfers_->make(needed_, {});  // forgets the others
    return;
  }
  running_ = true;
  being_made_ = needed_;
  show_job(tr("Radiance transfer"));
  thread_ = std::jthread([this, requests = needed_](const std::stop_token& stop) {
    bool is_made = false;
    QStringList lines;
    QString problem;
    try {
      std::vector<std::string> warnings;
      is_made = transfers_->make(requests, cache_folder(), {stop, progress()}, &warnings);
      for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this, [this, is_made, text = lines.join('\n'), problem] { end(is_made, text, problem); },
        Qt::QueuedConnection);
  });
}

void TransferJob::cancel() {
  cancelled_ = true;
  thread_.request_stop();
}

void TransferJob::end(bool is_made, const QString& warnings, const QString& problem) {
  thread_.join();
  running_ = false;
  hide();
  if (!warnings.isEmpty()) Q_EMIT warned(warnings);
  if (!problem.isEmpty()) Q_EMIT failed(problem);
  if (being_made_ != needed_) {
    start();
  } else if (is_made) {
    Q_EMIT made();
  } else if (problem.isEmpty() && !cancelled_) {
    start();  // given up for something else, and needed again
  }
}

}  // namespace brume
