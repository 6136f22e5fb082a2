#include "render/lights/emission_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/infinity.h"
#include "core/math/special_functions.h"
#include "core/math/sphere_rule.h"

namespace brume {
namespace {

// Of Gaussians that are small in the scene, and as many of others.
constexpr std::size_t max_lights = 16;
// Of the diagonal of what they light: small Gaussians have radii below, and lights less than this
// wide are not split.
constexpr double small_share = 1.0 / 32.0;
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
    const glm::dvec3 radii = (g.ellipsoid ? g.ellipsoid->reach() : glm::dvec3(1.0)) / g.a;
    squares += emitter.weight * (q * q + 0.5 * radii * radii);
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

// The Gaussians of a medium that are in a cluster, or that are not.
MediumIndex part_of(const MediumIndex& medium, const Cluster& cluster, bool is_in) {
  std::vector<bool> in_cluster(medium.size());
  for (const EmittingGaussian& emitter : cluster.emitters) in_cluster[emitter.index] = true;
  Medium part;
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    if (in_cluster[i] == is_in) part.append(gaussian_of(g));
  }
  return {part, medium.culling()};
}

// Of what a cluster emits, in the mean over directions, what it does not absorb itself.
double escaping_share(const Cluster& cluster, const MediumIndex& medium) {
  constexpr std::size_t max_samples = 32;
  const std::vector<SphereNode> directions = sphere_rule(3);
  const MediumIndex own = part_of(medium, cluster, true);
  const std::size_t step = (cluster.emitters.size() + max_samples - 1) / max_samples;
  double escaping = 0.0;
  double weight = 0.0;
  for (std::size_t k = 0; k < cluster.emitters.size(); k += step) {
    const EmittingGaussian& emitter = cluster.emitters[k];
    weight += emitter.weight;
    // Of optical depth T through its center, it lets out Ein(T) / T. What others then let through
    // is found from six points: Gauss' rule of two of a normal distribution, along each axis.
    const GaussianTerm<double>& g = medium.gaussians()[emitter.index];
    const double depth = central_depth(g);
    const double out = depth > 0.0 ? entire_exponential_integral(depth) / depth : 1.0;
    const double offset = std::sqrt(1.5) / g.a;
    const glm::dmat3 axes = g.ellipsoid ? g.ellipsoid->axes : glm::dmat3(1.0);
    const glm::dvec3 stretch = g.ellipsoid ? g.ellipsoid->stretch : glm::dvec3(1.0);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-offset, offset}) {
        const glm::dvec3 x = g.b + side * stretch[axis] * axes[axis];
        for (const SphereNode& node : directions) {
          const double others = own.depth({x, node.direction, infinity}) -
                                optical_depth(g, line_profile(g, x, node.direction), infinity);
          escaping += emitter.weight * out * node.weight * std::exp(-std::max(others, 0.0));
        }
      }
    }
  }
  return escaping / (weight * 6.0 * 4.0 * std::numbers::pi);
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
  const bool has_none = revision_ != 0 && optics_.empty() && medium.optics().empty();
  if (revision_ != 0 && (has_none || (medium_ == medium.revision() && fog_ == medium.fog())) &&
      albedo_ == albedo && surfaces_ == surfaces) {
    return;
  }
  medium_ = medium.revision();
  fog_ = medium.fog();
  albedo_ = albedo;
  surfaces_ = surfaces;
  revision_ = new_revision();
  lights_.clear();
  optics_.assign(medium.optics().begin(), medium.optics().end());
  const double extent = optics_.empty() ? 0.0 : diagonal(medium, surfaces);
  std::array<std::vector<EmittingGaussian>, 2> small_and_large;
  for (std::size_t i = 0; i < optics_.size(); ++i) {
    const GaussianTerm<double>& g = medium.gaussians()[i];
    const glm::dvec3 intensity = albedo * g.c * volume_of(g) * optics_[i].emission;
    const double weight = intensity.x + intensity.y + intensity.z;
    const bool is_large = 1.0 / g.a > small_share * extent;
    if (weight > 0.0 && weight < infinity) {
      small_and_large[is_large ? 1 : 0].push_back({i, intensity, weight});
    }
  }
  std::vector<Cluster> clusters;
  for (std::vector<EmittingGaussian>& emitters : small_and_large) {
    if (emitters.empty()) continue;
    for (Cluster& cluster : clusters_of(std::move(emitters), medium, min_share * extent)) {
      Light& light = lights_.emplace_back();
      light.source.position = cluster.center;
      light.source.fog = medium.fog();
      const double share = escaping_share(cluster, medium);
      for (const EmittingGaussian& emitter : cluster.emitters) {
        light.source.intensity += share * emitter.intensity;
      }
      light.width = width(cluster);
      light.source.h_min = 0.5 * light.width;
      for (const EmittingGaussian& emitter : cluster.emitters) {
        light.gaussians.push_back(emitter.index);
      }
      clusters.push_back(std::move(cluster));
    }
  }
  job.parallel_for(lights_.size(), [&](std::size_t i) {
    lights_[i].table = std::make_unique<const OpticalDepthTable>(
        part_of(medium, clusters[i], false), lights_[i].source.position, table_size);
  });
  if (job.stop.stop_requested()) clear();
}

}  // namespace brume
