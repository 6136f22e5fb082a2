#include "app/jobs/transfer_job.h"

#include <QStringList>

#include "render/render_plan.h"
#include "render/transfer/transfer_cache.h"

namespace brume {

void TransferJob::follow(const Scene& scene, const Settings& settings) {
  std::vector<TransferRequest> needed = needed_transfers(scene, settings);
  if (needed == needed_) return;
  needed_ = std::move(needed);
  const bool forgets_only = transfers_->has(needed_);
  const auto work = [this, requests = needed_,
                     forgets_only](const Job& job) -> BackgroundJob::Apply {
    std::vector<std::string> warnings;
    const bool is_made = transfers_->make(requests, cache_folder(), job, &warnings);
    QStringList lines;
    for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
    return [this, is_made, forgets_only, lines] {
      if (!lines.isEmpty()) Q_EMIT warned(lines.join('\n'));
      if (is_made && !forgets_only) Q_EMIT made();
    };
  };
  job_.start(work, forgets_only ? QString() : tr("Radiance transfer"));
}

}  // namespace brume
