#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "brume/gaussian.h"
#include "brume/keys.h"
#include "brume/object_id.h"

namespace brume {

// Keyframes of an emitter's values; see core/scene/animation/animation.h.
struct EmitterKeys {
  Keys<glm::dvec3> position;
  Keys<double> rate;
  Keys<double> lifetime;
  Keys<glm::dvec3> velocity;
  Keys<double> spread;
  Keys<glm::dvec3> acceleration;
  Keys<glm::dvec2> radius;
  Keys<glm::dvec2> density;
  Keys<glm::dvec3> albedo;  // of one with an albedo of its own
  Keys<glm::dvec3> emission;
  Keys<glm::dvec3> emission_at_death;

  bool operator==(const EmitterKeys&) const = default;
};

// A particle emitter (section 6 of the paper): emits from time 0; particles follow parabolas, and
// their radius, density and emission change over their life. Evaluated by
// core/scene/animation/particles.h.
struct Emitter {
  glm::dvec3 position{0.0};
  double rate = 10.0;                  // particles per second, >= 0
  double lifetime = 3.0;               // [s], >= 0
  glm::dvec3 velocity{0.0, 1.0, 0.0};  // at birth [u/s]
  double spread = 0.3;                 // maximum random velocity [u/s], >= 0
  glm::dvec3 acceleration{0.0};        // [u/s^2]
  glm::dvec2 radius{0.1, 0.4};         // at birth and at death [u], > 0
  glm::dvec2 density{1.0, 0.0};        // at birth and at death [1/u], >= 0
  GaussianOptics optics{};             // at birth; the albedo for life
  glm::dvec3 emission_at_death{0.0};   // RGB >= 0, as the emission in `optics`
  std::int64_t seed = 0;
  EmitterKeys keys{};
  std::string name{};   // empty: none of its own
  bool visible = true;  // else no frame has its particles: evaluate_at() leaves them out
  bool locked = false;  // for editors: not to be changed in the view
  ObjectId id = 0;

  bool operator==(const Emitter&) const = default;
};

}  // namespace brume
