#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace brume {

// What long work listens to and tells.
struct Job {
  std::stop_token stop;
  std::function<void(double)> progress;  // the share that is done; may be empty

  // This job as one part of a longer one, whose progress it takes from `begin` to `end`.
  [[nodiscard]] Job part(double begin, double end) const;

  // Runs body(i) for i in [0, count) in parallel until a stop is requested.
  void each(std::size_t count, const std::function<void(std::size_t)>& body) const;

  // The same, and reports progress after each.
  void each_reported(std::size_t count, const std::function<void(std::size_t)>& body) const;
};

}  // namespace brume
