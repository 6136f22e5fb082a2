#include "render/scattering/mirrored_point_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <vector>

#include "core/math/spherical_harmonics.h"

namespace brume {
namespace {

// A light as a plane shows it.
class Image {
 public:
  Image(const NodePointLight& light, const MirrorPlane& plane, double spacing)
      : light_(light),
        plane_(plane),
        height_(glm::dot(plane.normal, light.source.position) - plane.offset),
        position_(light.source.position - 2.0 * height_ * plane.normal),
        min_r2_(0.25 * spacing * spacing),
        margin_(1e-4 * spacing) {}

  // A way from the light over the plane to a point.
  struct Way {
    glm::dvec3 w{0.0};         // unit, from the point towards the plane
    glm::dvec3 mirrored{0.0};  // where it meets the plane
    double t = 0.0;            // so far from the point [u]
    double r2 = 0.0;           // of its whole length [u^2]
    double falloff = 0.0;
  };
  // Nullopt: none passes the surfaces.
  [[nodiscard]] std::optional<Way> way_to(const glm::dvec3& point) const {
    const double height = glm::dot(plane_.normal, point) - plane_.offset;
    // A light on the plane has no image.
    if (!(height * height_ > 0.0) || std::abs(height_) < margin_) return std::nullopt;
    const glm::dvec3 q = position_ - point;
    Way way{.r2 = glm::dot(q, q)};
    const double r = std::sqrt(way.r2);
    way.w = q / r;
    way.t = r * height / (height + height_);
    way.mirrored = point + way.t * way.w;
    if (glm::any(glm::lessThan(way.mirrored, plane_.low - margin_)) ||
        glm::any(glm::greaterThan(way.mirrored, plane_.high + margin_))) {
      return std::nullopt;
    }
    const glm::dvec3 from_light = way.mirrored - light_.source.position;
    way.falloff = light_.source.falloff.at(glm::normalize(from_light));
    if (!(way.falloff > 0.0)) return std::nullopt;
    const SurfaceHit hit = light_.surfaces->first_hit(point, way.w);
    if (!hit || hit.surface != static_cast<std::int32_t>(plane_.surface) ||
        std::abs(hit.distance - way.t) > margin_ + 1e-4 * way.t) {
      return std::nullopt;
    }
    const glm::dvec3 off = std::copysign(margin_, height_) * plane_.normal;
    if (light_.surfaces->occluded(way.mirrored + off, light_.source.position)) return std::nullopt;
    return way;
  }

  // Per channel, Fresnel's term times what is left of 1 / r^2 behind the plane.
  [[nodiscard]] glm::dvec3 reflected(const Way& way, const glm::dvec3& point) const {
    const double s = std::pow(1.0 - std::abs(glm::dot(way.w, plane_.normal)), 5.0);
    const glm::dvec3& f0 = plane_.reflection.f0;
    const double depth = light_.fog * light_.source.fog.length(point, way.w, way.t);
    return way.falloff * std::exp(-depth) / std::max(way.r2, min_r2_) * (f0 + (1.0 - f0) * s);
  }

 private:
  const NodePointLight& light_;
  const MirrorPlane& plane_;
  double height_;        // of the light above the plane, of either sign [u]
  glm::dvec3 position_;  // of the image
  double min_r2_, margin_;
};

}  // namespace

void add_mirrored_point_light(const NodePointLight& light, const GridOcclusion& surfaces,
                              const glm::dvec3& first, const GridNodes& nodes, NodeLight& incident,
                              const Job& job) {
  const double spacing = static_cast<double>(nodes.spacing);
  const auto width = static_cast<std::size_t>(nodes.count.x);
  for (const MirrorPlane& plane : surfaces.mirrors()) {
    const Image image(light, plane, spacing);
    job.parallel_for(nodes.size() / width, [&](std::size_t row) {
      LightTransmittance transmittance(light);
      std::vector<glm::dvec3> points, mirrored;
      std::vector<Image::Way> ways;
      std::vector<std::size_t> places;
      for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
        const glm::dvec3 point = first + spacing * glm::dvec3(node_coordinates(nodes, i));
        const auto way = image.way_to(point);
        if (!way) continue;
        points.push_back(point);
        mirrored.push_back(way->mirrored);
        ways.push_back(*way);
        places.push_back(i);
      }
      if (ways.empty()) return;
      const std::span<const double> to_plane = transmittance.at(mirrored);
      for (std::size_t k = 0; k < ways.size(); ++k) {
        const glm::dvec3 arriving = to_plane[k] * image.reflected(ways[k], points[k]);
        const ShVector<double> basis = sh_basis(incident.bands, ways[k].w);
        for (std::size_t c = 0; c < incident.channels; ++c) {
          const double sent =
              arriving[static_cast<int>(c)] * static_cast<double>(light.intensity[c]);
          for (std::size_t f = 0; f < basis.size(); ++f) {
            incident.row(c, f)[places[k]] += static_cast<float>(sent * basis[f]);
          }
        }
      }
    });
  }
}

}  // namespace brume
