#pragma once

#include <vector>

#include "brume/camera.h"
#include "brume/density_grid.h"
#include "brume/scene.h"

namespace brume {

// Pictures of a volume itself, to hold pictures of fitted Gaussians against: the radiance that
// it scatters once, isotropically, from a point light to the eye, through itself both ways, by the
// midpoint rule along rays with steps of half a voxel; red only, rows from the top. The density is
// linear between voxels.
std::vector<float> grid_picture(const DensityGrid& grid, const Camera& camera, const Film& film,
                                const Light& light);

}  // namespace brume
