#pragma once

#include <functional>
#include <thread>

#include "app/jobs/job_bar.h"
#include "render/util/job.h"

namespace brume {

// Runs work in a background thread and applies its result in the main thread.
class BackgroundJob : public JobBar {
  Q_OBJECT
 public:
  explicit BackgroundJob(QWidget* parent = nullptr);
  ~BackgroundJob() override;  // cancels

  [[nodiscard]] bool is_running() const { return running_; }

  // Applies the result, in the main thread.
  using Apply = std::function<void()>;
  // May throw; returns early when stopped, and is then not applied.
  using Work = std::function<Apply(const Job&)>;
  // One at a time: false while another runs.
  bool start(const QString& title, const Work& work);
  void cancel();

 Q_SIGNALS:
  void finished();
  void cancelled();
  void failed(const QString& message);

 private:
  void end(const Apply& take, const QString& problem);

  bool running_ = false;
  bool cancelled_ = false;
  std::jthread thread_;
};

}  // namespace brume
