#include "render/lights/emission_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <iterator>
#include <numbers>

#include "core/math/infinity.h"
#include "render/geometry/rounding.h"

namespace brume {
namespace {

// A Gaussian that emits.
struct EmittingGaussian {
  std::size_t index;
  glm::dvec3 intensity;  // unattenuated [W/sr]
  double weight;         // the same of all channels
};

// Point k of a set that is normally distributed with variance 1 along each axis: an additive
// recurrence (Roberts 2018), transformed as by Box and Muller (1958).
glm::dvec3 normal_point(int k) {
  constexpr double ratio = 1.16730397826141868;  // of the recurrence in 4 dimensions: x^5 = x + 1
  const glm::dvec4 steps =
      1.0 / glm::dvec4(ratio, std::pow(ratio, 2.0), std::pow(ratio, 3.0), std::pow(ratio, 4.0));
  const glm::dvec4 u = glm::fract(0.5 + (k + 1.0) * steps);
  const glm::dvec2 radii = glm::sqrt(-2.0 * glm::log(glm::max(glm::dvec2(u), 1e-12)));
  const glm::dvec2 angles = 2.0 * std::numbers::pi * glm::dvec2(u.z, u.w);
  return {radii.x * std::cos(angles.x), radii.x * std::sin(angles.x), radii.y * std::cos(angles.y)};
}

SurfaceHit hit_through_panes(const RayCaster& surfaces, const glm::dvec3& origin,
                             const glm::dvec3& direction) {
  SurfaceHit hit;
  surfaces.opaque_hits(origin, std::span(&direction, 1), std::span(&hit, 1), 0.0);
  return hit;
}

// The mean over parts and the axes' directions of how far they see, at most `far` [u].
double mean_sight(std::span<const glm::dvec3> parts, const RayCaster& surfaces, double far) {
  double sum = 0.0;
  for (const glm::dvec3& part : parts) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        glm::dvec3 direction(0.0);
        direction[axis] = side;
        const SurfaceHit hit = hit_through_panes(surfaces, part, direction);
        sum += hit ? std::min(hit.distance, far) : far;
      }
    }
  }
  return sum / (6.0 * static_cast<double>(parts.size()));
}

// `count` points that emit alike, spread as Gaussians emit [u].
std::vector<glm::dvec3> emission_parts(std::span<const EmittingGaussian> emitters,
                                       const MediumIndex& medium, int count) {
  double all = 0.0;
  for (const EmittingGaussian& emitter : emitters) all += emitter.weight;
  std::vector<glm::dvec3> parts;
  auto emitter = emitters.begin();
  double sum = emitter->weight;  // up to the emitter
  for (int k = 0; k < count; ++k) {
    while (sum < (k + 0.5) / count * all && std::next(emitter) != emitters.end()) {
      sum += (++emitter)->weight;
    }
    const GaussianTerm<double>& g = medium.gaussians()[emitter->index];
    glm::dvec3 offset = normal_point(k) / (std::numbers::sqrt2 * g.a);
    if (g.ellipsoid) offset = g.ellipsoid->axes * (g.ellipsoid->stretch * offset);
    parts.push_back(g.b + offset);
  }
  return parts;
}

// Whether the number of surfaces between two points is even: both are in one solid, or neither is.
// Panes do not count.
bool are_on_one_side(const glm::dvec3& a, const glm::dvec3& b, const RayCaster& surfaces) {
  constexpr int max_crossings = 64;
  const double length = glm::distance(a, b);
  if (!(length > 0.0)) return true;
  const glm::dvec3 direction = (b - a) / length;
  int count = 0;
  for (double t = 0.0; count < max_crossings; ++count) {
    const glm::dvec3 origin = a + t * direction;
    const SurfaceHit hit = hit_through_panes(surfaces, origin, direction);
    if (!hit || t + hit.distance > length) break;
    t += hit.distance + 2.0 * rounding_at(origin - surfaces.center());
  }
  return count % 2 == 0;
}

// The parts that lie in the open, where others are in solids or below the ground: those on the side
// of more of them, unless these see less than half as far. Never empty.
std::vector<glm::dvec3> parts_in_the_open(const std::vector<glm::dvec3>& parts,
                                          const RayCaster& surfaces) {
  std::array<std::vector<glm::dvec3>, 2> sides;
  for (const glm::dvec3& part : parts) {
    sides[are_on_one_side(parts.front(), part, surfaces) ? 0 : 1].push_back(part);
  }
  std::ranges::sort(sides, std::ranges::greater(), &std::vector<glm::dvec3>::size);
  const auto& [more, fewer] = sides;
  if (fewer.empty()) return more;
  const double far = glm::length(surfaces.bounds().high - surfaces.bounds().low);
  return mean_sight(more, surfaces, far) < 0.5 * mean_sight(fewer, surfaces, far) ? fewer : more;
}

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
