#pragma once

#include <memory>
#include <vector>

#include "app/jobs/background_job.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// Precomputes radiance transfer of the current scene in the background; frames are rendered without
// it meanwhile.
class TransferJob : public QObject {
  Q_OBJECT
 public:
  explicit TransferJob(QObject* parent = nullptr) : QObject(parent) {}

  [[nodiscard]] std::shared_ptr<const TransferStore> transfers() const { return transfers_; }
  [[nodiscard]] BackgroundJob& job() { return job_; }

  // Computes what this scene needs with these settings, replacing a previous run. After cancelling,
  // does not restart until the needs change.
  void follow(const Scene& scene, const Settings& settings);

 Q_SIGNALS:
  void made();  // frames should be rendered again
  void warned(const QString& message);

 private:
  std::shared_ptr<TransferStore> transfers_ = std::make_shared<TransferStore>();
  std::vector<TransferRequest> needed_;
  BackgroundJob job_{BackgroundJob::Policy::latest_wins};
};

}  // namespace brume
