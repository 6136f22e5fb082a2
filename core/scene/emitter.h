#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace brume {

// A source of particles (section 6 of the paper): from time 0 on they leave it at a constant rate
// on parabolas, each a Gaussian that changes its size and density over its life.
// core/authoring/particles.h says where they are.
struct Emitter {
  glm::dvec3 position{0.0};
  double rate = 10.0;                  // particles per second, >= 0
  double lifetime = 3.0;               // of each [s], >= 0
  glm::dvec3 velocity{0.0, 1.0, 0.0};  // at birth [u/s]
  double spread = 0.3;                 // greatest random part of that [u/s], >= 0
  glm::dvec3 acceleration{0.0};        // [u/s^2]
  glm::dvec2 radius{0.1, 0.4};         // at birth and at death [u], > 0
  glm::dvec2 density{1.0, 0.0};        // at birth and at death [1/u], >= 0
  std::int64_t seed = 0;
  std::string unknown;  // as UnknownKeys of core/scene/scene.h

  bool operator==(const Emitter&) const = default;
};

}  // namespace brume
