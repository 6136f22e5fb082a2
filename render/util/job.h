#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace brume {

// Cancellation and progress of long-running work.
struct Job {
  std::stop_token stop;
  std::function<void(double)> progress;  // completed fraction in [0, 1]; may be empty

  // A job for one part of this one, whose progress runs from `begin` to `end`.
  [[nodiscard]] Job part(double begin, double end) const;

  // Runs body(i) for i in [0, count) in parallel until a stop is requested.
  void each(std::size_t count, const std::function<void(std::size_t)>& body) const;

  // Like each(), reporting progress.
  void each_reported(std::size_t count, const std::function<void(std::size_t)>& body) const;
};

}  // namespace brume
