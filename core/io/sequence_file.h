#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "core/io/frame_pattern.h"
#include "core/io/gaussian_file.h"
#include "core/scene/medium_sequence.h"

namespace brume {

// Reads the Gaussians of one frame's file, and their numbers where it has them; throws where they
// are more than `max_count`.
using FrameReader = std::function<std::vector<Gaussian>(
    const std::filesystem::path& file, std::vector<GaussianNumber>* ids, std::size_t max_count)>;

// Reads one file of Gaussians per frame, with the number of each in its column `id`; where files
// have none, Gaussians of the same line are the same. Throws InputError naming file and place: also
// for an id twice in a file, and for more than `max_count` in all.
std::vector<SequenceFrame> read_sequence(const FramePattern& files, int first, int last,
                                         const FrameReader& read = read_gaussians,
                                         std::size_t max_count = limits::gaussians);

}  // namespace brume
