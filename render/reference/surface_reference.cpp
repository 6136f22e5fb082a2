#include "render/reference/surface_reference.h"

#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <random>
#include <vector>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/point_lights.h"
#include "core/scene/materials/brdf.h"
#include "core/transport/light_path.h"
#include "core/transport/optical_depth.h"
#include "core/transport/phase_function.h"

namespace brume {
namespace {

using std::numbers::pi;

class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  // In (0, 1).
  double operator()() { return (static_cast<double>(engine_() >> 12) + 0.5) * 0x1p-52; }

 private:
  std::mt19937_64 engine_;
};

// The unit direction at an angle to `axis` and an azimuth around it.
glm::dvec3 around(const glm::dvec3& axis, double cosine, double phi) {
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const glm::dquat frame = surface_frame(axis, axis);
  return frame * glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine);
}

// The medium along one ray.
class Ray {
 public:
  Ray(std::span<const GaussianTerm<double>> gaussians, double b0, const glm::dvec3& origin,
      const glm::dvec3& w)
      : gaussians_(gaussians), b0_(b0), origin_(origin), w_(w) {
    for (const auto& g : gaussians) lines_.push_back(line_profile(g, origin, w));
  }

  [[nodiscard]] glm::dvec3 at(double t) const { return origin_ + t * w_; }

  [[nodiscard]] double density(double t) const {
    double sum = b0_;
    for (const auto& g : gaussians_) {
      const glm::dvec3 q = g.scaled(at(t));
      sum += g.c * std::exp(-glm::dot(q, q));
    }
    return sum;
  }

  [[nodiscard]] double depth(double t) const {
    double sum = b0_ > 0.0 ? b0_ * t : 0.0;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      sum += optical_depth(gaussians_[i], lines_[i], t);
    return sum;
  }

  // The parameter in [0, end] where the depth is `level`, by Newton's steps, or by bisection where
  // these leave the interval; end may be +inf.
  [[nodiscard]] double parameter_at(double level, double end) const {
    double low = 0.0;
    double high = 1.0;
    while (high < end && high < 1e15 && depth(high) < level) {
      low = high;
      high *= 2.0;
    }
    high = std::min(high, end);
    double t = 0.5 * (low + high);
    for (int i = 0; i < 60; ++i) {
      const double excess = depth(t) - level;
      (excess < 0.0 ? low : high) = t;
      const double step = t - excess / density(t);
      const double next = low <= step && step <= high ? step : 0.5 * (low + high);
      const bool has_converged = std::abs(next - t) <= 1e-13 * next;
      t = next;
      if (has_converged) break;
    }
    return t;
  }

 private:
  std::span<const GaussianTerm<double>> gaussians_;
  double b0_;
  glm::dvec3 origin_;
  glm::dvec3 w_;
  std::vector<LineProfile<double>> lines_;
};

// Mean and standard error of samples.
class Mean {
 public:
  void add(const glm::dvec3& value) {
    // Welford's update keeps the digits of the variance.
    ++count_;
    const glm::dvec3 change = value - mean_;
    mean_ += change / static_cast<double>(count_);
    squares_ += change * (value - mean_);
  }
  [[nodiscard]] const glm::dvec3& value() const { return mean_; }
  [[nodiscard]] glm::dvec3 variance() const {
    const auto n = static_cast<double>(count_);
    return squares_ / (n * (n - 1.0));
  }

 private:
  std::size_t count_ = 0;
  glm::dvec3 mean_{0.0};
  glm::dvec3 squares_{0.0};
};

struct Sample {
  glm::dvec3 attenuated{0.0};
  glm::dvec3 scattered{0.0};
};

class Sampler {
 public:
  Sampler(const Scene& scene, const RayCaster& ray_caster, const SurfacePoint& point,
          const SurfaceSampling& sampling)
      : scene_(scene), ray_caster_(ray_caster), point_(point), far_(sampling.far) {
    for (std::size_t i = 0; i < scene.medium.size(); ++i) {
      gaussians_.add(scene.medium.gaussian(i));
    }
  }

  // Light of a point light that comes straight, without sampling.
  [[nodiscard]] glm::dvec3 unscattered(const PointLight& light) const {
    const glm::dvec3 q = light.position - point_.position;
    const double distance = glm::length(q);
    if (!(distance > 0.0) || ray_caster_.occluded(point_.shadow_origin, light.position)) {
      return glm::dvec3(0.0);
    }
    const glm::dvec3 wi = q / distance;
    return light.falloff.at(-wi) * reflected(wi) * light.intensity /
           std::max(distance * distance, light.radius * light.radius) *
           transmittance(depth_to(light, point_.position, wi, distance));
  }

  Sample of_light(const PointLight& light, Uniform& uniform) const {
    // Scattered light is bright around the light like 1 / angle: half of the directions are as
    // dense there, the other half follow the cosine.
    const glm::dvec3 q = light.position - point_.position;
    const glm::dvec3 to_light = glm::normalize(q);
    const double phi = 2.0 * pi * uniform();
    const glm::dvec3 wi = uniform() < 0.5 ? around(to_light, std::cos(pi * uniform()), phi)
                                          : around(point_.normal, std::sqrt(uniform()), phi);
    const double cosine = glm::dot(wi, point_.normal);
    if (!(cosine > 0.0)) return {};
    const PointLightRay<double> path(light.position, point_.position, wi, 0.0);
    const double sine = path.h / glm::length(q);
    const double pdf = 0.5 * cosine / pi + 0.5 / (2.0 * pi * pi * sine);

    // Where on the ray: uniform in the angle at the light.
    const Ray along = ray(point_.position, wi);
    const EquiAngular<double> angular(path, end_of(wi));
    const double t = angular.t(uniform() * angular.span);
    const glm::dvec3 x = along.at(t);
    if (ray_caster_.occluded(x, light.position)) return {};
    const double r = path.path_length(t);
    const glm::dvec3 from_light = r > 0.0 ? (x - light.position) / r : -wi;
    const double depth = along.depth(t) + depth_to(light, x, -from_light, r);
    const double weight = light.falloff.at(from_light) * along.density(t) *
                          phase(-glm::dot(from_light, wi)) * angular.span / (path.h * pdf);
    return {{}, weight * reflected(wi) * transmittance(depth) * light.intensity};
  }

  Sample of_environment(const Environment& environment, Uniform& uniform) const {
    const double phi = 2.0 * pi * uniform();
    const glm::dvec3 wi = around(point_.normal, std::sqrt(uniform()), phi);
    const double cosine = glm::dot(wi, point_.normal);
    if (!(cosine > 0.0)) return {};
    const glm::dvec3 weight = reflected(wi) * (pi / cosine);
    const Ray along = ray(point_.position, wi);
    const SurfaceHit hit = ray_caster_.first_hit(point_.shadow_origin, wi);
    const double end = std::min(hit.distance, far_);
    const double depth = along.depth(end);
    Sample sample;
    if (!hit) {
      sample.attenuated = weight * transmittance(depth) * environment_radiance(environment, wi);
    }
    // Where on the ray: by the light that single scattering leaves, exp(-T) b.
    const double opacity = -std::expm1(-depth);
    if (!(opacity > 0.0)) return sample;
    const double level = -std::log1p(-uniform() * opacity);
    const double t = along.parameter_at(level, end);
    const glm::dvec3 x = along.at(t);
    const double turn = 2.0 * pi * uniform();
    const glm::dvec3 w = around({0, 0, 1}, 2.0 * uniform() - 1.0, turn);
    if (ray_caster_.first_hit(x, w)) return sample;
    const double total = level + ray(x, w).depth(distance_out(x, w));
    sample.scattered = weight * opacity * std::exp(level) * (4.0 * pi * phase(glm::dot(w, wi))) *
                       transmittance(total) * environment_radiance(environment, w);
    return sample;
  }

 private:
  [[nodiscard]] Ray ray(const glm::dvec3& origin, const glm::dvec3& w) const {
    return {gaussians_.all(), scene_.medium.homogeneous_density(), origin, w};
  }
  // From x to a light in the direction w at a distance. Of a far light, fog ends where the medium
  // does.
  [[nodiscard]] double depth_to(const PointLight& light, const glm::dvec3& x, const glm::dvec3& w,
                                double distance) const {
    const double depth = ray(x, w).depth(distance);
    if (!light.is_far) return depth;
    const double fog = scene_.medium.homogeneous_density();
    return depth - fog * (distance - std::min(distance, distance_out(x, w)));
  }
  // f cos(theta_i).
  [[nodiscard]] glm::dvec3 reflected(const glm::dvec3& wi) const {
    return brdf(point_, wi) * std::max(0.0, glm::dot(wi, point_.normal));
  }
  // Of a path with that depth by scattering alone.
  [[nodiscard]] glm::dvec3 transmittance(double depth) const {
    return glm::exp(-depth / scene_.optics.albedo);
  }
  [[nodiscard]] double phase(double cosine) const {
    return henyey_greenstein(cosine, scene_.optics.anisotropy) / (4.0 * pi);
  }
  [[nodiscard]] double end_of(const glm::dvec3& wi) const {
    return std::min(ray_caster_.first_hit(point_.shadow_origin, wi).distance, far_);
  }
  // From x along w to the end of the medium.
  [[nodiscard]] double distance_out(const glm::dvec3& x, const glm::dvec3& w) const {
    if (!std::isfinite(far_)) return far_;
    const glm::dvec3 q = x - point_.position;
    const double along = glm::dot(q, w);
    const double square = along * along + far_ * far_ - glm::dot(q, q);
    return std::max(0.0, std::sqrt(std::max(0.0, square)) - along);
  }

  const Scene& scene_;
  const RayCaster& ray_caster_;
  const SurfacePoint& point_;
  double far_;
  GaussianTerms<double> gaussians_;
};

}  // namespace

ReflectedLight reflected_light(const Scene& scene, const RayCaster& ray_caster,
                               const SurfacePoint& point, const SurfaceSampling& sampling) {
  assert(sampling.samples >= 2);
  const Sampler sampler(scene, ray_caster, point, sampling);
  Uniform uniform(sampling.seed);
  ReflectedLight result;
  glm::dvec3 variance(0.0);
  const auto average = [&](const auto& draw) {
    Mean attenuated;
    Mean scattered;
    Mean sum;
    for (std::size_t i = 0; i < sampling.samples; ++i) {
      const Sample sample = draw();
      attenuated.add(sample.attenuated);
      scattered.add(sample.scattered);
      sum.add(sample.attenuated + sample.scattered);
    }
    result.attenuated += attenuated.value();
    result.scattered += scattered.value();
    variance += sum.variance();
  };
  for (const PointLight& light : point_lights(scene, LightPoints::many)) {
    result.attenuated += sampler.unscattered(light);
    average([&] { return sampler.of_light(light, uniform); });
  }
  if (scene.environment) {
    average([&] { return sampler.of_environment(*scene.environment, uniform); });
  }
  result.error = glm::sqrt(variance);
  return result;
}

}  // namespace brume
