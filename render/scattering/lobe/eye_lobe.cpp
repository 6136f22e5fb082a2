#include "render/scattering/lobe/eye_lobe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "render/scattering/phase_bands.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/scattering/lobe/eye_lobe.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

#ifndef BRUME_EYE_LOBE_TYPES
#define BRUME_EYE_LOBE_TYPES
namespace brume {
namespace {

// The lobe: a Henyey-Greenstein phase function without what `rest` holds of it, by powers of the
// cosine, both times 4 pi.
struct Lobe {
  float anisotropy;
  std::array<float, PhaseBands::max_bands> rest;
};

// A place that light is scattered at.
struct ScatteringPlace {
  glm::vec3 position;  // from the eye
  glm::vec3 w;         // of the view ray
  float attenuation;   // 1 / the share of light that the medium lets through from there
};

}  // namespace
}  // namespace brume
#endif

HWY_BEFORE_NAMESPACE();
namespace brume::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

glm::vec3 Scatter(const SeenSurfels& surfels, const Lobe& lobe, const ScatteringPlace& place) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const auto set = [d](float value) HWY_ATTR { return hn::Set(d, value); };
  const auto load = [d](const std::vector<float>& values, std::size_t i)
                        HWY_ATTR { return hn::LoadU(d, values.data() + i); };
  const float g = lobe.anisotropy;
  const V tiny = set(1e-30f);
  V sums[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t i = 0; i < surfels.size(); i += hn::Lanes(d)) {
    const V x = hn::Sub(load(surfels.x, i), set(place.position.x));
    const V y = hn::Sub(load(surfels.y, i), set(place.position.y));
    const V z = hn::Sub(load(surfels.z, i), set(place.position.z));
    const V square = hn::MulAdd(x, x, hn::MulAdd(y, y, hn::Mul(z, z)));
    const V inverse = hn::Div(set(1.0f), hn::Sqrt(hn::Max(square, tiny)));
    const V to_normal =
        hn::MulAdd(x, load(surfels.normal_x, i),
                   hn::MulAdd(y, load(surfels.normal_y, i), hn::Mul(z, load(surfels.normal_z, i))));
    const V facing = hn::Mul(hn::Max(hn::Neg(to_normal), hn::Zero(d)), inverse);
    // A disk, which fills no more than a half space.
    const V area = load(surfels.area, i);
    const V disk = hn::MulAdd(area, set(std::numbers::inv_pi_v<float>), square);
    const V solid_angle = hn::Div(hn::Mul(area, facing), hn::Max(disk, tiny));
    const V along =
        hn::MulAdd(x, set(place.w.x), hn::MulAdd(y, set(place.w.y), hn::Mul(z, set(place.w.z))));
    const V cosine = hn::Mul(along, inverse);
    const V r = hn::MulAdd(cosine, set(-2.0f * g), set(1.0f + g * g));
    const V whole = hn::Div(set(1.0f - g * g), hn::Mul(r, hn::Sqrt(r)));
    V rest = set(lobe.rest.back());
    for (std::size_t k = lobe.rest.size() - 1; k-- > 0;) {
      rest = hn::MulAdd(rest, cosine, set(lobe.rest[k]));
    }
    // Eye, place and surfel count as in one line.
    const V passing = hn::Mul(load(surfels.passing, i), set(place.attenuation));
    const V passes = hn::Min(passing, hn::Div(set(1.0f), hn::Max(passing, tiny)));
    const V weight = hn::Mul(hn::Mul(hn::Sub(whole, rest), solid_angle), passes);
    for (std::size_t c = 0; c < 3; ++c) {
      sums[c] = hn::MulAdd(weight, load(surfels.radiance[c], i), sums[c]);
    }
  }
  glm::vec3 sum;
  for (int c = 0; c < 3; ++c) sum[c] = hn::GetLane(hn::SumOfLanes(d, sums[c]));
  return 0.25f * std::numbers::inv_pi_v<float> * sum;
}

}  // namespace brume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brume {
namespace {

HWY_EXPORT(Scatter);

// The distance from the eye to the medium, at least: from afar the eye itself would tell nothing in
// it apart.
double start_of(const SourceGrid& grid, const LobedMedium& medium, const CameraRays& rays) {
  const SourceGrid::Level& finest = grid.levels().front();
  const glm::dvec3 half =
      0.5 * static_cast<double>(finest.nodes.spacing) * glm::dvec3(finest.nodes.count - 1);
  glm::dvec3 center = finest.first + half;
  double radius = glm::length(half);
  if (medium.fog_density > 0.0) {
    if (medium.fog.is_endless()) return 0.0;
    center = medium.fog.center;
    radius = medium.fog.radius;
  }
  return std::max(glm::dot(center - rays.eye(), rays.forward()) - radius, 0.0);
}

// Returns the scattered light of a sky at the places of the table; at hidden ones that of where
// their column ends.
std::vector<glm::vec4> sky_values(const LobeColumns& columns, const SkyLobe& sky, const Job& job) {
  std::vector<glm::vec4> values(LobeColumns::count() *
                                static_cast<std::size_t>(LobeColumns::size.z));
  if (sky.empty()) return values;
  job.parallel_for(LobeColumns::count(), [&](std::size_t column) {
    const glm::dvec3& w = columns.direction(column);
    const glm::dvec3 begin = columns.eye() + columns.offset(column);
    glm::vec4 value(0.0f);
    bool is_behind = false;
    for (int layer = 0; layer < LobeColumns::size.z; ++layer) {
      const double t = std::min(columns.distance(layer), columns.end(column));
      if (!is_behind) value = glm::vec4(sky(begin, w, t), 0.0f);
      is_behind = columns.hides(column, layer);
      values[static_cast<std::size_t>(layer) * LobeColumns::count() + column] = value;
    }
  });
  return values;
}

}  // namespace

EyeLobe::EyeLobe(const SourceGrid& grid, const SentLight& sent, const LobedSky& sky,
                 const LobedMedium& medium, const CameraRays& rays, const Job& job)
    : revision_(new_revision()) {
  const ViewDepths depths(grid, medium);
  const double start = start_of(grid, medium, rays);
  const double medium_end = sky.scattered.empty() ? start : depths.end(rays.eye(), rays.forward());
  const LobeColumns columns(rays, sent.ray_caster, sent.surfaces, start,
                            static_cast<double>(grid.levels().front().nodes.spacing), medium_end);
  const CameraRays::FilmPlane plane = rays.plane();
  const auto along_film = [&](const glm::dvec3& per_pixel, double cells) {
    const glm::dvec3 axis = cells / glm::dot(per_pixel, per_pixel) * per_pixel;
    return glm::vec4(axis, -glm::dot(axis, plane.corner));
  };
  const glm::dvec2 film(rays.whole_size());
  places_ = {{along_film(plane.per_x, (size.x - 1) / film.x),
              along_film(plane.per_y, (size.y - 1) / film.y)},
             glm::vec3(rays.forward()),
             static_cast<float>(columns.start()),
             static_cast<float>(columns.distance())};
  const SeenSurfels surfels = seen_surfels(grid, sent, rays, columns.start(), depths, job);
  Lobe lobe{static_cast<float>(medium.anisotropy), {}};
  std::ranges::transform(PhaseBands(medium.anisotropy).phase_powers(), lobe.rest.begin(),
                         [](double power) { return static_cast<float>(power); });
  values_.resize(LobeColumns::count() * static_cast<std::size_t>(size.z));
  job.parallel_for(values_.size(), [&](std::size_t i) {
    const std::size_t column = i % LobeColumns::count();
    const auto layer = static_cast<int>(i / LobeColumns::count());
    const glm::dvec3& w = columns.direction(column);
    const glm::dvec3& offset = columns.offset(column);
    const double t = std::min(columns.distance(layer), columns.surface(column));
    const double seen_at = std::min(t, columns.end(column));
    constexpr double max_depth = 80.0;  // of floats
    const double depth = std::min(depths(rays.eye() + offset, w, t), max_depth);
    const ScatteringPlace place{glm::vec3(offset + seen_at * w), glm::vec3(w),
                                static_cast<float>(std::exp(depth))};
    values_[i] = glm::vec4(HWY_DYNAMIC_DISPATCH(Scatter)(surfels, lobe, place), 0.0f);
  });
  columns.fill_hidden(values_);
  add_places_behind(columns, sky_values(columns, {sky, sent.ray_caster, medium, depths}, job));
}

void EyeLobe::add_places_behind(const LobeColumns& columns, const std::vector<glm::vec4>& sky) {
  std::vector<glm::vec4> passing = sky;
  columns.pass_by_hidden(passing);
  const std::size_t count = values_.size();
  values_.resize(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    values_[count + i] = values_[i] + passing[i];
    values_[i] += sky[i];
    values_[i].w = static_cast<float>(columns.surface(i % LobeColumns::count()));
  }
}

glm::vec3 EyeLobe::at(const glm::vec3& offset, const glm::vec3& w, float t) const {
  const glm::vec4 on_film(offset + w / glm::dot(w, places_.forward), 1.0f);
  const glm::vec3 last(size - 1);
  const float beyond = std::max(t - places_.start, 0.0f);
  const glm::vec3 place =
      glm::clamp(glm::vec3(glm::dot(places_.film[0], on_film), glm::dot(places_.film[1], on_film),
                           static_cast<float>(size.z) * beyond / (beyond + places_.distance)),
                 glm::vec3(0.0f), last);
  const glm::ivec3 first = glm::min(glm::ivec3(place), size - 2);
  const glm::vec3 f = place - glm::vec3(first);
  constexpr int slab = size.x * size.y;
  const glm::vec4* const corner = values_.data() + first.z * slab + first.y * size.x + first.x;
  const auto in_column = [&](const glm::vec4* value) {
    if (t > value->w) value += slab * size.z;
    return glm::mix(value[0], value[slab], f.z);
  };
  return glm::vec3(
      glm::mix(glm::mix(in_column(corner), in_column(corner + 1), f.x),
               glm::mix(in_column(corner + size.x), in_column(corner + size.x + 1), f.x), f.y));
}

}  // namespace brume
#endif
