#include "core/scene/particles.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/limits.h"
#include "core/math/random_source.h"

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
  return {glm::clamp(center, -limits::coordinate, limits::coordinate),
          glm::mix(emitter.radius.x, emitter.radius.y, relative_age),
          glm::mix(emitter.density.x, emitter.density.y, relative_age)};
}

}  // namespace

std::size_t max_particles(const Emitter& emitter) {
  if (!(emitter.rate > 0.0) || !(emitter.lifetime > 0.0)) return 0;
  // One more, where one is born as another dies.
  return static_cast<std::size_t>(
      std::min(std::ceil(emitter.rate * emitter.lifetime) + 1.0, double{particle_limit}));
}

std::vector<Gaussian> particles_at(const Emitter& emitter, double time) {
  std::vector<Gaussian> particles;
  if (!(emitter.rate > 0.0) || !(emitter.lifetime > 0.0) || !(time >= 0.0)) return particles;
  const double last = std::floor(time * emitter.rate);
  // Beyond this, particle numbers are no longer exact integers.
  if (!(last < 9e15)) return particles;
  double first = std::max(0.0, std::floor((time - emitter.lifetime) * emitter.rate));
  first = std::max(first, last - particle_limit + 1.0);
  for (double number = first; number <= last; number += 1.0) {
    const double age = time - number / emitter.rate;
    if (age < 0.0 || age >= emitter.lifetime) continue;
    particles.push_back(particle(emitter, static_cast<std::uint64_t>(number), age));
  }
  return particles;
}

}  // namespace brume
