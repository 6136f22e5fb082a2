#include "app/jobs/background_job.h"

#include <exception>

namespace brume {

BackgroundJob::BackgroundJob(QWidget* parent) : JobBar(parent) {
  connect(this, &JobBar::cancel_clicked, this, &BackgroundJob::cancel);
}

BackgroundJob::~BackgroundJob() = default;

bool BackgroundJob::start(const QString& title, const Work& work) {
  if (running_) return false;
  running_ = true;
  cancelled_ = false;
  show_job(title);
  thread_ = std::jthread([this, work](const std::stop_token& stop) {
    Apply take;
    QString problem;
    try {
      take = work({stop, progress()});
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    }
    QMetaObject::invokeMethod(
        this, [this, take, problem] { end(take, problem); }, Qt::QueuedConnection);
  });
  return true;
}

void BackgroundJob::cancel() {
  cancelled_ = true;
  thread_.request_stop();
}

void BackgroundJob::end(const Apply& take, const QString& problem) {
  thread_.join();
  running_ = false;
  hide();
  if (cancelled_) {
    Q_EMIT cancelled();
  } else if (!problem.isEmpty()) {
    Q_EMIT failed(problem);
  } else {
    if (take) take();
    Q_EMIT finished();
  }
}

}  // namespace brume
