#pragma once

#include <QObject>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "render/util/job.h"

namespace brume {

// Owns a thread that runs work, and delivers the results in the main thread. Hold it as the last
// member of what its work and results use: destruction cancels, waits for the work, and delivers
// nothing more.
class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  // Says how start() behaves while work is running.
  enum class Policy { one_at_a_time, latest_wins };
  explicit BackgroundJob(Policy policy, QObject* parent = nullptr);
  ~BackgroundJob() override;

  // Uses a result, in the main thread.
  using Apply = std::function<void()>;
  // Runs in the thread. May throw; returns early when stopped, and is then not applied.
  using Work = std::function<Apply(const Job&)>;

  // One at a time: false while other work is running. Latest wins: stops that work, of which
  // nothing is delivered any more. Never waits.
  bool start(Work work, const QString& title = {});
  // One at a time: work is running until it has really ended. Latest wins: it counts as ended now.
  void cancel();
  [[nodiscard]] bool is_running() const { return running_; }

  // For the work: delivers a part of its result, unless it has been stopped by then.
  void deliver(const Job& job, Apply apply);

 Q_SIGNALS:
  void started(const QString& title);
  void progressed(int percent);
  void ended();  // before the result is applied and one of these
  void finished();
  void cancelled();
  void failed(const QString& message);

 private:
  void run(const std::stop_token& quit);
  void end(const std::stop_token& stop, const Apply& apply, const QString& problem);
  [[nodiscard]] std::function<void(double)> progress(const std::stop_token& stop);

  const Policy policy_;
  bool running_ = false;
  std::stop_source stop_;  // of the latest work
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<std::pair<Work, std::stop_token>> pending_;
  std::jthread thread_;
};

}  // namespace brume
