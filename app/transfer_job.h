#pragma once

#include <memory>
#include <thread>
#include <vector>

#include "app/job_bar.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// Precomputes the radiance transfer of the scene that is shown, in the background: frames come
// without until it is there.
class TransferJob : public JobBar {
  Q_OBJECT
 public:
  explicit TransferJob(QWidget* parent = nullptr);
  ~TransferJob() override;  // gives up

  [[nodiscard]] std::shared_ptr<const TransferStore> transfers() const { return transfers_; }
  [[nodiscard]] bool is_running() const { return running_; }

  // Makes what this scene needs, instead of what another did. What was cancelled is not begun
  // again until something else is needed.
  void follow(const Scene& scene);
  void cancel();

 Q_SIGNALS:
  void made();  // frames are due again
  void warned(const QString& message);
  void failed(const QString& message);

 private:
  void start();
  void end(bool is_made, const QString& warnings, const QString& problem);

  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::vector<TransferRequest> needed_;
  std::vector<TransferRequest> being_made_;
  bool running_ = false;
  bool cancelled_ = false;  // by the user
  std::jthread thread_;
};

}  // namespace brume
