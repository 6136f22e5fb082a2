#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "core/io/limits.h"
#include "core/medium/gaussian.h"

namespace brume {

// Gaussians in a file of either format (gaussian_ply.h, gaussian_csv.h), told by its first bytes.
// Throws InputError naming file and place. `ids` gets what Gaussians of a sequence keep from frame
// to frame, where the file has it. More than `max_count` are refused.
std::vector<Gaussian> read_gaussians(const std::filesystem::path& file,
                                     std::vector<GaussianNumber>* ids = nullptr,
                                     std::size_t max_count = limits::gaussians);

// As a table where the file is called .csv, else as PLY: what is read back is the same.
void write_gaussians(const std::filesystem::path& file, std::span<const Gaussian> gaussians,
                     std::span<const GaussianNumber> ids = {});

}  // namespace brume
