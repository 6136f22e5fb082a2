#pragma once

#include <tbb/parallel_for.h>
#include <xmmintrin.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>

namespace brume {

// While one lives, its thread flushes denormals: they are far below every tolerance, slow, and
// Embree expects it.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040u); }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

// What long work listens to and tells.
struct Job {
  std::stop_token stop;
  std::function<void(double)> progress;  // the share that is done; may be empty

  // This job as one part of a longer one, whose progress it takes from `begin` to `end`.
  [[nodiscard]] Job part(double begin, double end) const {
    if (!progress) return {stop, {}};
    return {stop,
            [tell = progress, begin, end](double share) { tell(begin + share * (end - begin)); }};
  }

  // Runs body(i) for i in [0, count) in parallel until a stop is requested.
  template <class Body>
  void each(std::size_t count, Body body) const {
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (stop.stop_requested()) return;
      const FlushDenormals flush;
      body(i);
    });
  }

  // The same, and reports progress after each.
  template <class Body>
  void each_reported(std::size_t count, Body body) const {
    if (!progress) return each(count, body);
    std::size_t done = 0;
    std::mutex mutex;
    each(count, [&](std::size_t i) {
      body(i);
      const std::scoped_lock lock(mutex);
      progress(static_cast<double>(++done) / static_cast<double>(count));
    });
  }
};

}  // namespace brume
