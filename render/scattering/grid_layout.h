#pragma once

#include <span>
#include <vector>

#include "core/medium/gaussian_term.h"
#include "render/geometry/box.h"
#include "render/grid/node_layout.h"
#include "render/scattering/source_grid.h"
#include "render/settings.h"

namespace brume {

// Where the levels of a SourceGrid have their nodes, at least one and at most max_levels, fine
// first: around the Gaussians, and around the fog that needs fine nodes. Further, coarser levels
// cover several times the extent of the one before: as many as reach the end of the fog, or mean
// free paths if it has none.
struct GridLayout {
  Box core;  // bounds of the first level; low > high without a medium
  std::vector<NodeLayout> levels;
};
GridLayout lay_out_levels(std::span<const GaussianTerm<double>> gaussians,
                          const SourceGrid::Content& content, const SourceGridSize& size);

}  // namespace brume
