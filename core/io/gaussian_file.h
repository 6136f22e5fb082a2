#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/medium/gaussian.h"

namespace brume {

// Gaussians as PLY points: per vertex x y z radius density; ascii or binary of either byte order,
// other properties and elements are skipped. Throws InputError naming file and vertex.
std::vector<Gaussian> read_gaussians(const std::filesystem::path& file);

// Writes binary little-endian PLY in double precision: what is read back is the same.
void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians);

}  // namespace brume
