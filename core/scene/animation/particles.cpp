#include "core/scene/animation/particles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "brume/limits.h"
#include "core/math/random_source.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/animation/keys_in_domain.h"

namespace brume {
namespace {

// Seeds of neighbouring particles must not be neighbours (splitmix64).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

Gaussian particle(const Emitter& emitter, std::uint64_t number, double age) {
  RandomSource random(mixed(mixed(static_cast<std::uint64_t>(emitter.seed)) + number));
  const glm::dvec3 velocity = emitter.velocity + emitter.spread * random.in_ball();
  const glm::dvec3 center =
      emitter.position + age * velocity + 0.5 * age * age * emitter.acceleration;
  const double relative_age = age / emitter.lifetime;
  GaussianOptics optics = emitter.optics;
  optics.emission = glm::mix(optics.emission, emitter.emission_at_death, relative_age);
  return {glm::clamp(center, -limits::coordinate, limits::coordinate),
          glm::mix(emitter.radius.x, emitter.radius.y, relative_age),
          glm::mix(emitter.density.x, emitter.density.y, relative_age), optics};
}

// The greatest value that a value or its keyframes reach, which is not negative.
double max_of(double value, const Keys<double>& keys) {
  return keys.empty() ? value : domain::not_negative.nearest(upper_bound(keys));
}

// When an emitter's particles are born.
class Births {
 public:
  explicit Births(const Emitter& emitter) : rate_(emitter.rate), keys_(emitter.keys.rate) {
    for (const Key<double>& key : keys_) {
      if (key.time <= times_.back()) continue;
      counts_.push_back(counts_.back() + integral_above(0.0, keys_, times_.back(), key.time));
      times_.push_back(key.time);
    }
    if (!keys_.empty()) rate_ = keys_.back().value;
  }

  // The integral of the rate from 0 to a time >= 0.
  [[nodiscard]] double count(double time) const {
    const std::size_t i = last_until(times_, time);
    return counts_[i] + (i + 1 < times_.size() ? integral_above(0.0, keys_, times_[i], time)
                                               : (time - times_[i]) * rate_);
  }

  // When the integral passes a number; infinity if it never does.
  [[nodiscard]] double time(double number) const {
    const std::size_t i = last_until(counts_, number);
    if (i + 1 == times_.size()) {
      return rate_ > 0.0 ? times_[i] + (number - counts_[i]) / rate_
                         : std::numeric_limits<double>::infinity();
    }
    double low = times_[i];
    double high = times_[i + 1];
    while (high - low > precision * std::max(1.0, high)) {
      const double middle = 0.5 * (low + high);
      (counts_[i] + integral_above(0.0, keys_, times_[i], middle) <= number ? low : high) = middle;
    }
    return low;
  }

 private:
  static constexpr double precision = 1e-9;  // [s], beyond 1 s relative

  static std::size_t last_until(const std::vector<double>& values, double value) {
    const auto after = std::upper_bound(values.begin(), values.end(), value);
    return static_cast<std::size_t>(after - values.begin()) - 1;
  }

  double rate_;  // after the last key
  const Keys<double>& keys_;
  // Time 0 and those of the keys after it, and the integral up to each.
  std::vector<double> times_{0.0};
  std::vector<double> counts_{0.0};
};

}  // namespace

std::size_t max_particles(const Emitter& emitter) {
  const double rate = max_of(emitter.rate, emitter.keys.rate);
  const double lifetime = max_of(emitter.lifetime, emitter.keys.lifetime);
  if (!(rate > 0.0) || !(lifetime > 0.0)) return 0;
  // One more, where one is born as another dies.
  return static_cast<std::size_t>(
      std::min(std::ceil(rate * lifetime) + 1.0, double{particle_limit}));
}

double emitted_until(const Emitter& emitter, double time) {
  return Births(emitter).count(time);
}

std::vector<Gaussian> particles_at(const Emitter& emitter, double time) {
  std::vector<Gaussian> particles;
  if (max_particles(emitter) == 0 || !(time >= 0.0)) return particles;
  const Births births(emitter);
  const double last = std::floor(births.count(time));
  // Beyond this, particle numbers are no longer exact integers.
  if (!(last < 9e15)) return particles;
  const double longest = max_of(emitter.lifetime, emitter.keys.lifetime);
  double first = std::floor(births.count(std::max(0.0, time - longest)));
  first = std::max(first, last - particle_limit + 1.0);
  Emitter at_birth = emitter;
  for (double number = first; number <= last; number += 1.0) {
    const double birth = births.time(number);
    visit_keyed(at_birth,
                [birth](const char*, auto& value, const auto& keys, const NumberDomain& domain) {
                  if (!keys.empty()) value = value_at(keys, birth, domain);
                });
    const double age = time - birth;
    if (age < 0.0 || age >= at_birth.lifetime) continue;
    particles.push_back(particle(at_birth, static_cast<std::uint64_t>(number), age));
  }
  return particles;
}

}  // namespace brume
