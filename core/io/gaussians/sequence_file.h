#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "brume/limits.h"
#include "brume/medium_sequence.h"
#include "core/io/frame_pattern.h"
#include "core/io/gaussians/gaussian_file.h"

namespace brume {

// Reads one frame's Gaussians and their ids, if present; throws beyond `max_count`. `warnings` may
// be null.
using FrameReader = std::function<std::vector<Gaussian>(
    const std::filesystem::path& file, std::vector<GaussianNumber>* ids, std::size_t max_count,
    std::vector<std::string>* warnings)>;

// read_gaussians() of any splats as opaque as stored along their mean radius.
inline std::vector<Gaussian> read_gaussian_frame(const std::filesystem::path& file,
                                                 std::vector<GaussianNumber>* ids,
                                                 std::size_t max_count,
                                                 std::vector<std::string>* warnings) {
  return read_gaussians(file, ids, max_count, {}, warnings);
}

// Reads one file of Gaussians per frame, with ids from the column `id`; without it the line number
// identifies a Gaussian. Throws InputError naming file and place, also for duplicate ids and for
// more than `max_count` in all. Warnings of `read` are appended to `warnings`.
std::vector<SequenceFrame> read_sequence(const FramePattern& files, int first, int last,
                                         const FrameReader& read = read_gaussian_frame,
                                         std::size_t max_count = limits::gaussians,
                                         std::vector<std::string>* warnings = nullptr);

// The frames of such files: read at once where they have at most `max_in_memory` Gaussians in all,
// else when they are asked for. `max_count` is then for any moment, and there are only warnings of
// the first frame.
std::shared_ptr<const SequenceFrames> open_sequence(const FramePattern& files, int first, int last,
                                                    const FrameReader& read = read_gaussian_frame,
                                                    std::size_t max_count = limits::gaussians,
                                                    std::vector<std::string>* warnings = nullptr,
                                                    std::size_t max_in_memory = 2'000'000);

}  // namespace brume
