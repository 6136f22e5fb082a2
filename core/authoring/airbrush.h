#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "brume/gaussian.h"
#include "core/math/random_source.h"

namespace brume {

// The airbrush of section 6 of the paper: sprayed particles bounce off surfaces, spread, and are
// frozen into Gaussians at the end.
struct Airbrush {
  double radius = 0.2;   // of each particle's Gaussian, across its way [u], > 0
  double density = 0.5;  // [1/u], >= 0
  double rate = 60.0;    // particles per second, of balls
  double speed = 1.0;    // initial speed along the spray direction [u/s]
  double spread = 0.7;   // maximum random velocity, relative to the speed
  double wander = 0.5;   // random acceleration [u/s^2]
  double jitter = 0.0;   // random factors of radius and density, as a paintbrush has
  double stretch = 1.0;  // the radius along the way over that across it, >= 1: so many times fewer

  bool operator==(const Airbrush&) const = default;
};

// The nearest surface on a ray.
struct Obstacle {
  double distance = 0.0;
  glm::dvec3 normal{0.0};  // unit, facing the ray's origin
};
// Traces a ray in a unit direction; nullopt: no hit.
using FindObstacle =
    std::function<std::optional<Obstacle>(const glm::dvec3& origin, const glm::dvec3& direction)>;

// Position and unit direction of the nozzle.
struct Nozzle {
  glm::dvec3 position{0.0};
  glm::dvec3 direction{0.0};
};
// The nozzle at a fraction of a time step, from 0 to 1; nullopt: off.
using FindNozzle = std::function<std::optional<Nozzle>(double moment)>;

// The state of one spray.
class Spray {
 public:
  Spray(const Airbrush& airbrush, std::uint64_t seed) : airbrush_(airbrush), random_(seed) {}

  // Multiplies radius and density of particles from now on, as the pressure of a pen does; > 0.
  void set_scale(double size, double strength) {
    size_ = size;
    strength_ = strength;
  }
  // Advances by `seconds` >= 0.
  void advance(double seconds, const FindNozzle& find_nozzle, const FindObstacle& find_obstacle);

  // The particles as Gaussians, oldest first.
  [[nodiscard]] std::vector<Gaussian> frozen() const;

 private:
  struct Particle {
    glm::dvec3 position{0.0};
    glm::dvec3 velocity{0.0};
    double radius = 0.0;
    double density = 0.0;
  };
  void perturb(Particle& particle, double seconds);
  void advance_particle(Particle& particle, double seconds,
                        const FindObstacle& find_obstacle) const;

  Airbrush airbrush_;
  RandomSource random_;
  std::vector<Particle> particles_;
  double size_ = 1.0;
  double strength_ = 1.0;
  double due_ = 0.0;  // particles due, fractional
};

}  // namespace brume
