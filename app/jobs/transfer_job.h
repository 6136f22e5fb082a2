#pragma once

#include <memory>
#include <thread>
#include <vector>

#include "app/jobs/job_bar.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// Precomputes radiance transfer of the current scene in the background; frames are rendered without
// it meanwhile.
class TransferJob : public JobBar {
  Q_OBJECT
 public:
  explicit TransferJob(QWidget* parent = nullptr);
  ~TransferJob() override;  // cancels

  [[nodiscard]] std::shared_ptr<const TransferStore> transfers() const { return transfers_; }
  [[nodiscard]] bool is_running() const { return running_; }

  // Computes what this scene needs, replacing a previous run. After cancelling, does not restart
  // until the needs change.
  void follow(const Scene& scene);
  void cancel();

 Q_SIGNALS:
  void made();  // frames should be rendered again
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
