#include "render/lights/emission_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/math/infinity.h"
#include "render/lights/emission_parts.h"

namespace brume {
namespace {

// So many stand for Gaussians that are small in the scene, and as many for others.
constexpr std::size_t max_lights = 16;
// Of the diagonal of what they light: small Gaussians have radii below, and lights less than this
// wide are not split.
constexpr double small_share = 1.0 / 32.0;
constexpr double min_share = 1.0 / 64.0;
constexpr OpticalDepthTableSize table_size{32, 32};
// Points that stand for a light where it is attenuated by itself and by what is beside it.
constexpr int part_count = 64;
// Tables take as many of them as this allows, times the Gaussians of the medium, and no fewer than
// some: else those of 20,000 flames would take seconds.
constexpr std::size_t max_depths = std::size_t{1} << 18;
constexpr std::size_t min_parts = 8;

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

// The places that a cluster shines from.
struct Shining {
  glm::dvec3 position{0.0};
  std::vector<glm::dvec3> parts{};  // from the position, all alike [u]
  double share = 1.0;               // of what the cluster emits that is in the open
};

// A cluster shines from its center, or from the part next to it where that is in a solid.
Shining shining_of(const Cluster& cluster, const MediumIndex& medium, const RayCaster* surfaces) {
  Shining shining{cluster.center, emission_parts(cluster.emitters, medium, part_count)};
  if (surfaces) {
    shining.parts = parts_in_the_open(shining.parts, *surfaces);
    shining.share = static_cast<double>(shining.parts.size()) / part_count;
    if (!are_on_one_side(shining.parts.front(), cluster.center, *surfaces)) {
      const auto distance = [&](const glm::dvec3& part) {
        return glm::distance(part, cluster.center);
      };
      shining.position = *std::ranges::min_element(shining.parts, {}, distance);
    }
  }
  for (glm::dvec3& part : shining.parts) part -= shining.position;
  return shining;
}

// Evenly chosen of them.
std::vector<glm::dvec3> parts_for_table(const std::vector<glm::dvec3>& parts,
                                        const MediumIndex& medium) {
  const std::size_t wanted = std::max(max_depths / medium.gaussians().size(), min_parts);
  if (parts.size() <= wanted) return parts;
  std::vector<glm::dvec3> chosen;
  for (std::size_t k = 0; k < wanted; ++k) chosen.push_back(parts[k * parts.size() / wanted]);
  return chosen;
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

void EmissionLights::update(const MediumIndex& medium, double albedo, const RayCaster* surfaces,
                            const Job& job) {
  const Revision surfaces_revision = surfaces ? surfaces->revision() : 0;
  const bool has_none = revision_ != 0 && optics_.empty() && medium.optics().empty();
  if (revision_ != 0 && (has_none || (medium_ == medium.revision() && fog_ == medium.fog())) &&
      albedo_ == albedo && surfaces_ == surfaces_revision) {
    return;
  }
  medium_ = medium.revision();
  fog_ = medium.fog();
  albedo_ = albedo;
  surfaces_ = surfaces_revision;
  revision_ = new_revision();
  lights_.clear();
  optics_.assign(medium.optics().begin(), medium.optics().end());
  const double extent =
      optics_.empty() ? 0.0 : diagonal(medium, surfaces ? surfaces->bounds() : Box());
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
  std::vector<std::vector<glm::dvec3>> parts;  // of lights
  for (std::vector<EmittingGaussian>& emitters : small_and_large) {
    if (emitters.empty()) continue;
    for (const Cluster& cluster : clusters_of(std::move(emitters), medium, min_share * extent)) {
      Light& light = lights_.emplace_back();
      const Shining shining = shining_of(cluster, medium, surfaces);
      parts.push_back(parts_for_table(shining.parts, medium));
      light.source.position = shining.position;
      light.source.fog = medium.fog();
      for (const EmittingGaussian& emitter : cluster.emitters) {
        light.source.intensity += shining.share * emitter.intensity;
      }
      light.width = width(cluster);
      light.source.h_min = 0.5 * light.width;
      for (const EmittingGaussian& emitter : cluster.emitters) {
        light.gaussians.push_back(emitter.index);
      }
    }
  }
  job.parallel_for(lights_.size(), [&](std::size_t i) {
    lights_[i].table = std::make_unique<const OpticalDepthTable>(medium, lights_[i].source.position,
                                                                 parts[i], table_size);
  });
  if (job.stop.stop_requested()) clear();
}

}  // namespace brume
