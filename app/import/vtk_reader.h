#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// What read_vtk_points() (app/import/vtk_points.h) has done in a process of its own. VTK trusts
// what it reads: on a damaged file it may crash, or take all memory there is. Throws InputError
// naming file and point.
std::vector<Gaussian> read_points_with_vtk(const std::filesystem::path& file,
                                           std::vector<GaussianNumber>* ids, std::size_t max_count);

}  // namespace brume
