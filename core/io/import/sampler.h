#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "brume/keys.h"
#include "brume/limits.h"

namespace brume {

// Values between keys may be off by this share of the way that they take in all, directions and
// rotations by this angle [radians].
inline constexpr double max_share = 5e-4;
inline constexpr double max_angle = 1e-3;

// Values jump in this time [s].
inline constexpr double jump_time = 2.0 * min_key_distance;

template <class State>
struct Sample {
  double time = 0.0;
  State state{};
  bool is_held = false;  // until the next one
};

// Samples a function of time so that it is linear between samples. `Measure` has
// mixed(a, b, share), and distance(a, b) in units of what is allowed.
template <class StateAt, class Measure>
class Sampler {
 public:
  using State = std::invoke_result_t<StateAt, double>;

  Sampler(const StateAt& state_at, const Measure& measure, const std::filesystem::path& file)
      : state_at_(state_at), measure_(measure), file_(file) {}

  std::vector<Sample<State>> run(const std::vector<double>& times) {
    double begin = times.front();
    for (const double time : times) {
      if (time - begin < 4.0 * jump_time) continue;
      add_interval(begin, time);
      begin = time;
    }
    add(begin, state_at_(begin));
    return std::move(samples_);
  }

 private:
  // Adds samples from a time on, without the end.
  void add_interval(double begin, double end) {
    constexpr int max_depth = 6;
    const State first = state_at_(begin);
    const State last = state_at_(end);
    const State end_state = state_at_(end - jump_time);
    add(begin, first);
    if (measure_.distance(end_state, last) <= 1.0) {
      refine({begin, first}, {end, last}, max_depth);
      return;
    }
    if (measure_.distance(first, end_state) <= 1e-3 &&
        is_linear({begin, first}, {end - jump_time, end_state})) {
      samples_.back().is_held = true;
      return;
    }
    refine({begin, first}, {end - jump_time, end_state}, max_depth);
    add(end - jump_time, end_state);
  }

  [[nodiscard]] bool is_linear(const Sample<State>& a, const Sample<State>& b) const {
    return std::ranges::all_of(std::array{0.5, 0.25, 0.75}, [&](double share) {
      const State found = state_at_(a.time + share * (b.time - a.time));
      return measure_.distance(found, measure_.mixed(a.state, b.state, share)) <= 1.0;
    });
  }

  void refine(const Sample<State>& a, const Sample<State>& b, int depth) {
    if (depth == 0 || b.time - a.time < 4.0 * jump_time || is_linear(a, b)) return;
    const double time = 0.5 * (a.time + b.time);
    const Sample<State> middle{time, state_at_(time)};
    refine(a, middle, depth - 1);
    add(time, middle.state);
    refine(middle, b, depth - 1);
  }

  void add(double time, const State& state) {
    if (samples_.size() >= limits::keys_of_value) {
      throw InputError(file_, "",
                       "the animation of a node needs more than the allowed " +
                           std::to_string(limits::keys_of_value) + " keyframes");
    }
    samples_.push_back({time, state});
  }

  const StateAt& state_at_;
  const Measure& measure_;
  const std::filesystem::path& file_;
  std::vector<Sample<State>> samples_;
};

}  // namespace brume
