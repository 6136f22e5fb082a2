#include "render/lighting/emission_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "core/math/infinity.h"
#include "core/math/sphere_rule.h"

namespace brume {
namespace {

constexpr std::size_t max_lights = 16;
// Of the diagonal of what they light: a light is no wider, and a Gaussian of a wider one is not
// told apart from others.
constexpr double max_share = 1.0 / 16.0;
constexpr double min_share = 1.0 / 64.0;
constexpr OpticalDepthTableSize table_size{32, 32};

// A Gaussian that emits.
struct EmittingGaussian {
  std::size_t index;
  glm::dvec3 intensity;  // unattenuated [W/sr]
  double weight;         // the same of all channels
};

struct Cluster {
  std::vector<EmittingGaussian> emitters;
  glm::dvec3 center{0.0};
  glm::dvec3 deviation{0.0};  // standard deviations of what emits, along the axes [u]
  double weight = 0.0;
};

Cluster cluster_of(std::vector<EmittingGaussian> emitters, const MediumIndex& medium) {
  Cluster cluster{std::move(emitters)};
  glm::dvec3 squares(0.0);
  for (const EmittingGaussian& emitter : cluster.emitters) {
    const glm::dvec3& b = medium.gaussians()[emitter.index].b;
    cluster.weight += emitter.weight;
    cluster.center += emitter.weight * b;
  }
  cluster.center /= cluster.weight;
  for (const EmittingGaussian& emitter : cluster.emitters) {
    const GaussianTerm<double>& g = medium.gaussians()[emitter.index];
    const glm::dvec3 q = g.b - cluster.center;
    squares += emitter.weight * (q * q + 0.5 / (g.a * g.a));
  }
  cluster.deviation = glm::sqrt(squares / cluster.weight);
  return cluster;
}

double width(const Cluster& cluster) {
  return 2.0 * std::max({cluster.deviation.x, cluster.deviation.y, cluster.deviation.z});
}

// Splits the widest by weight, across its longest axis, until all are narrow or there are many.
std::vector<Cluster> clusters_of(std::vector<EmittingGaussian> emitters, const MediumIndex& medium,
                                 double min_width) {
  std::vector<Cluster> clusters;
  clusters.push_back(cluster_of(std::move(emitters), medium));
  while (clusters.size() < max_lights) {
    const auto moment = [&](const Cluster& cluster) {
      const bool splits = cluster.emitters.size() > 1 && width(cluster) > min_width;
      return splits ? cluster.weight * width(cluster) * width(cluster) : 0.0;
    };
    const auto widest = std::ranges::max_element(clusters, {}, moment);
    if (!(moment(*widest) > 0.0)) break;
    const glm::dvec3& d = widest->deviation;
    const int axis = d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
    const double middle = widest->center[axis];
    std::vector<EmittingGaussian> low = std::move(widest->emitters);
    const auto high = std::ranges::partition(low, [&](const EmittingGaussian& emitter) {
      return medium.gaussians()[emitter.index].b[axis] < middle;
    });
    std::vector<EmittingGaussian> rest(high.begin(), high.end());
    low.erase(high.begin(), high.end());
    if (low.empty() || rest.empty()) {  // all in one place
      *widest = cluster_of(low.empty() ? std::move(rest) : std::move(low), medium);
      break;
    }
    *widest = cluster_of(std::move(low), medium);
    clusters.push_back(cluster_of(std::move(rest), medium));
  }
  return clusters;
}

// The intensities of a cluster's emitters, as they leave it, over the share that passes from its
// center; nullopt if hardly anything does.
std::optional<glm::dvec3> escaping_intensity(const Cluster& cluster, const MediumIndex& medium) {
  constexpr double min_passing = 1e-2;
  constexpr std::size_t max_samples = 32;
  const std::vector<SphereNode> directions = sphere_rule(3);
  const double reach = 2.0 * width(cluster);
  std::vector<GaussianTerm<double>> near;
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    if (glm::length(g.b - cluster.center) < reach + 3.0 / g.a) near.push_back(g);
  }
  const auto passing = [&](const glm::dvec3& x) {
    double sum = 0.0;
    for (const SphereNode& node : directions) {
      double depth = 0.0;
      for (const GaussianTerm<double>& g : near) {
        depth += optical_depth(g, line_profile(g, x, node.direction), infinity);
      }
      sum += node.weight * std::exp(-depth);
    }
    return sum / (4.0 * std::numbers::pi);
  };
  const double from_center = passing(cluster.center);
  if (!(from_center > min_passing)) return std::nullopt;

  const std::size_t step = (cluster.emitters.size() + max_samples - 1) / max_samples;
  double passed = 0.0;
  double weight = 0.0;
  glm::dvec3 intensity(0.0);
  for (std::size_t i = 0; i < cluster.emitters.size(); ++i) {
    const EmittingGaussian& emitter = cluster.emitters[i];
    intensity += emitter.intensity;
    if (i % step != 0) continue;
    // Gauss' rule of two points a direction for a normal distribution in space.
    const GaussianTerm<double>& g = medium.gaussians()[emitter.index];
    const double offset = std::sqrt(1.5) / g.a;
    weight += emitter.weight;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-offset, offset}) {
        glm::dvec3 x = g.b;
        x[axis] += side;
        passed += emitter.weight / 6.0 * passing(x);
      }
    }
  }
  return passed / (weight * from_center) * intensity;
}

double diagonal(const MediumIndex& medium, const Box& surfaces) {
  glm::dvec3 low(infinity);
  glm::dvec3 high(-infinity);
  for (const GaussianTerm<double>& g : medium.gaussians()) {
    low = glm::min(low, g.b - 1.0 / g.a);
    high = glm::max(high, g.b + 1.0 / g.a);
  }
  if (surfaces.low.x < surfaces.high.x || surfaces.low.y < surfaces.high.y ||
      surfaces.low.z < surfaces.high.z) {
    low = glm::min(low, surfaces.low);
    high = glm::max(high, surfaces.high);
  }
  return glm::length(high - low);
}

}  // namespace

void EmissionLights::update(const MediumIndex& medium, double albedo, const Box& surfaces,
                            const Job& job) {
  if (revision_ != 0 && medium_ == medium.revision() && albedo_ == albedo && surfaces_ == surfaces)
    return;
  medium_ = medium.revision();
  albedo_ = albedo;
  surfaces_ = surfaces;
  revision_ = new_revision();
  lights_.clear();
  others_.assign(medium.optics().begin(), medium.optics().end());
  const double extent = others_.empty() ? 0.0 : diagonal(medium, surfaces);
  std::vector<EmittingGaussian> emitters;
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const double volume = std::pow(std::numbers::pi, 1.5) / (g.a * g.a * g.a);
    const glm::dvec3 intensity = albedo * g.c * volume * others_[i].emission;
    const double weight = intensity.x + intensity.y + intensity.z;
    const bool is_small = 1.0 / g.a < 0.5 * max_share * extent;
    if (is_small && weight > 0.0 && weight < infinity) emitters.push_back({i, intensity, weight});
  }
  if (emitters.empty()) return;
  for (const Cluster& cluster : clusters_of(std::move(emitters), medium, min_share * extent)) {
    if (width(cluster) > max_share * extent) continue;
    const std::optional<glm::dvec3> intensity = escaping_intensity(cluster, medium);
    if (!intensity) continue;
    Light& light = lights_.emplace_back();
    light.source.position = cluster.center;
    light.source.intensity = *intensity;
    for (const EmittingGaussian& emitter : cluster.emitters) {
      others_[emitter.index].emission = glm::dvec3(0.0);
    }
  }
  job.parallel_for(lights_.size(), [&](std::size_t i) {
    lights_[i].table =
        std::make_unique<const OpticalDepthTable>(medium, lights_[i].source.position, table_size);
  });
  if (job.stop.stop_requested()) clear();
}

}  // namespace brume
