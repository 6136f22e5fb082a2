#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/authoring/random_source.h"
#include "core/medium/gaussian.h"

namespace brume {

// The airbrush of section 6 of the paper: particles of infinite life that bounce off surfaces,
// spread, and are frozen where they are when it stops.
struct Airbrush {
  double radius = 0.2;   // of each particle's Gaussian [u], > 0
  double density = 0.5;  // [1/u], >= 0
  double rate = 60.0;    // particles per second
  double speed = 1.0;    // with which they leave, along the spray's direction [u/s]
  double spread = 0.7;   // greatest random part of that, over the speed
  double wander = 0.5;   // how much they are pushed about: [u/s] in each second

  bool operator==(const Airbrush&) const = default;
};

// The nearest surface on a ray.
struct Obstacle {
  double distance = 0.0;
  glm::dvec3 normal{0.0};  // unit, on the side the ray comes from
};
// Of a ray from a point in a unit direction; nullopt: none.
using FindObstacle =
    std::function<std::optional<Obstacle>(const glm::dvec3& from, const glm::dvec3& direction)>;

// Where the spray comes out, and in which unit direction.
struct Nozzle {
  glm::dvec3 position{0.0};
  glm::dvec3 direction{0.0};
};
// At a moment of a step, from 0 (its beginning) to 1; nullopt: nothing comes out.
using FindNozzle = std::function<std::optional<Nozzle>(double moment)>;

// A spray in the making.
class Spray {
 public:
  Spray(const Airbrush& airbrush, std::uint64_t seed) : airbrush_(airbrush), random_(seed) {}

  // Goes on for `seconds` (>= 0), in which the nozzle may move.
  void advance(double seconds, const FindNozzle& find_nozzle, const FindObstacle& find_obstacle);

  // Where the particles are, the oldest first.
  [[nodiscard]] std::vector<Gaussian> frozen() const;

 private:
  struct Particle {
    glm::dvec3 position{0.0};
    glm::dvec3 velocity{0.0};
  };
  void push_about(Particle& particle, double seconds);
  void fly(Particle& particle, double seconds, const FindObstacle& find_obstacle) const;

  Airbrush airbrush_;
  RandomSource random_;
  std::vector<Particle> particles_;
  double due_ = 0.0;  // particles that time has earned
};

}  // namespace brume
