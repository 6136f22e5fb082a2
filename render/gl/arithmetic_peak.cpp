#include "render/gl/arithmetic_peak.h"

#include <algorithm>
#include <limits>

#include "render/gl/programs.h"

namespace brume::gl {
namespace {

// Operations of one kind per second, with so many in each round.
double rate(const Program& program, Buffer& results, int kind, double operations,
            double milliseconds) {
  constexpr std::size_t max_groups = 8192;
  const int group = program.group_size().x;
  results.reserve(max_groups * static_cast<std::size_t>(group) * sizeof(float));
  program.bind("Results", results);
  program.set("kind", kind);
  program.set("seed", 1e-4f);
  std::size_t groups = 16;
  int count = 16;
  const auto run = [&] {
    program.set("count", count);
    Timer timer;
    timer.begin();
    program.dispatch(groups);
    timer.end();
    check("measuring arithmetic");
    return timer.milliseconds();
  };
  // Wider until all of the device is busy, then longer.
  while (run() < milliseconds && count < (1 << 24)) {
    if (groups < max_groups) {
      groups *= 2;
    } else {
      count *= 2;
    }
  }
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) best = std::min(best, run());
  return operations * count * static_cast<double>(groups) * group / (1e-3 * std::max(best, 1e-9));
}

}  // namespace

ArithmeticPeak measure_peak(Context& context, double milliseconds) {
  if (!context.make_current()) throw Error("the context cannot be made current");
  ArithmeticPeak peak;
  {
    Programs programs;
    Buffer results;
    const Program& program = programs["arithmetic_peak"];
    peak.multiply_adds = rate(program, results, 0, 8.0, milliseconds);
    peak.exponentials = rate(program, results, 1, 8.0, milliseconds);
    peak.pairs = rate(program, results, 2, 1.0, milliseconds);
  }
  context.done_current();
  return peak;
}

}  // namespace brume::gl
