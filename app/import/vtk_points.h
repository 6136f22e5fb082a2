#pragma once

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <vector>

#include "brume/gaussian.h"
#include "brume/limits.h"

namespace brume {

// Reads the points of a VTK file (.vtp: polygonal data, .vtu: an unstructured grid) as Gaussians.
// The point arrays `radius` and `density`, one number each, give theirs; where there is none, a
// density is 1 and a radius the edge of the cube that a point would have in the box around all.
// `ids` gets the point array `id`, where there is one: what Gaussians of a sequence keep from frame
// to frame. Throws InputError naming file and point, also for more than `max_count`.
//
// The file is read by a process of its own (brume-vtk-points, installed with the editor), whose
// memory and time depend on the file's size. Gives nothing when it is stopped.
std::vector<Gaussian> read_vtk_points(const std::filesystem::path& file,
                                      std::vector<GaussianNumber>* ids = nullptr,
                                      std::size_t max_count = limits::gaussians,
                                      const std::stop_token& stop = {});

}  // namespace brume
