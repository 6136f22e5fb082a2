#include "render/grid/grid_occlusion.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "brume/mesh_arrays.h"
#include "core/scene/materials/brdf.h"

namespace brume {
namespace {

// The light that a surface reflects where its vertices are black and white.
struct Reflectance {
  glm::vec3 black, white;

  // That in between; a mean of metals and others is not as linear, by at most 0.06.
  [[nodiscard]] glm::vec3 at(const glm::vec3& color) const { return glm::mix(black, white, color); }
};

// The light that a surface reflects, and the part of it that no mirror planes do.
struct Reflectances {
  Reflectance all, scattered;
};

// The links of one node that surfaces block.
struct NodeLinks {
  std::uint32_t blocked = 0, closed = 0;  // bits of links; the closed ones let nothing through
  std::vector<float> fractions, passing;
  std::vector<GridOcclusion::Surfel> surfels;
};

struct Link {
  SurfaceHit hit{};         // the first; none: it is open
  double passing = 0.0;     // share of light that comes through
  double reflecting = 1.0;  // share of the first surface's light that it reflects
};

Link link_to(const RayCaster& ray_caster, const glm::dvec3& node, const glm::dvec3& q) {
  const double distance = glm::length(q);
  if (!ray_caster.has_panes()) {
    if (!ray_caster.occluded(node, node + q)) return {};
    return {ray_caster.first_hit(node, q / distance)};  // none within the ray caster's margins
  }
  const HitsOnRay on_ray = ray_caster.hits_on_ray(node, q / distance);
  const SurfaceHit& first = on_ray.panes.empty() ? on_ray.end : on_ray.panes.front().hit;
  if (!(first.distance < distance)) return {};
  return {first, on_ray.passing(distance), ray_caster.pane(first, 0.0).covered};
}

NodeLinks links_of(const RayCaster& ray_caster, std::span<const Surface> surfaces,
                   std::span<const Reflectances> reflectances, const glm::dvec3& node,
                   double spacing) {
  NodeLinks links;
  for (int link = 0; link < 27; ++link) {
    const glm::ivec3 offset = neighbour_offset(link);
    if (offset == glm::ivec3(0)) continue;
    const glm::dvec3 q = spacing * glm::dvec3(offset);
    const auto [hit, passing, reflecting] = link_to(ray_caster, node, q);
    if (!hit) continue;
    const double distance = glm::length(q);
    const glm::dvec3 w = q / distance;
    const SurfacePoint point = ray_caster.point(hit, node, w, surfaces);
    links.blocked |= 1u << link;
    if (!(passing > 0.0)) links.closed |= 1u << link;
    links.fractions.push_back(static_cast<float>(std::min(hit.distance / distance, 1.0)));
    links.passing.push_back(static_cast<float>(passing));
    const auto share = static_cast<float>(reflecting);
    const auto& [all, scattered] = reflectances[static_cast<std::size_t>(hit.surface)];
    const glm::vec3 color(point.color);
    links.surfels.push_back({glm::vec3(point.position - node), glm::vec3(point.normal),
                             glm::min(share * all.at(color), 1.0f),
                             glm::min(share * scattered.at(color), 1.0f)});
  }
  return links;
}

// Whether surfaces block links of a neighbour.
bool is_beside_blocked(const GridNodes& nodes, std::span<const NodeLinks> links, std::size_t node) {
  const glm::ivec3 at = node_coordinates(nodes, node);
  for (int neighbour = 0; neighbour < 27; ++neighbour) {
    const glm::ivec3 p = at + neighbour_offset(neighbour);
    if (glm::any(glm::lessThan(p, glm::ivec3(0))) ||
        glm::any(glm::greaterThanEqual(p, nodes.count))) {
      continue;
    }
    if (links[node_index(nodes, p)].blocked != 0) return true;
  }
  return false;
}

// Nodes that open links connect with the border of their grid.
std::vector<bool> open_nodes(const GridNodes& nodes, std::span<const std::uint32_t> closed) {
  std::vector<std::size_t> reached;
  std::vector<bool> is_open(nodes.size(), false);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const glm::ivec3 place = node_coordinates(nodes, i);
    if (glm::all(glm::greaterThan(place, glm::ivec3(0))) &&
        glm::all(glm::lessThan(place, nodes.count - 1))) {
      continue;
    }
    is_open[i] = true;
    reached.push_back(i);
  }
  while (!reached.empty()) {
    const std::size_t node = reached.back();
    reached.pop_back();
    const glm::ivec3 place = node_coordinates(nodes, node);
    for (int link = 0; link < 27; ++link) {
      const glm::ivec3 offset = neighbour_offset(link);
      const glm::ivec3 p = place + offset;
      if (glm::any(glm::lessThan(p, glm::ivec3(0))) ||
          glm::any(glm::greaterThanEqual(p, nodes.count))) {
        continue;
      }
      const std::size_t other = node_index(nodes, p);
      const int back = neighbour_index(-offset.x, -offset.y, -offset.z);
      if (is_open[other] || (closed[node] >> link & 1u) != 0 || (closed[other] >> back & 1u) != 0) {
        continue;
      }
      is_open[other] = true;
      reached.push_back(other);
    }
  }
  return is_open;
}

}  // namespace

GridOcclusion::GridOcclusion(const RayCaster& ray_caster, std::span<const Surface> surfaces,
                             std::span<const MirrorPlane> mirrors, const glm::dvec3& first,
                             const GridNodes& nodes, const Job& job)
    : mirrors_(mirrors.begin(), mirrors.end()) {
  if (ray_caster.empty()) return;
  std::vector<Reflectances> reflectances;
  for (const Surface& surface : surfaces) {
    const glm::vec3 r(mean_reflectance(surface.material));
    const bool has_colors = surface.material.type == Material::Type::metallic_roughness &&
                            !to_arrays(*surface.mesh).colors.empty();
    const glm::dvec4 black(0.0, 0.0, 0.0, 1.0);
    const Reflectance own{has_colors ? glm::vec3(mean_reflectance(surface.material, black)) : r, r};
    reflectances.push_back({own, own});
    if (has_colors || r.x != r.y || r.y != r.z) is_grey_ = false;
  }
  for (const MirrorPlane& mirror : mirrors_) {
    const glm::vec3 diffuse(mirror.reflection.diffuse);
    reflectances[mirror.surface].scattered = {diffuse, diffuse};
  }
  const auto width = static_cast<std::size_t>(nodes.count.x);
  const auto height = static_cast<std::size_t>(nodes.count.y);
  const double spacing = static_cast<double>(nodes.spacing);
  const glm::dvec3 low = ray_caster.bounds().low - spacing;
  const glm::dvec3 high = ray_caster.bounds().high + spacing;
  std::vector<NodeLinks> links(nodes.size());
  job.parallel_for(height * static_cast<std::size_t>(nodes.count.z), [&](std::size_t row) {
    for (std::size_t x = 0; x < width; ++x) {
      const glm::ivec3 at(x, row % height, row / height);
      const glm::dvec3 p = first + spacing * glm::dvec3(at);
      if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) continue;
      links[row * width + x] = links_of(ray_caster, surfaces, reflectances, p, spacing);
    }
  });
  index_.assign(nodes.size(), -1);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].blocked == 0 && !is_beside_blocked(nodes, links, i)) continue;
    index_[i] = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({links[i].blocked, static_cast<std::uint32_t>(fractions_.size())});
    grid_nodes_.push_back(static_cast<std::uint32_t>(i));
    fractions_.insert(fractions_.end(), links[i].fractions.begin(), links[i].fractions.end());
    if (ray_caster.has_panes()) {
      passing_.insert(passing_.end(), links[i].passing.begin(), links[i].passing.end());
    }
    surfels_.insert(surfels_.end(), links[i].surfels.begin(), links[i].surfels.end());
  }
  if (nodes_.empty()) {
    index_.clear();
    return;
  }
  for (const NodeLinks& node : links) hidden_.push_back(node.closed);
  const std::vector<bool> is_open = open_nodes(nodes, hidden_);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    hidden_[i] = links[i].blocked | (is_open[i] ? 0u : enclosed_bit);
  }
}

bool GridOcclusion::hides(std::size_t grid_node, std::uint32_t links,
                          const glm::vec3& offset) const {
  if (index_.empty() || index_[grid_node] < 0) return false;
  const auto i = static_cast<std::size_t>(index_[grid_node]);
  std::span<const Surfel> surfels = surfels_of(i);
  for (std::uint32_t blocked = nodes_[i].blocked; blocked != 0; blocked &= blocked - 1) {
    const Surfel& surfel = surfels.front();
    surfels = surfels.subspan(1);
    const bool is_asked = (links >> std::countr_zero(blocked) & 1u) != 0;
    if (is_asked && glm::dot(offset - surfel.offset, surfel.normal) < 0.0f) return true;
  }
  return false;
}

void LevelOcclusion::set(const RayCaster& ray_caster, std::span<const Surface> surfaces) {
  std::vector<Material> materials;
  for (const Surface& surface : surfaces) materials.push_back(surface.material);
  if (ray_caster_revision_ != ray_caster.revision() || materials_ != materials) {
    revision_ = new_revision();
    mirrors_ = mirror_planes(surfaces);
  }
  if (ray_caster_revision_ != ray_caster.revision()) planes_ = AxisPlanes(ray_caster);
  ray_caster_ = &ray_caster;
  surfaces_ = surfaces;
  ray_caster_revision_ = ray_caster.revision();
  materials_ = std::move(materials);
}

std::shared_ptr<const GridOcclusion> LevelOcclusion::at(std::size_t level, const glm::dvec3& first,
                                                        const GridNodes& nodes, const Job& job) {
  if (level >= cached_.size()) cached_.resize(level + 1);
  auto& [cached, last] = cached_[level];
  const auto is_wanted = [&](const Cached& of) {
    return of.surfaces == revision_ && of.first == first && of.nodes == nodes;
  };
  if (is_wanted(cached)) return cached.occlusion;
  std::swap(cached, last);
  if (is_wanted(cached)) return cached.occlusion;
  cached = {
      revision_, first, nodes,
      std::make_shared<const GridOcclusion>(*ray_caster_, surfaces_, mirrors_, first, nodes, job)};
  if (job.stop.stop_requested()) cached = {};
  return cached.occlusion;
}

}  // namespace brume
