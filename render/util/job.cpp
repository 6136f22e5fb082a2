#include "render/util/job.h"

#include <tbb/parallel_for.h>

#include <cstdint>
#include <mutex>

namespace brume {
namespace {

// While one lives, its thread flushes denormals: they are far below every tolerance, slow, and
// Embree expects it. No header of one processor family: what is neither x86 nor Arm keeps them.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(control()) { set_control(saved_ | flush_bits); }
  ~FlushDenormals() { set_control(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr std::uint64_t flush_bits = 0x8040;  // results and operands
  static std::uint64_t control() {
    return __builtin_ia32_stmxcsr();
  }
  static void set_control(std::uint64_t bits) {
    __builtin_ia32_ldmxcsr(static_cast<unsigned>(bits));
  }
#elif defined(__aarch64__)
  static constexpr std::uint64_t flush_bits = 1u << 24;
  static std::uint64_t control() {
    std::uint64_t bits = 0;
    asm volatile("mrs %0, fpcr" : "=r"(bits));
    return bits;
  }
  static void set_control(std::uint64_t bits) {
    asm volatile("msr fpcr, %0" : : "r"(bits));
  }
#else
  static constexpr std::uint64_t flush_bits = 0;
  static std::uint64_t control() {
    return 0;
  }
  static void set_control(std::uint64_t) {}
#endif

  std::uint64_t saved_;
};

}  // namespace

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
