#pragma once

#include <functional>
#include <thread>

#include "app/job_bar.h"
#include "render/job.h"

namespace brume {

// Work in a thread of its own, whose result is taken in the main thread.
class BackgroundJob : public JobBar {
  Q_OBJECT
 public:
  explicit BackgroundJob(QWidget* parent = nullptr);
  ~BackgroundJob() override;  // gives up

  [[nodiscard]] bool is_running() const { return running_; }

  // What is done with the result, in the main thread.
  using Take = std::function<void()>;
  // May throw; returns early when it is stopped, and is then not taken.
  using Work = std::function<Take(const Job&)>;
  // One at a time: false, and nothing done, while another runs.
  bool start(const QString& title, const Work& work);
  void cancel();

 Q_SIGNALS:
  void finished();
  void cancelled();
  void failed(const QString& message);

 private:
  void end(const Take& take, const QString& problem);

  bool running_ = false;
  bool cancelled_ = false;
  std::jthread thread_;
};

}  // namespace brume
