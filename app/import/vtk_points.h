#pragma once

#include <filesystem>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// Reads the points of a VTK file (.vtp: polygonal data, .vtu: an unstructured grid) as Gaussians.
// The point arrays `radius` and `density`, one number each, give theirs; where there is none, a
// density is 1 and a radius the edge of the cube that a point would have in the box around all.
// `ids` gets the point array `id`, where there is one: what Gaussians of a sequence keep from frame
// to frame. Throws InputError naming file and point.
std::vector<Gaussian> read_vtk_points(const std::filesystem::path& file,
                                      std::vector<GaussianNumber>* ids = nullptr);

}  // namespace brume
