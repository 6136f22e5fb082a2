#include "core/authoring/airbrush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/authoring/paintbrush.h"

namespace brume {
namespace {

constexpr int max_bounces = 8;       // in one step; a particle in a crack stays there
constexpr double drag = 1.5;         // drag coefficient [1/s]
constexpr double restitution = 0.6;  // of the speed into a surface
constexpr double clearance = 0.02;   // distance from surfaces, relative to the radius

}  // namespace

void Spray::advance(double seconds, const FindNozzle& find_nozzle,
                    const FindObstacle& find_obstacle) {
  for (Particle& particle : particles_) {
    perturb(particle, seconds);
    advance_particle(particle, seconds, find_obstacle);
  }
  due_ += airbrush_.rate / airbrush_.stretch * seconds;
  for (; due_ >= 1.0; due_ -= 1.0) {
    const glm::dvec3 aside = airbrush_.spread * random_.in_ball();
    // Born at some moment of the step, not all at its end.
    const double age = random_.uniform();
    const std::optional<Nozzle> nozzle = find_nozzle(1.0 - age);
    if (!nozzle) continue;
    Particle particle{nozzle->position, airbrush_.speed * (nozzle->direction + aside),
                      airbrush_.radius * size_ * jitter_factor(airbrush_.jitter, random_),
                      airbrush_.density * strength_ * jitter_factor(airbrush_.jitter, random_)};
    advance_particle(particle, seconds * age, find_obstacle);
    particles_.push_back(particle);
  }
}

void Spray::perturb(Particle& particle, double seconds) {
  particle.velocity *= std::exp(-drag * seconds);
  // Steps of a random walk add up by their squares.
  particle.velocity += airbrush_.wander * std::sqrt(3.0 * seconds) * random_.in_ball();
}

void Spray::advance_particle(Particle& particle, double seconds,
                             const FindObstacle& find_obstacle) const {
  double left = seconds;
  const double gap = clearance * airbrush_.radius;
  for (int bounce = 0; bounce < max_bounces; ++bounce) {
    const double speed = glm::length(particle.velocity);
    const double way = speed * left;
    if (!(way > 0.0)) return;
    const glm::dvec3 direction = particle.velocity / speed;
    const auto obstacle = find_obstacle(particle.position, direction);
    if (!obstacle || obstacle->distance > way + gap) {
      particle.position += way * direction;
      return;
    }
    // Only along the way that is known to be free, so that no corner lets a particle through.
    const double free = std::max(0.0, obstacle->distance - gap);
    particle.position += free * direction;
    left -= free / speed;
    const double into = glm::dot(particle.velocity, obstacle->normal);
    if (into < 0.0) particle.velocity -= (1.0 + restitution) * into * obstacle->normal;
  }
}

std::vector<Gaussian> Spray::frozen() const {
  std::vector<Gaussian> gaussians;
  gaussians.reserve(particles_.size());
  for (const Particle& particle : particles_) {
    const Gaussian ball{particle.position, particle.radius, particle.density};
    const double speed = glm::length(particle.velocity);
    gaussians.push_back(speed > 0.0 ? stretched(ball, particle.velocity / speed, airbrush_.stretch)
                                    : ball);
  }
  return gaussians;
}

}  // namespace brume
