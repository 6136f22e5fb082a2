#include "render/scattering/eye_lobe.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "render/scattering/phase_bands.h"

// Highway includes this file once per instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/scattering/eye_lobe.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: foreach_target first.
#include <hwy/highway.h>

#ifndef BRUME_EYE_LOBE_TYPES
#define BRUME_EYE_LOBE_TYPES
namespace brume {
namespace {

// Parts of surfaces that the eye sees, relative to it; filled up to whole vectors by black ones.
struct SeenSurfels {
  std::vector<float> x, y, z, normal_x, normal_y, normal_z;
  std::vector<float> area;     // [u^2]
  std::vector<float> passing;  // share of light that the medium lets through to the eye
  std::array<std::vector<float>, 3> radiance;

  [[nodiscard]] std::size_t size() const { return x.size(); }
};

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

// Rays that find surfaces, about 3 degrees apart.
constexpr int direction_count = 6144;

// They are even over the sphere, and the same for all eyes.
std::vector<glm::dvec3> even_directions() {
  std::vector<glm::dvec3> result;
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < direction_count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / direction_count;
    const double radius = std::sqrt(1.0 - z * z);
    result.emplace_back(radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i),
                        z);
  }
  return result;
}

glm::dvec3 position(const SourceGrid::Level& level, const glm::ivec3& node) {
  return level.first + static_cast<double>(level.nodes.spacing) * glm::dvec3(node);
}

// A point in cells from a level's first node.
glm::dvec3 in_cells(const SourceGrid::Level& level, const glm::dvec3& p) {
  return (p - level.first) / static_cast<double>(level.nodes.spacing);
}

bool holds(const SourceGrid::Level& level, const glm::dvec3& cells) {
  return glm::all(glm::greaterThanEqual(cells, glm::dvec3(0.0))) &&
         glm::all(glm::lessThanEqual(cells, glm::dvec3(level.nodes.count - 1)));
}

// The first node of the cell that a point is in, or the nearest one.
glm::ivec3 cell_of(const SourceGrid::Level& level, const glm::dvec3& cells) {
  return glm::clamp(glm::ivec3(glm::floor(cells)), glm::ivec3(0),
                    glm::max(level.nodes.count - 2, 0));
}

// The mean radiance that the nodes around a point of a surface see near it, weighted by nearness.
// Nothing if they see no surface that faces like it.
std::optional<glm::vec3> radiance_at(const SourceGrid::Level& level, const SentLight& sent,
                                     std::span<const float> reflected, const SurfacePoint& point) {
  if (!level.surfaces || level.surfaces->surfels().empty()) return std::nullopt;
  const GridOcclusion& surfaces = *level.surfaces;
  const std::span<const std::int32_t> index = surfaces.sweep().index;
  const std::size_t links = surfaces.surfels().size();
  constexpr float min_facing = 0.5f;
  constexpr float near = 0.1f;  // spacings within which all are near alike
  const float soft = near * level.nodes.spacing;
  const glm::vec3 normal(point.normal);
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 place = cell_of(level, in_cells(level, point.position)) +
                             glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const std::int32_t found = index[node_index(level.nodes, place)];
    if (found < 0) continue;
    const auto node = static_cast<std::size_t>(found);
    const glm::vec3 offset(point.position - position(level, place));
    if (glm::dot(offset, normal) > 0.0f) continue;  // behind the surface, or in a solid
    std::size_t link = surfaces.nodes()[node].first;
    for (const GridOcclusion::Surfel& surfel : surfaces.surfels_of(node)) {
      const float facing = glm::dot(surfel.normal, normal);
      const glm::vec3 apart = surfel.offset - offset;
      if (facing > min_facing) {
        const float weight = facing / (glm::dot(apart, apart) + soft * soft);
        for (std::size_t c = 0; c < 3; ++c) {
          const std::size_t row = sent.channels == 3 ? c * links : 0;
          sum[static_cast<int>(c)] += weight * reflected[row + link];
        }
        weights += weight;
      }
      ++link;
    }
  }
  if (!(weights > 0.0f)) return std::nullopt;
  return sent.color * sum / weights;
}

// The finest level that knows the surface tells.
glm::vec3 radiance_at(const SourceGrid& grid, const SentLight& sent, const SurfacePoint& point) {
  const auto levels = grid.levels();
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const bool is_outermost = k + 1 == levels.size();
    if (!is_outermost && !holds(levels[k], in_cells(levels[k], point.position))) continue;
    if (const auto found = radiance_at(levels[k], sent, sent.reflected[k], point)) return *found;
  }
  return glm::vec3(0.0f);
}

// Optical depths of view rays.
class ViewDepths {
 public:
  ViewDepths(const SourceGrid& grid, const LobedMedium& medium) : grid_(grid), medium_(medium) {
    const auto is_zero = [](float density) { return density == 0.0f; };
    has_gaussians_ = !std::ranges::all_of(grid.levels(), [&](const SourceGrid::Level& level) {
      return std::ranges::all_of(level.density, is_zero);
    });
  }

  // The depth of the first `distance` from a point on, as fine as the grid is.
  [[nodiscard]] double operator()(const glm::dvec3& begin, const glm::dvec3& w,
                                  double distance) const {
    double depth = 0.0;
    if (medium_.fog_density > 0.0) {
      depth = medium_.fog_density * medium_.fog.length(begin, w, distance);
    }
    if (!has_gaussians_) return depth;
    constexpr double min_steps = 4.0;
    constexpr double max_steps = 64.0;
    const double spacing = static_cast<double>(grid_.levels().front().nodes.spacing);
    const auto steps =
        static_cast<int>(std::clamp(std::ceil(distance / spacing), min_steps, max_steps));
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += density(begin + (i + 0.5) / steps * distance * w);
    return depth + sum * distance / steps / medium_.grid_extinction;
  }

 private:
  // The density of the Gaussians, as the grid has it.
  [[nodiscard]] double density(const glm::dvec3& point) const {
    for (const SourceGrid::Level& level : grid_.levels()) {
      const glm::dvec3 cells = in_cells(level, point);
      if (!holds(level, cells)) continue;
      const glm::ivec3 first = cell_of(level, cells);
      const glm::vec3 f(cells - glm::dvec3(first));
      const auto row = static_cast<std::size_t>(level.nodes.count.x);
      const std::size_t slab = row * static_cast<std::size_t>(level.nodes.count.y);
      const float* const corner = level.density.data() + node_index(level.nodes, first);
      const auto along = [&](std::size_t step) {
        return glm::mix(corner[step], corner[step + 1], f.x);
      };
      return static_cast<double>(glm::mix(glm::mix(along(0), along(row), f.y),
                                          glm::mix(along(slab), along(slab + row), f.y), f.z));
    }
    return 0.0;
  }

  const SourceGrid& grid_;
  const LobedMedium& medium_;
  bool has_gaussians_ = false;
};

void add(SeenSurfels& seen, const glm::dvec3& position, const glm::dvec3& normal, double area,
         double passing, const glm::vec3& radiance) {
  const auto add_to = [](std::vector<float>& values, double value) {
    values.push_back(static_cast<float>(value));
  };
  add_to(seen.x, position.x);
  add_to(seen.y, position.y);
  add_to(seen.z, position.z);
  add_to(seen.normal_x, normal.x);
  add_to(seen.normal_y, normal.y);
  add_to(seen.normal_z, normal.z);
  add_to(seen.area, area);
  add_to(seen.passing, passing);
  for (std::size_t c = 0; c < 3; ++c) seen.radiance[c].push_back(radiance[static_cast<int>(c)]);
}

// How far before the eye the medium begins, at least: from afar the eye itself would tell nothing
// in it apart.
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

// Those that send light, seen from so far before the eye.
SeenSurfels seen_surfels(const SourceGrid& grid, const SentLight& sent, const CameraRays& rays,
                         double start, const ViewDepths& depths) {
  constexpr double min_cosine = 0.06;  // to the normal: what is seen edge-on has no end
  const std::vector<glm::dvec3> directions = even_directions();
  std::vector<SurfaceHit> hits(directions.size());
  const glm::dvec3 origin = rays.eye() + start * rays.forward();
  if (start > 0.0) {
    sent.ray_caster.first_hits(origin, directions, hits);
  } else {
    sent.ray_caster.first_hits(rays, directions, {}, hits);
  }
  SeenSurfels seen;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (!hits[i] || hits[i].is_light()) continue;
    const glm::dvec3& w = directions[i];
    const SurfacePoint point = sent.ray_caster.point(hits[i], origin, w, sent.surfaces);
    const glm::vec3 radiance = radiance_at(grid, sent, point);
    if (radiance == glm::vec3(0.0f)) continue;
    const double distance = hits[i].distance;
    const double cosine = std::max(-glm::dot(point.normal, w), min_cosine);
    const double area = 4.0 * std::numbers::pi / direction_count * distance * distance / cosine;
    const double from_eye = rays.distance_to(point.position);
    const glm::dvec3 view = rays.towards(point.position);
    add(seen, point.position - rays.eye(), point.normal, area,
        std::exp(-depths(point.position - from_eye * view, view, from_eye)), radiance);
  }
  constexpr std::size_t max_lanes = 64;  // of any instruction set
  while (seen.size() % max_lanes != 0) {
    add(seen, glm::dvec3(0.0), glm::dvec3(0.0), 0.0, 0.0, glm::vec3(0.0f));
  }
  return seen;
}

// The rays of the table's columns, and where they end.
struct Columns {
  std::vector<glm::dvec3> directions, offsets;
  std::vector<SurfaceHit> hits;

  Columns(const CameraRays& rays, const RayCaster& surfaces) {
    constexpr glm::ivec3 size = EyeLobe::size;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const glm::dvec2 place =
            glm::dvec2(rays.whole_size()) * glm::dvec2(x, y) / glm::dvec2(size.x - 1, size.y - 1);
        directions.push_back(rays.whole_direction(place));
        offsets.push_back(rays.whole_offset(place));
      }
    }
    hits.resize(directions.size());
    const bool is_parallel = rays.is_parallel();
    surfaces.first_hits(
        rays, directions,
        is_parallel ? std::span(std::as_const(offsets)) : std::span<const glm::dvec3>(), hits);
  }

  // The median distance to what they hit; 0: nothing.
  [[nodiscard]] double median_distance() const {
    std::vector<double> distances;
    for (const SurfaceHit& hit : hits) {
      if (hit) distances.push_back(hit.distance);
    }
    if (distances.empty()) return 0.0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, middle);
    return *middle;
  }
};

// Sets places of a layer that surfaces hide to the mean of what is seen beside them, as far as
// anything is: rays that pass by the surface are looked up between both.
void fill_hidden(std::span<glm::vec4> values, std::span<std::uint8_t> is_hidden) {
  constexpr glm::ivec3 size = EyeLobe::size;
  const auto index = [](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
  for (bool changes = true; changes;) {
    changes = false;
    const std::vector<std::uint8_t> was_hidden(is_hidden.begin(), is_hidden.end());
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        if (was_hidden[index(x, y)] == 0) continue;
        glm::vec4 sum(0.0f);
        float count = 0.0f;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.y - 1); ++v) {
          for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.x - 1); ++u) {
            if (was_hidden[index(u, v)] != 0) continue;
            sum += values[index(u, v)];
            count += 1.0f;
          }
        }
        if (count == 0.0f) continue;
        values[index(x, y)] = sum / count;
        is_hidden[index(x, y)] = 0;
        changes = true;
      }
    }
  }
}

}  // namespace

EyeLobe::EyeLobe(const SourceGrid& grid, const SentLight& sent, const LobedMedium& medium,
                 const CameraRays& rays, const Job& job)
    : revision_(new_revision()) {
  const Columns columns(rays, sent.ray_caster);
  const double spacing = static_cast<double>(grid.levels().front().nodes.spacing);
  const double start = start_of(grid, medium, rays);
  const double distance = std::max(columns.median_distance() - start, spacing);
  const CameraRays::FilmPlane plane = rays.plane();
  const auto along_film = [&](const glm::dvec3& per_pixel, double cells) {
    const glm::dvec3 axis = cells / glm::dot(per_pixel, per_pixel) * per_pixel;
    return glm::vec4(axis, -glm::dot(axis, plane.corner));
  };
  const glm::dvec2 film(rays.whole_size());
  places_ = {{along_film(plane.per_x, (size.x - 1) / film.x),
              along_film(plane.per_y, (size.y - 1) / film.y)},
             glm::vec3(rays.forward()),
             static_cast<float>(start),
             static_cast<float>(distance)};
  const ViewDepths depths(grid, medium);
  const SeenSurfels surfels = seen_surfels(grid, sent, rays, start, depths);
  Lobe lobe{static_cast<float>(medium.anisotropy), {}};
  std::ranges::transform(PhaseBands(medium.anisotropy).phase_powers(), lobe.rest.begin(),
                         [](double power) { return static_cast<float>(power); });
  values_.resize(static_cast<std::size_t>(size.x * size.y * size.z));
  std::vector<std::uint8_t> is_hidden(values_.size());
  job.parallel_for(values_.size(), [&](std::size_t i) {
    const auto layer_size = static_cast<std::size_t>(size.x * size.y);
    const std::size_t column = i % layer_size;
    const auto k = static_cast<double>(i / layer_size);
    // Not so near a surface that its parts are told apart, nor behind it.
    constexpr double before_surface = 0.9;
    const double end = start + before_surface * (columns.hits[column].distance - start);
    const double t = start + distance * k / (size.z - k);
    is_hidden[i] = t > end ? 1 : 0;
    const glm::dvec3& w = columns.directions[column];
    const glm::dvec3& offset = columns.offsets[column];
    const double seen_at = std::min(t, end);
    constexpr double max_depth = 80.0;  // of floats
    const double depth = std::min(depths(rays.eye() + offset, w, seen_at), max_depth);
    const ScatteringPlace place{glm::vec3(offset + seen_at * w), glm::vec3(w),
                                static_cast<float>(std::exp(depth))};
    values_[i] = glm::vec4(HWY_DYNAMIC_DISPATCH(Scatter)(surfels, lobe, place), 0.0f);
  });
  for (int k = 0; k < size.z; ++k) {
    const auto layer = static_cast<std::size_t>(k * size.x * size.y);
    fill_hidden(std::span(values_).subspan(layer, static_cast<std::size_t>(size.x * size.y)),
                std::span(is_hidden).subspan(layer, static_cast<std::size_t>(size.x * size.y)));
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
  const glm::vec4* const corner = values_.data() + (first.z * size.y + first.y) * size.x + first.x;
  const auto on_layer = [&](const glm::vec4* layer) {
    return glm::mix(glm::mix(layer[0], layer[1], f.x),
                    glm::mix(layer[size.x], layer[size.x + 1], f.x), f.y);
  };
  return glm::vec3(glm::mix(on_layer(corner), on_layer(corner + size.x * size.y), f.z));
}

}  // namespace brume
#endif
