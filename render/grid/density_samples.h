#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"
#include "render/grid/sweep_kernels.h"
#include "render/util/job.h"

namespace brume {

// Density of Gaussians [1/u] at the nodes of a grid, `first` being node 0. Gaussians smaller than
// the spacing are widened to it, preserving their mass, so that none falls between nodes. In
// parallel.
std::vector<float> density_on_grid(std::span<const GaussianTerm<double>> gaussians,
                                   const glm::dvec3& first, const GridNodes& nodes, const Job& job);

}  // namespace brume
