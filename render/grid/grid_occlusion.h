#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "brume/revision.h"
#include "brume/scene.h"
#include "core/math/infinity.h"
#include "render/grid/axis_planes.h"
#include "render/grid/mirror_planes.h"
#include "render/grid/sweep_kernels.h"
#include "render/util/job.h"
#include "render/visibility/ray_caster.h"

namespace brume {

// Where surfaces come between neighbouring nodes of a grid. Each node has 26 neighbours, also where
// the grid ends.
class GridOcclusion {
 public:
  // Of nodes within solids and closed rooms: those that no open links connect with the grid's
  // border.
  static constexpr std::uint32_t enclosed_bit = 1u << neighbour_index(0, 0, 0);
  static constexpr std::uint32_t all_bits = (1u << 27) - 1u;

  // What a node sees in place of a neighbour.
  struct Surfel {
    glm::vec3 offset{0.0f};       // from the node [u]
    glm::vec3 normal{0.0f};       // unit, on the side of the node
    glm::vec3 reflectance{0.0f};  // of all it reflects, as a diffuse surface would
    glm::vec3 scattered{0.0f};    // the part that mirrors() do not
  };

  GridOcclusion() = default;  // nothing is occluded
  // Rays are traced in parallel: 26 for each node within the bounds of the surfaces. Invalid after
  // the job was stopped.
  GridOcclusion(const RayCaster& ray_caster, std::span<const Surface> surfaces,
                std::span<const MirrorPlane> mirrors, const glm::dvec3& first,
                const GridNodes& nodes, const Job& job);

  [[nodiscard]] bool is_grey() const { return is_grey_; }
  // The flat sides of smooth surfaces.
  [[nodiscard]] std::span<const MirrorPlane> mirrors() const { return mirrors_; }
  // Per grid node, OccludedNode::blocked, and enclosed_bit; empty: nothing is hidden. Panes hide.
  // Light on both sides of a pane differs: who looks up one side has no use for nodes on the other.
  [[nodiscard]] std::span<const std::uint32_t> hidden() const { return hidden_; }
  // True if a point at `offset` from a grid node [u] is behind a surface that blocks one of these
  // links of the node, as far as it is flat. `links`: bits of neighbours.
  [[nodiscard]] bool hides(std::size_t grid_node, std::uint32_t links,
                           const glm::vec3& offset) const;
  // For the kernels.
  [[nodiscard]] SweepOcclusion sweep() const { return {index_, nodes_, fractions_, passing_, {}}; }
  // Per blocked link of the kernels' nodes.
  [[nodiscard]] std::span<const Surfel> surfels() const { return surfels_; }
  [[nodiscard]] std::span<const OccludedNode> nodes() const { return nodes_; }
  // Grid nodes of nodes().
  [[nodiscard]] std::span<const std::uint32_t> grid_nodes() const { return grid_nodes_; }
  // The surfels of nodes()[i].
  [[nodiscard]] std::span<const Surfel> surfels_of(std::size_t i) const {
    return std::span(surfels_).subspan(nodes_[i].first,
                                       static_cast<std::size_t>(std::popcount(nodes_[i].blocked)));
  }

 private:
  std::vector<std::int32_t> index_;
  std::vector<std::uint32_t> hidden_;
  std::vector<OccludedNode> nodes_;
  std::vector<std::uint32_t> grid_nodes_;
  std::vector<float> fractions_, passing_;
  std::vector<Surfel> surfels_;
  std::vector<MirrorPlane> mirrors_;
  bool is_grey_ = true;
};

// The occlusion of the levels of a grid, kept while surfaces and nodes stay.
class LevelOcclusion {
 public:
  // Both must outlive this, until the next call.
  void set(const RayCaster& ray_caster, std::span<const Surface> surfaces);
  [[nodiscard]] const RayCaster& ray_caster() const { return *ray_caster_; }
  [[nodiscard]] const Box& bounds() const { return ray_caster_->bounds(); }
  // Whether surfaces hide what is far away from a point. Thread-safe.
  [[nodiscard]] bool hide(const glm::dvec3& point, const glm::dvec3& direction) const {
    return ray_caster_->transmittance(point, direction, infinity) < 0.5;
  }
  [[nodiscard]] const AxisPlanes& planes() const { return planes_; }
  [[nodiscard]] Revision revision() const { return revision_; }
  std::shared_ptr<const GridOcclusion> at(std::size_t level, const glm::dvec3& first,
                                          const GridNodes& nodes, const Job& job);

 private:
  struct Cached {
    Revision surfaces = 0;
    glm::dvec3 first{0.0};
    GridNodes nodes;
    std::shared_ptr<const GridOcclusion> occlusion;
  };
  const RayCaster* ray_caster_ = nullptr;
  std::span<const Surface> surfaces_;
  Revision ray_caster_revision_ = 0;
  AxisPlanes planes_;
  std::vector<Material> materials_;
  std::vector<MirrorPlane> mirrors_;
  Revision revision_ = 0;  // of geometry and materials
  // Per level: in use, and the one before, for frames in motion and at rest take turns.
  std::vector<std::array<Cached, 2>> cached_;
};

}  // namespace brume
