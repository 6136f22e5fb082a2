#include "render/util/job.h"

#include <tbb/parallel_for.h>

#include <mutex>

#include "render/util/flush_denormals.h"

namespace brume {

Job Job::subrange(double begin, double end) const {
  if (!progress) return {stop, {}};
  return {stop, [report = progress, begin, end](double fraction) {
            report(begin + fraction * (end - begin));
          }};
}

void Job::parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) const {
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (stop.stop_requested()) return;
    const FlushDenormals flush;
    body(i);
  });
}

void Job::parallel_for_with_progress(std::size_t count,
                                     const std::function<void(std::size_t)>& body) const {
  if (!progress) return parallel_for(count, body);
  std::size_t done = 0;
  std::mutex mutex;
  parallel_for(count, [&](std::size_t i) {
    body(i);
    const std::scoped_lock lock(mutex);
    progress(static_cast<double>(++done) / static_cast<double>(count));
  });
}

}  // namespace brume
