#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/transport/optical_depth.h"
#include "render/cpu/sweep_kernels.h"
#include "render/job.h"

namespace brume {

// The density of Gaussians [1/u] at the nodes of a grid whose first stands at `first`. A Gaussian
// whose radius is below the spacing is widened to it with all it holds, so that none is missed
// between nodes. In parallel, until the job is stopped.
std::vector<float> density_on_grid(std::span<const GaussianTerm<double>> gaussians,
                                   const glm::dvec3& first, const GridNodes& nodes, const Job& job);

}  // namespace brume
