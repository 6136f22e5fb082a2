#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace brume {

// A thread that runs the latest job; a new one stops the current. Starting and cancelling never
// block; destruction does.
template <class Job>
class JobThread {
 public:
  // Runs in the thread; must not throw.
  using Work = std::function<void(Job, const std::stop_token&)>;

  explicit JobThread(Work work)
      : thread_([this, work = std::move(work)](const std::stop_token& quit) { run(work, quit); }) {}
  ~JobThread() {
    thread_.request_stop();
    cancel();
    thread_.join();
  }
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  void start(Job job) {
    const std::scoped_lock lock(mutex_);
    stop_.request_stop();
    pending_ = std::move(job);
    wake_.notify_one();
  }

  void cancel() {
    const std::scoped_lock lock(mutex_);
    stop_.request_stop();
    pending_.reset();
  }

 private:
  void run(const Work& work, const std::stop_token& quit) {
    while (true) {
      std::optional<Job> job;
      std::stop_token stop;
      {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, quit, [this] { return pending_.has_value(); })) return;
        job.swap(pending_);
        stop_ = std::stop_source();
        if (quit.stop_requested()) return;
        stop = stop_.get_token();
      }
      work(std::move(*job), stop);
    }
  }

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Job> pending_;
  std::stop_source stop_;
  std::jthread thread_;
};

}  // namespace brume
