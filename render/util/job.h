#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace brume {

// Cancellation and progress of long-running work.
struct Job {
  std::stop_token stop;
  std::function<void(double)> progress;  // completed fraction in [0, 1]; may be empty

  // This job with its progress mapped to [begin, end] of the whole.
  [[nodiscard]] Job subrange(double begin, double end) const;

  // Runs body(i) for i in [0, count) in parallel until a stop is requested.
  void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) const;

  // Like parallel_for(), reporting progress.
  void parallel_for_with_progress(std::size_t count,
                                  const std::function<void(std::size_t)>& body) const;
};

}  // namespace brume
