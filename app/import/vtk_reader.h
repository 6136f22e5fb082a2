#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "brume/gaussian.h"

namespace brume {

// The part of read_vtk_points() (app/import/vtk_points.h) that runs in its own process: VTK trusts
// its input and may crash or exhaust memory on damaged files. Throws InputError naming file and
// point.
std::vector<Gaussian> read_points_with_vtk(const std::filesystem::path& file,
                                           std::vector<GaussianNumber>* ids, std::size_t max_count);

}  // namespace brume
