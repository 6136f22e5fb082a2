#include "render/lighting/incident_point_light.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/math/special_functions.h"
#include "core/math/spherical_harmonics.h"
#include "render/lighting/slice_kernels.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {
namespace {

// Nodes within so many spacings of the light along each axis get means.
constexpr double near_spacings = 3.0;

// Points along each axis of a mean, over two spacings: of light, and of a falloff alone.
constexpr int mean_points = 8;
constexpr int falloff_points = 6;

struct WeightedPoint {
  glm::dvec3 offset;  // from the node, in spacings
  double weight;
};

std::vector<WeightedPoint> mean_rule(int count) {
  std::vector<WeightedPoint> rule;
  const auto coordinate = [count](int i) { return 2.0 * (i + 0.5) / count - 1.0; };
  double sum = 0.0;
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x) {
        const glm::dvec3 offset(coordinate(x), coordinate(y), coordinate(z));
        const glm::dvec3 hat = 1.0 - glm::abs(offset);
        rule.push_back({offset, hat.x * hat.y * hat.z});
        sum += rule.back().weight;
      }
    }
  }
  for (WeightedPoint& point : rule) point.weight /= sum;
  return rule;
}

// The mean of 1 / r^2 from points that are normally distributed, r^2 = r2 from their center.
double mean_inverse_square(double r2, double deviation) {
  const double variance = deviation * deviation;
  const double ratio = variance / r2;
  if (ratio < 1.0 / 36.0) return (1.0 + ratio * (1.0 + 3.0 * ratio)) / r2;
  const double r = std::sqrt(r2);
  return std::numbers::sqrt2 / (deviation * r) * dawson(r / (std::numbers::sqrt2 * deviation));
}

// Light at points per unit of intensity.
class PointsAroundLight {
 public:
  explicit PointsAroundLight(const NodePointLight& light) : light_(light) {}

  // Calls add(k, direction to the light, exp(-T) / r^2) for the points that see the light, times
  // the mean of the falloff over `spacing` around each.
  template <class Add>
  void each(std::span<const glm::dvec3> points, double spacing, Add add) {
    self_.assign(points.size(), -1);
    paths_.assign(light_.source.position, points, self_);
    depths_.assign(paths_.padded_size(), 0.0f);
    if (light_.table) lookup_depths(*light_.table, paths_, depths_.data());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec3 q = light_.source.position - points[k];
      const double r2 = glm::dot(q, q);
      if (!(r2 > 0.0)) continue;
      const double r = std::sqrt(r2);
      const double depth = light_.extinction * static_cast<double>(depths_[k]) +
                           light_.fog * light_.source.fog_length(points[k]);
      const double falloff = mean_falloff(points[k], r, spacing);
      if (!(falloff > 0.0)) continue;
      if (light_.surfaces && light_.surfaces->occluded(points[k], light_.source.position)) continue;
      add(k, q / r, falloff * std::exp(-depth) * mean_inverse_square(r2, light_.deviation));
    }
  }

 private:
  // Over the cells around a point at distance r, weighted as add_point_light() does, of falloff
  // over r^2, times r^2: so beams that are narrower than cells are not lost.
  [[nodiscard]] double mean_falloff(const glm::dvec3& point, double r, double spacing) const {
    static const std::vector<WeightedPoint> rule = mean_rule(falloff_points);
    const LightFalloff& falloff = light_.source.falloff;
    if (falloff.is_isotropic()) return 1.0;
    const glm::dvec3 q = point - light_.source.position;
    const double cosine = glm::dot(q, falloff.axis()) / r;
    // How much it may change over the cells; farther from the edge it is 0 or 1.
    const double reach = spacing > 0.0 ? std::min(std::sqrt(3.0) * spacing / r, 2.0) : 0.0;
    if (falloff.has_cone()) {
      if (falloff.versine(q / r) - reach > falloff.dark_versine()) return 0.0;
      const bool is_full = falloff.versine(q / r) + reach < falloff.full_versine();
      if (!falloff.profile() && is_full) return 1.0;
    } else if (std::abs(cosine) > reach) {
      return falloff.at(q / r);  // it is smooth there
    }
    if (!(spacing > 0.0)) return falloff.at(q / r);
    double sum = 0.0;
    for (const WeightedPoint& p : rule) {
      const glm::dvec3 there = q + spacing * p.offset;
      const double there2 = glm::dot(there, there);
      if (!(there2 > 0.0)) continue;
      sum += p.weight * falloff.at(there / std::sqrt(there2)) * r * r / there2;
    }
    return sum;
  }

  const NodePointLight& light_;
  std::vector<std::int32_t> self_;
  PathBatch paths_;
  std::vector<float> depths_;
};

}  // namespace

void add_point_light(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes,
                     const GridOcclusion* occlusion, NodeLight& incident, const Job& job) {
  static const std::vector<WeightedPoint> rule = mean_rule(mean_points);
  const double spacing = static_cast<double>(nodes.spacing);
  const auto width = static_cast<std::size_t>(nodes.count.x);
  const auto height = static_cast<std::size_t>(nodes.count.y);
  job.parallel_for(height * static_cast<std::size_t>(nodes.count.z), [&](std::size_t row) {
    PointsAroundLight around(light);
    const auto add = [&](std::size_t node, double weight, const glm::dvec3& w) {
      const ShVector<double> basis = sh_basis(incident.bands, w);
      for (std::size_t c = 0; c < incident.channels; ++c) {
        const double intensity = weight * static_cast<double>(light.intensity[c]);
        for (std::size_t f = 0; f < basis.size(); ++f) {
          incident.row(c, f)[node] += static_cast<float>(intensity * basis[f]);
        }
      }
    };
    const glm::dvec3 begin = first + spacing * glm::dvec3(0.0, static_cast<double>(row % height),
                                                          static_cast<double>(row / height));
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> at;
    for (std::size_t x = 0; x < width; ++x) {
      const glm::dvec3 point = begin + glm::dvec3(spacing * static_cast<double>(x), 0.0, 0.0);
      const glm::dvec3 distance = glm::abs(point - light.source.position) / spacing;
      if (std::max({distance.x, distance.y, distance.z}) > near_spacings) {
        points.push_back(point);
        at.push_back(row * width + x);
        continue;
      }
      const std::size_t node = row * width + x;
      const bool is_beside_surfaces =
          occlusion && !occlusion->blocked().empty() && occlusion->blocked()[node] != 0;
      std::vector<glm::dvec3> around_node;
      std::vector<double> weights;
      double sum = 0.0;
      for (const WeightedPoint& p : rule) {
        const glm::dvec3 q = point + spacing * p.offset;
        if (is_beside_surfaces && light.surfaces->occluded(point, q)) continue;
        around_node.push_back(q);
        weights.push_back(p.weight);
        sum += p.weight;
      }
      around.each(around_node, 0.0, [&](std::size_t k, const glm::dvec3& w, double arriving) {
        add(node, weights[k] / sum * arriving, w);
      });
    }
    around.each(points, spacing, [&](std::size_t k, const glm::dvec3& w, double arriving) {
      add(at[k], arriving, w);
    });
  });
}

void add_reflected_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                               const glm::dvec3& first, const GridNodes& nodes,
                               std::span<float> reflected, std::size_t channels, const Job& job) {
  constexpr std::size_t together = 64;  // nodes
  const double spacing = static_cast<double>(nodes.spacing);
  const double max_arriving = 4.0 / (spacing * spacing);
  const std::size_t links = surfaces.surfels().size();
  const std::size_t count = surfaces.nodes().size();
  job.parallel_for((count + together - 1) / together, [&](std::size_t group) {
    PointsAroundLight around(light);
    std::vector<glm::dvec3> points;
    const std::size_t end = std::min((group + 1) * together, count);
    const std::size_t first_link = surfaces.nodes()[group * together].first;
    for (std::size_t i = group * together; i < end; ++i) {
      const glm::dvec3 node =
          first + spacing * glm::dvec3(node_coordinates(nodes, surfaces.grid_nodes()[i]));
      for (const GridOcclusion::Surfel& surfel : surfaces.surfels_of(i)) {
        // Off the surface, which does not shadow itself.
        points.push_back(node + glm::dvec3(surfel.offset) +
                         1e-3 * spacing * glm::dvec3(surfel.normal));
      }
    }
    around.each(points, 0.5 * spacing, [&](std::size_t k, const glm::dvec3& w, double arriving) {
      const GridOcclusion::Surfel& surfel = surfaces.surfels()[first_link + k];
      const double cosine = glm::dot(glm::dvec3(surfel.normal), w);
      if (!(cosine > 0.0)) return;
      const double radiance = cosine * std::min(arriving, max_arriving) * std::numbers::inv_pi;
      for (std::size_t c = 0; c < channels; ++c) {
        reflected[c * links + first_link + k] += static_cast<float>(radiance) * light.intensity[c] *
                                                 surfel.reflectance[static_cast<int>(c)];
      }
    });
  });
}

}  // namespace brume
