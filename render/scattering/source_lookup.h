#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/scattering/grid_levels.h"
#include "render/simd/gaussian_kernels.h"

namespace brume {

// Weights of a view ray for a node's values: J is their weighted sum.
struct SourceWeights {
  std::array<float, 4 * sh_size(PhaseBands::max_bands)> harmonics{};  // per basis function R G B 0
  // Forward-lobe scattering of the clusters that are attenuated as nodes hold it.
  std::array<glm::vec3, source_clusters> at_nodes{};
  // Not part of J: that of the others.
  std::array<glm::vec3, source_clusters> on_rays{};
};

// From this distance on [spacings], the directions to a cell's nodes hardly differ: airlight is
// within 0.2% of the sum of all that nodes hold; from 8 on it would be 0.6% off.
inline constexpr float min_view_spacings = 16.0f;

// Look-ups in a SourceGrid relative to an origin (Highway, single precision). Keeps a reference to
// the grid.
class SourceLookup {
 public:
  // `adds_clusters`: whether any SourceWeights::at_nodes are not 0. `visibility`: of the eye.
  SourceLookup(const SourceGrid& grid, const glm::dvec3& origin, bool adds_clusters = false,
               const NodeVisibility& visibility = {});

  // What the harmonics of each level's nodes sum to, R G B 0; see SourceView.
  // Keeps a reference.
  void set_view(std::span<const std::vector<float>> levels, bool is_parallel);

  // Floats per ray of what add() sums: of J, and of what nodes hold.
  [[nodiscard]] std::size_t sums_size() const {
    return view_size() + (sums_nodes_ ? SourceGrid::node_size(bands_) : 0);
  }
  // Adds weights[k] times the nodes' values at distance t[k] on ray k, clamped to the grid, for
  // padded_size() rays from the origin; of nodes that surfaces hide from the origin's side,
  // nothing. Those of clusters times lobe_weights[k]. No weight costs nothing. Whether it has
  // summed what nodes hold, for which source() needs weights. Thread-safe.
  bool add(const PathBatch& rays, const float* t, const float* weights, const float* lobe_weights,
           float* sums) const;
  // What add() has summed for a ray, as J.
  [[nodiscard]] glm::vec3 source(std::span<const float> sums, const SourceWeights& weights) const;

  // Transmittance towards each cluster at the origin, for grids of more than one band; 1 outside
  // the grid. Thread-safe.
  using ClusterTransmittance = std::array<float, source_clusters>;
  [[nodiscard]] ClusterTransmittance cluster_transmittance() const;

 private:
  [[nodiscard]] std::size_t view_size() const { return levels_.all()[0].view ? 4 : 0; }

  GridLevels levels_;
  int bands_;
  bool adds_clusters_;
  bool sums_nodes_ = true;
};

}  // namespace brume
