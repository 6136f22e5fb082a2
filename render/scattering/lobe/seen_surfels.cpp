#include "render/scattering/lobe/seen_surfels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "render/scattering/lobe/level_cells.h"

namespace brume {
namespace {

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
    const glm::vec3 offset(point.position - node_position(level, place));
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

// A part of the sphere of directions: a rectangle on the cylinder around it, which has its area.
struct DirectionCell {
  double z, azimuth;     // of its middle
  double height, width;  // [1], [rad]

  [[nodiscard]] double radius() const { return std::sqrt(1.0 - z * z); }
  [[nodiscard]] glm::dvec3 direction() const {
    return {radius() * std::cos(azimuth), radius() * std::sin(azimuth), z};
  }
  // The sides of its part of a surface at distance 1, along z and the azimuth, about; n: unit
  // normal.
  [[nodiscard]] glm::dvec2 footprint(const glm::dvec3& n) const {
    const double r = radius();
    const glm::dvec3 along_azimuth(-std::sin(azimuth), std::cos(azimuth), 0.0);
    const glm::dvec3 along_z = glm::cross(along_azimuth, direction());
    const double cosine = std::max(std::abs(glm::dot(n, direction())), min_cosine);
    return {height / r * std::hypot(1.0, glm::dot(n, along_z) / cosine),
            width * r * std::hypot(1.0, glm::dot(n, along_azimuth) / cosine)};
  }
  [[nodiscard]] std::array<DirectionCell, 2> halves(bool along_z) const {
    if (along_z) {
      return {{{z - 0.25 * height, azimuth, 0.5 * height, width},
               {z + 0.25 * height, azimuth, 0.5 * height, width}}};
    }
    return {{{z, azimuth - 0.25 * width, height, 0.5 * width},
             {z, azimuth + 0.25 * width, height, 0.5 * width}}};
  }

  static constexpr double min_cosine = 0.003;  // what is seen edge-on has no end
};

std::vector<DirectionCell> whole_sphere() {
  constexpr int rows = 16;
  constexpr int columns = 32;
  constexpr double height = 2.0 / rows;
  constexpr double width = 2.0 * std::numbers::pi / columns;
  std::vector<DirectionCell> cells;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      cells.push_back({(i + 0.5) * height - 1.0, j * width, height, width});
    }
  }
  return cells;
}

// Finds what is seen in all directions.
class SurfelFinder {
 public:
  struct Found {
    DirectionCell cell;
    SurfaceHit hit;
    SurfacePoint point;
  };

  SurfelFinder(const SentLight& sent, const CameraRays& rays, double start)
      : sent_(sent),
        rays_(rays),
        starts_at_eye_(start == 0.0),
        origin_(rays.eye() + start * rays.forward()) {}

  [[nodiscard]] std::vector<Found> find(const Job& job) const {
    Parts all{{}, whole_sphere()};
    constexpr int max_halvings = 14;
    for (int i = 0; i <= max_halvings && !all.cells.empty(); ++i) {
      constexpr std::size_t packet = 256;
      std::vector<Parts> parts((all.cells.size() + packet - 1) / packet);
      job.parallel_for(parts.size(), [&](std::size_t k) {
        const std::size_t first = k * packet;
        const std::size_t count = std::min(packet, all.cells.size() - first);
        divide(std::span(std::as_const(all.cells)).subspan(first, count), i < max_halvings,
               parts[k]);
      });
      all.cells.clear();
      for (const Parts& part : parts) {
        all.found.insert(all.found.end(), part.found.begin(), part.found.end());
        all.cells.insert(all.cells.end(), part.cells.begin(), part.cells.end());
      }
    }
    return all.found;
  }

 private:
  // Surfels, and cells that are too large yet.
  struct Parts {
    std::vector<Found> found;
    std::vector<DirectionCell> cells;
  };

  void divide(std::span<const DirectionCell> cells, bool may_halve, Parts& parts) const {
    const std::vector<SurfaceHit> hits = cast(cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const DirectionCell& cell = cells[i];
      const glm::dvec3 w = cell.direction();
      const bool sends = hits[i] && !hits[i].is_light();
      SurfacePoint point;
      if (sends) point = sent_.ray_caster.point(hits[i], origin_, w, sent_.surfaces);
      const glm::dvec2 size = cell.footprint(sends ? point.normal : w);
      if (may_halve && std::max(size.x, size.y) > max_size(w)) {
        const auto halves = cell.halves(size.x > size.y);
        parts.cells.insert(parts.cells.end(), halves.begin(), halves.end());
      } else if (sends) {
        parts.found.push_back({cell, hits[i], point});
      }
    }
  }

  [[nodiscard]] std::vector<SurfaceHit> cast(std::span<const DirectionCell> cells) const {
    std::vector<glm::dvec3> directions;
    for (const DirectionCell& cell : cells) directions.push_back(cell.direction());
    std::vector<SurfaceHit> hits(cells.size());
    if (starts_at_eye_) {
      sent_.ray_caster.first_hits(rays_, directions, {}, hits);
    } else {
      sent_.ray_caster.first_hits(origin_, directions, hits);
    }
    return hits;
  }

  // The largest extent of a surfel, relative to its distance: where cameras look, and elsewhere.
  [[nodiscard]] double max_size(const glm::dvec3& w) const {
    constexpr double min_cosine = 0.5;
    return glm::dot(w, rays_.forward()) > min_cosine ? 0.06 : 0.2;
  }

  const SentLight& sent_;
  const CameraRays& rays_;
  bool starts_at_eye_;
  glm::dvec3 origin_;
};

struct Surfel {
  glm::vec3 position{0.0f}, normal{0.0f}, radiance{0.0f};
  float area = 0.0f;
  float passing = 0.0f;
};

void append(SeenSurfels& seen, const Surfel& surfel) {
  seen.x.push_back(surfel.position.x);
  seen.y.push_back(surfel.position.y);
  seen.z.push_back(surfel.position.z);
  seen.normal_x.push_back(surfel.normal.x);
  seen.normal_y.push_back(surfel.normal.y);
  seen.normal_z.push_back(surfel.normal.z);
  seen.area.push_back(surfel.area);
  seen.passing.push_back(surfel.passing);
  for (std::size_t c = 0; c < 3; ++c) {
    seen.radiance[c].push_back(surfel.radiance[static_cast<int>(c)]);
  }
}

}  // namespace

SeenSurfels seen_surfels(const SourceGrid& grid, const SentLight& sent, const CameraRays& rays,
                         double start, const ViewDepths& depths, const Job& job) {
  const std::vector<SurfelFinder::Found> found = SurfelFinder(sent, rays, start).find(job);
  std::vector<Surfel> surfels(found.size());
  job.parallel_for(found.size(), [&](std::size_t i) {
    const auto& [cell, hit, point] = found[i];
    const double cosine =
        std::max(-glm::dot(point.normal, cell.direction()), DirectionCell::min_cosine);
    const double from_eye = rays.distance_to(point.position);
    const glm::dvec3 view = rays.towards(point.position);
    surfels[i] = {
        glm::vec3(point.position - rays.eye()), glm::vec3(point.normal),
        radiance_at(grid, sent, point),
        static_cast<float>(cell.height * cell.width * hit.distance * hit.distance / cosine),
        static_cast<float>(std::exp(-depths(point.position - from_eye * view, view, from_eye)))};
  });
  SeenSurfels seen;
  for (const Surfel& surfel : surfels) {
    if (surfel.area > 0.0f && surfel.radiance != glm::vec3(0.0f)) append(seen, surfel);
  }
  constexpr std::size_t max_lanes = 64;  // of any instruction set
  while (seen.size() % max_lanes != 0) append(seen, {});
  return seen;
}

}  // namespace brume
