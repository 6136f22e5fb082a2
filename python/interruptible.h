#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <stop_token>

#include "python/vectors.h"

namespace brume::python {

// Runs work(stop, progress) in a thread of its own, without the interpreter's lock, and meanwhile
// serves Python: signals (Ctrl-C stops the work and raises KeyboardInterrupt) and `progress`, a
// callable that gets the completed fraction, or None; what it raises stops the work, too.
template <class Work>
auto interruptible(Work work, const pybind11::object& progress) {
  constexpr std::chrono::milliseconds patience(20);
  std::stop_source stop;
  std::atomic<double> completed{0.0};
  auto result = std::async(std::launch::async, [&] {
    return work(stop.get_token(), std::function<void(double)>([&completed](double fraction) {
                  completed.store(fraction, std::memory_order_relaxed);
                }));
  });
  const auto is_done = [&result, patience] {
    const pybind11::gil_scoped_release release;
    return result.wait_for(patience) == std::future_status::ready;
  };
  try {
    while (!is_done()) {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (!progress.is_none()) progress(completed.load(std::memory_order_relaxed));
    }
  } catch (...) {
    stop.request_stop();
    const pybind11::gil_scoped_release release;
    result.wait();
    throw;
  }
  auto finished = result.get();
  if (!progress.is_none()) progress(1.0);
  return finished;
}

}  // namespace brume::python
