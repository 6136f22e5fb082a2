#include "render/shading/mirrored_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <vector>

#include "core/scene/materials/ggx.h"
#include "render/geometry/even_points.h"

namespace brume {
namespace {

// Highlights of less alpha are so narrow that one airlight is that of all their rays.
constexpr float narrow = 0.05f;

// Those of less are sharp: one ray. Copies of what is mirrored would show.
constexpr float sharp = 0.015f;

// Rays of a highlight of this alpha.
int ray_count(float alpha, int max_rays) {
  constexpr float wide = 0.1f;
  const int wanted = alpha < sharp ? 1 : alpha < narrow ? 4 : alpha < wide ? 8 : 16;
  return std::min(wanted, max_rays);
}

// Rays of a highlight in all patterns together.
constexpr int all_pattern_rays = MirroredRays::shared_rays * SharedHighlights::patterns;

// A ray that a point mirrors, and the share of its light that is reflected.
struct MirroredRay {
  std::size_t point;
  glm::dvec3 direction;  // unit
  double base, grazing;  // over f0, and beside it
  SurfaceHit hit{};
  glm::vec3 behind{0.0f};  // radiance of the surface that it hits, or of the environment
};

void add_rays(const SurfacePoints& points, std::size_t k, const MirroredRays& mirrored,
              std::vector<MirroredRay>& rays) {
  const glm::dvec3 n = points.normal[k];
  const glm::dvec3 wo = points.to_eye[k];
  const float alpha = points.ggx.alpha[k];
  const bool is_shared = is_wide_highlight(alpha) && !mirrored.patterns.empty();
  const int count = is_shared ? mirrored.pattern_rays : ray_count(alpha, mirrored.max_rays);
  const int sets = is_shared ? all_pattern_rays / count : 1;
  const int pattern = is_shared ? mirrored.patterns[k] % sets : 0;
  GgxReflection black, white;
  black.alpha = white.alpha = static_cast<double>(alpha);
  white.f0 = glm::dvec3(1.0);
  for (int j = 0; j < count; ++j) {
    const glm::dvec2 place = even_point(sets * j + pattern, sets * count);
    const glm::dvec3 wi = sample_ggx(black.alpha, wo, n, place);
    const double cosine = glm::dot(wi, n);
    const double pdf = ggx_pdf(black.alpha, wi, wo, n);
    if (!(cosine > 0.0) || !(pdf > 0.0)) continue;
    const double share = cosine / (pdf * count);
    const double grazing = share * ggx_brdf(black, wi, wo, n).x;
    rays.push_back(
        {k, glm::normalize(wi), share * ggx_brdf(white, wi, wo, n).x - grazing, grazing});
  }
}

// The radiance of the surfaces that rays hit, those of one surface together.
void shade(const MirroredScene& scene, const SurfacePoints& points, std::span<MirroredRay> rays) {
  std::map<std::int32_t, std::vector<std::size_t>> waiting;
  const auto shade_together = [&](std::vector<std::size_t>& some) {
    std::array<SurfaceHit, Tiles::pixels> hits;
    std::array<glm::vec3, Tiles::pixels> directions, radiance;
    std::array<glm::dvec3, Tiles::pixels> offsets;
    for (std::size_t i = 0; i < some.size(); ++i) {
      hits[i] = rays[some[i]].hit;
      directions[i] = glm::vec3(rays[some[i]].direction);
      offsets[i] = points.shadow_origin[rays[some[i]].point];
    }
    scene.shade(std::span(hits).first(some.size()), points.origin,
                std::span(directions).first(some.size()), std::span(offsets).first(some.size()),
                std::span(radiance).first(some.size()));
    for (std::size_t i = 0; i < some.size(); ++i) rays[some[i]].behind = radiance[i];
    some.clear();
  };
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!rays[i].hit || rays[i].hit.is_light()) continue;
    std::vector<std::size_t>& some = waiting[rays[i].hit.surface];
    some.push_back(i);
    if (some.size() == Tiles::pixels) shade_together(some);
  }
  for (auto& [surface, some] : waiting) {
    if (!some.empty()) shade_together(some);
  }
}

// The medium on the ways of mirrored rays. Those of a narrow highlight that hit one
// surface share the first's, and neighbours are evaluated together: most of the time that mirrors
// take.
class Ways {
 public:
  Ways(const MirroredScene& scene, const SurfacePoints& points, std::span<const MirroredRay> rays) {
    std::size_t point = points.count;
    std::size_t first = 0;  // of the point's ways
    std::vector<std::int32_t> surfaces;
    for (const MirroredRay& ray : rays) {
      if (ray.point != point) {
        point = ray.point;
        first = directions_.size();
        surfaces.clear();
      }
      const auto known = std::ranges::find(surfaces, ray.hit.surface);
      if (known != surfaces.end() && points.ggx.alpha[ray.point] < narrow) {
        of_rays_.push_back(first + static_cast<std::size_t>(known - surfaces.begin()));
        continue;
      }
      of_rays_.push_back(directions_.size());
      surfaces.push_back(ray.hit.surface);
      starts_.push_back(points.origin + points.shadow_origin[ray.point]);
      directions_.push_back(ray.direction);
      lengths_.push_back(ray.hit ? ray.hit.distance : scene.open_length(starts_.back()));
    }
    airlight_.assign(directions_.size(), glm::vec3(0.0f));
    depths_.assign(directions_.size(), 0.0);
    if (scene.airlight_along) evaluate(scene.airlight_along);
  }

  [[nodiscard]] const glm::vec3& airlight(std::size_t ray) const {
    return airlight_[of_rays_[ray]];
  }
  [[nodiscard]] double depth(std::size_t ray) const { return depths_[of_rays_[ray]]; }

 private:
  void evaluate(const AirlightAlong& airlight_along) {
    constexpr std::size_t together = 16;
    std::array<glm::dvec3, together> offsets;
    for (std::size_t k = 0; k < directions_.size(); k += together) {
      const std::size_t count = std::min(together, directions_.size() - k);
      for (std::size_t i = 0; i < count; ++i) offsets[i] = starts_[k + i] - starts_[k];
      airlight_along(starts_[k], std::span(offsets).first(count),
                     std::span(directions_).subspan(k, count),
                     std::span(lengths_).subspan(k, count), std::span(airlight_).subspan(k, count),
                     std::span(depths_).subspan(k, count));
    }
  }

  std::vector<std::size_t> of_rays_;
  std::vector<glm::dvec3> starts_, directions_;
  std::vector<double> lengths_, depths_;
  std::vector<glm::vec3> airlight_;
};

}  // namespace

bool begin_mirroring(SurfacePoints& points) {
  bool any = false;
  for (std::size_t k = 0; k < points.padded_size(); ++k) {
    const bool mirrors = points.ggx.alpha[k] < float{GgxReflection::max_mirror_alpha};
    points.ggx.lobe[k] = mirrors ? 0.0f : 1.0f;
    any |= mirrors;
  }
  return any;
}

bool is_wide_highlight(float alpha) {
  return !(alpha < sharp);
}

void add_mirrored_light(const MirroredScene& scene, const SurfacePoints& points,
                        const MirroredRays& mirrored, PointRadiance& radiance,
                        WideHighlights* shared) {
  std::vector<MirroredRay> rays;
  std::vector<glm::dvec3> directions;
  std::vector<SurfaceHit> hits;
  for (std::size_t k = 0; k < points.count; ++k) {
    if (points.ggx.lobe[k] > 0.0f) continue;
    if (!mirrored.patterns.empty() && mirrored.patterns[k] == MirroredRays::none) continue;
    const std::size_t first = rays.size();
    add_rays(points, k, mirrored, rays);
    const std::span<MirroredRay> own = std::span(rays).subspan(first);
    directions.clear();
    for (const MirroredRay& ray : own) directions.push_back(ray.direction);
    hits.resize(own.size());
    // Panes only attenuate what is behind them.
    const glm::dvec3 start = points.origin + points.shadow_origin[k];
    scene.ray_caster.opaque_hits(start, directions, hits, 0.0);
    scene.light_shapes.meet(start, directions, {}, hits);
    for (std::size_t i = 0; i < own.size(); ++i) own[i].hit = hits[i];
  }
  constexpr std::array open{std::numeric_limits<float>::infinity()};
  for (MirroredRay& ray : rays) {
    if (ray.hit || !scene.environment) continue;
    scene.environment->show(ray.direction, glm::dvec3(0.0), 0, open, std::span(&ray.behind, 1));
  }
  shade(scene, points, rays);
  const Ways ways(scene, points, rays);
  const bool has_panes = scene.ray_caster.has_panes();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const MirroredRay& ray = rays[i];
    double passes = std::exp(-ways.depth(i));
    if (has_panes) {
      passes *= scene.ray_caster.transmittance(points.origin + points.shadow_origin[ray.point],
                                               ray.direction, ray.hit.distance);
    }
    const glm::vec3 arriving = ways.airlight(i) + static_cast<float>(passes) * ray.behind;
    const Highlight highlight{static_cast<float>(ray.base) * arriving,
                              static_cast<float>(ray.grazing) * arriving};
    if (shared && is_wide_highlight(points.ggx.alpha[ray.point])) {
      shared->base.add(ray.point, highlight.base);
      shared->grazing.add(ray.point, highlight.grazing);
    } else {
      radiance.add(ray.point, highlight.reflected(glm::vec3(points.ggx.f0[ray.point])));
    }
  }
}

}  // namespace brume
