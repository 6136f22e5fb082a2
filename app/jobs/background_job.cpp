#include "app/jobs/background_job.h"

#include <QCoreApplication>
#include <QPointer>
#include <atomic>
#include <exception>
#include <memory>

namespace brume {

BackgroundJob::BackgroundJob(Policy policy, QObject* parent)
    : QObject(parent),
      policy_(policy),
      thread_([this](const std::stop_token& quit) { run(quit); }) {}

BackgroundJob::~BackgroundJob() {
  stop_.request_stop();
  // Results go before what they may need to go, such as an OpenGL context of the thread.
  QCoreApplication::removePostedEvents(this);
  thread_.request_stop();
  thread_.join();
}

bool BackgroundJob::start(Work work, const QString& title) {
  if (running_ && policy_ == Policy::one_at_a_time) return false;
  stop_.request_stop();
  stop_ = std::stop_source();
  running_ = true;
  {
    const std::scoped_lock lock(mutex_);
    pending_.emplace(std::move(work), stop_.get_token());
  }
  wake_.notify_one();
  Q_EMIT started(title);
  return true;
}

void BackgroundJob::cancel() {
  if (!running_) return;
  stop_.request_stop();
  if (policy_ == Policy::latest_wins) end(stop_.get_token(), {}, {});
}

void BackgroundJob::run(const std::stop_token& quit) {
  while (true) {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, quit, [this] { return pending_.has_value(); })) return;
    auto [work, stop] = std::move(*pending_);
    pending_.reset();
    lock.unlock();
    Apply apply;
    QString problem;
    try {
      if (!stop.stop_requested()) apply = work({stop, progress(stop)});
    } catch (const std::exception& error) {
      problem = QString::fromUtf8(error.what());
    } catch (...) {
      problem = tr("Unknown error");
    }
    work = nullptr;  // what it holds goes before its end is known
    QMetaObject::invokeMethod(
        this, [=, this] { end(stop, apply, problem); }, Qt::QueuedConnection);
  }
}

void BackgroundJob::end(const std::stop_token& stop, const Apply& apply, const QString& problem) {
  if (!running_ || stop != stop_.get_token()) return;  // replaced, or ended already
  running_ = false;
  const QPointer<BackgroundJob> self(this);  // whoever is told may delete it
  Q_EMIT ended();
  if (!self) return;
  if (stop.stop_requested()) {
    Q_EMIT cancelled();
  } else if (!problem.isEmpty()) {
    Q_EMIT failed(problem);
  } else {
    if (apply) apply();
    if (self) Q_EMIT finished();
  }
}

void BackgroundJob::deliver(const Job& job, Apply apply) {
  QMetaObject::invokeMethod(
      this,
      [stop = job.stop, apply = std::move(apply)] {
        if (!stop.stop_requested()) apply();
      },
      Qt::QueuedConnection);
}

std::function<void(double)> BackgroundJob::progress(const std::stop_token& stop) {
  return [this, stop, told = std::make_shared<std::atomic<int>>(0)](double done) {
    const int percent = static_cast<int>(100.0 * done);
    if (percent == told->exchange(percent)) return;
    deliver({stop, {}}, [this, percent] { Q_EMIT progressed(percent); });
  };
}

}  // namespace brume
