#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/scene/object_id.h"

namespace brume {

// A particle emitter (section 6 of the paper): emits at a constant rate from time 0; particles
// follow parabolas, and their radius and density change over their life. Evaluated by
// core/scene/particles.h.
struct Emitter {
  glm::dvec3 position{0.0};
  double rate = 10.0;                  // particles per second, >= 0
  double lifetime = 3.0;               // [s], >= 0
  glm::dvec3 velocity{0.0, 1.0, 0.0};  // at birth [u/s]
  double spread = 0.3;                 // maximum random velocity [u/s], >= 0
  glm::dvec3 acceleration{0.0};        // [u/s^2]
  glm::dvec2 radius{0.1, 0.4};         // at birth and at death [u], > 0
  glm::dvec2 density{1.0, 0.0};        // at birth and at death [1/u], >= 0
  std::int64_t seed = 0;
  ObjectId id = 0;

  bool operator==(const Emitter&) const = default;
};

}  // namespace brume
