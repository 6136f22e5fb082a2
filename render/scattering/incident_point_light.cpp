#include "render/scattering/incident_point_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "core/math/basis.h"
#include "core/math/spherical_harmonics.h"
#include "render/scattering/light_rays.h"

namespace brume {
namespace {

// Points along each axis of a mean, over two spacings; fewer for a cosine, which has a kink but no
// edge.
constexpr int mean_points = 6;
constexpr int cosine_points = 3;

struct WeightedPoint {
  glm::dvec3 offset;  // from the node, in spacings
  double weight;
};

std::vector<WeightedPoint> make_mean_rule(int count) {
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

// The cells around a node, as a trilinear interpolation weights them.
std::span<const WeightedPoint> mean_rule() {
  static const std::vector<WeightedPoint> rule = make_mean_rule(mean_points);
  return rule;
}
std::span<const WeightedPoint> cosine_rule() {
  static const std::vector<WeightedPoint> rule = make_mean_rule(cosine_points);
  return rule;
}

// Light at points per unit of intensity.
class PointsAroundLight {
 public:
  explicit PointsAroundLight(const NodePointLight& light) : light_(light), transmittance_(light) {}

  // Calls add(k, vector to the light, exp(-T)) for the points that see the light, times the mean of
  // the falloff over `spacing` around each: in space, or in the planes of `normals`.
  template <class Add>
  void each(std::span<const glm::dvec3> points, std::span<const glm::dvec3> normals, double spacing,
            Add add) {
    const std::span<const double> transmittance = transmittance_.at(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const glm::dvec3 q = light_.source.position - points[k];
      const double r2 = glm::dot(q, q);
      if (!(r2 > 0.0)) continue;
      const double r = std::sqrt(r2);
      const glm::dvec3 normal = normals.empty() ? glm::dvec3(0.0) : normals[k];
      const double falloff = mean_falloff(points[k], normal, r, spacing);
      if (!(falloff > 0.0)) continue;
      const double visible =
          light_.surfaces ? light_.surfaces->transmittance(points[k], light_.source.position) : 1.0;
      if (!(visible > 0.0)) continue;
      add(k, q, visible * falloff * transmittance[k]);
    }
  }

 private:
  // Over the cells around a point at distance r: the mean of falloff / r^2 relative to that of
  // 1 / r^2, so that an edge between nodes lights its share of both. Points of a surface, which
  // have its normal, lie along it: else lights below a ceiling would light what is above them. The
  // means are those of what falls on it.
  [[nodiscard]] double mean_falloff(const glm::dvec3& point, const glm::dvec3& normal, double r,
                                    double spacing) const {
    const LightFalloff& falloff = light_.source.falloff;
    if (falloff.is_isotropic()) return 1.0;
    const glm::dvec3 q = point - light_.source.position;
    const glm::dvec3 w = q / r;
    // How much its cosine may change over the cells; farther from the edge it is 0 or 1.
    const double reach = std::min(std::sqrt(3.0) * spacing / r, 2.0);
    if (falloff.has_cone()) {
      const double versine = falloff.versine(w);
      if (versine - reach > falloff.dark_versine()) return 0.0;
      if (versine + reach < falloff.full_versine()) {
        if (!falloff.map()) return 1.0;
        // Profiles are linear between angles that are seldom closer.
        constexpr double smooth_reach = 0.1;
        if (falloff.shape() == LightFalloff::Shape::profile && reach < smooth_reach) {
          return falloff.by_map(w);
        }
      }
    } else if (std::abs(glm::dot(w, falloff.axis())) > reach) {
      return falloff.at(w);  // it is smooth there
    }
    double lit = 0.0;
    double all = 0.0;
    for (const WeightedPoint& p : falloff.has_cone() ? mean_rule() : cosine_rule()) {
      const glm::dvec3 offset = p.offset - glm::dot(p.offset, normal) * normal;
      const glm::dvec3 from_light = q + spacing * offset;
      const double distance2 = glm::dot(from_light, from_light);
      if (!(distance2 > 0.0)) continue;
      const double distance = std::sqrt(distance2);
      const double cosine =
          normal == glm::dvec3(0.0) ? 1.0 : -glm::dot(normal, from_light) / distance;
      const double weight = p.weight * std::max(cosine, 0.0) / distance2;
      lit += weight * falloff.by_map(from_light / distance);
      all += weight;
    }
    return all > 0.0 ? lit / all : 0.0;
  }

  const NodePointLight& light_;
  LightTransmittance transmittance_;
};

// The solid angle of a triangle, where `a`, `b` and `c` are unit vectors to its corners
// (Van Oosterom and Strackee 1983).
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
  return 2.0 * std::atan2(volume, 1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
}

// The mean irradiance of a square of a surface, one spacing wide, by a light of unit intensity at q
// from its middle: all that falls on it is its solid angle, however near the light is.
double mean_irradiance(const NodePointLight& light, const glm::dvec3& q, const glm::dvec3& normal,
                       double spacing) {
  const double height = glm::dot(normal, q);
  if (!(height > 0.0)) return 0.0;
  const double r2 = glm::dot(q, q);
  constexpr double far_spacings = 32.0;  // from there on its middle stands for it, within 0.02%
  const double cosine = height / std::sqrt(r2);
  // One surfel would stand for the bright spot of a light that is wide but very near.
  if (light.deviation > 0.0) {
    return cosine * std::min(light.inverse_square(r2), 4.0 / (spacing * spacing));
  }
  if (r2 > far_spacings * far_spacings * spacing * spacing) {
    return cosine * light.inverse_square(r2);
  }
  const auto [u, v] = make_basis(normal);
  const auto corner = [&](double x, double y) {
    return glm::normalize(0.5 * spacing * (x * u + y * v) - q);
  };
  const glm::dvec3 a = corner(-1.0, -1.0);
  const glm::dvec3 c = corner(1.0, 1.0);
  return (solid_angle(a, corner(1.0, -1.0), c) + solid_angle(a, c, corner(-1.0, 1.0))) /
         (spacing * spacing);
}

// The share of the cells around a point that it sees.
double visible_share(const RayCaster& surfaces, const glm::dvec3& point, double spacing) {
  double share = 0.0;
  for (const WeightedPoint& p : mean_rule()) {
    if (!surfaces.occluded(point, point + spacing * p.offset)) share += p.weight;
  }
  return share;
}

}  // namespace

void add_point_light(const NodePointLight& light, const glm::dvec3& first, const GridNodes& nodes,
                     const GridOcclusion* occlusion, NodeLight& incident, const Job& job) {
  const double spacing = static_cast<double>(nodes.spacing);
  const auto width = static_cast<std::size_t>(nodes.count.x);
  const LightRays rays(light, first, nodes, incident.bands, job);
  const double max_more = light.deviation > 0.0 ? 0.0 : 0.02;
  job.parallel_for(nodes.size() / width, [&](std::size_t row) {
    const auto add = [&](std::size_t x, double arriving, const ShVector<double>& basis) {
      for (std::size_t c = 0; c < incident.channels; ++c) {
        const double intensity = arriving * static_cast<double>(light.intensity[c]);
        for (std::size_t f = 0; f < basis.size(); ++f) {
          incident.row(c, f)[row * width + x] += static_cast<float>(intensity * basis[f]);
        }
      }
    };
    const glm::ivec3 row_start = node_coordinates(nodes, row * width);
    const auto position = [&](std::size_t x) {
      return first + spacing * glm::dvec3(row_start + glm::ivec3(static_cast<int>(x), 0, 0));
    };
    std::vector<double> shares(width);  // of the rays
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> xs;
    for (std::size_t x = 0; x < width; ++x) {
      shares[x] = rays.share(glm::length(position(x) - light.source.position));
      if (shares[x] >= 1.0) continue;
      points.push_back(position(x));
      xs.push_back(x);
    }
    PointsAroundLight(light).each(
        points, {}, spacing, [&](std::size_t k, const glm::dvec3& q, double arriving) {
          const double r2 = glm::dot(q, q);
          // The mean over the cells around a node is greater than at it, by the second order.
          const double more = std::min(spacing * spacing / (6.0 * r2), max_more);
          const double mean = light.inverse_square(r2) * (1.0 + more);
          add(xs[k], (1.0 - shares[xs[k]]) * mean * arriving,
              sh_basis(incident.bands, q / std::sqrt(r2)));
        });

    // A node beside surfaces gets the mean of what it sees of its cells.
    const auto is_beside_surfaces = [&](std::size_t x) {
      return occlusion && !occlusion->hidden().empty() && occlusion->hidden()[row * width + x] != 0;
    };
    for (std::size_t x = 0; x < width; ++x) {
      if (!(shares[x] > 0.0) || !is_beside_surfaces(x)) continue;
      const double visible = visible_share(*light.surfaces, position(x), spacing);
      shares[x] = visible > 0.0 ? shares[x] / visible : 0.0;
    }
    const auto sees = [&](std::size_t x, const glm::dvec3& sample) {
      return shares[x] > 0.0 &&
             (!is_beside_surfaces(x) || !light.surfaces->occluded(position(x), sample));
    };
    rays.each_in_row(row_start.y, row_start.z, sees,
                     [&](std::size_t x, const ShVector<double>& basis, double arriving) {
                       add(x, shares[x] * arriving, basis);
                     });
  });
}

void add_reflected_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                               const glm::dvec3& first, const GridNodes& nodes,
                               std::span<float> reflected, std::size_t channels, const Job& job) {
  constexpr std::size_t together = 64;  // nodes
  const double spacing = static_cast<double>(nodes.spacing);
  const std::size_t links = surfaces.surfels().size();
  const std::size_t count = surfaces.nodes().size();
  job.parallel_for((count + together - 1) / together, [&](std::size_t group) {
    PointsAroundLight around(light);
    std::vector<glm::dvec3> points;
    std::vector<glm::dvec3> normals;
    const std::size_t end = std::min((group + 1) * together, count);
    const std::size_t first_link = surfaces.nodes()[group * together].first;
    for (std::size_t i = group * together; i < end; ++i) {
      const glm::dvec3 node =
          first + spacing * glm::dvec3(node_coordinates(nodes, surfaces.grid_nodes()[i]));
      for (const GridOcclusion::Surfel& surfel : surfaces.surfels_of(i)) {
        // Off the surface, which does not shadow itself.
        points.push_back(node + glm::dvec3(surfel.offset) +
                         1e-3 * spacing * glm::dvec3(surfel.normal));
        normals.emplace_back(surfel.normal);
      }
    }
    around.each(points, normals, 0.5 * spacing,
                [&](std::size_t k, const glm::dvec3& q, double arriving) {
                  const GridOcclusion::Surfel& surfel = surfaces.surfels()[first_link + k];
                  const double falling = mean_irradiance(light, q, normals[k], spacing);
                  if (!(falling > 0.0)) return;
                  const double radiance = falling * arriving * std::numbers::inv_pi;
                  for (std::size_t c = 0; c < channels; ++c) {
                    reflected[c * links + first_link + k] += static_cast<float>(radiance) *
                                                             light.intensity[c] *
                                                             surfel.scattered[static_cast<int>(c)];
                  }
                });
  });
}

}  // namespace brume
