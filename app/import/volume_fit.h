#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "brume/medium_sequence.h"
#include "core/fit/volume_fitter.h"
#include "render/util/job.h"

namespace brume {

// nullopt when it was stopped. Throws InputError.
std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job);

// Fits a sequence, each frame starting from the previous. Fewer results than `files` if stopped.
std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job);

}  // namespace brume
