#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/fit/volume_fitter.h"
#include "core/scene/medium_sequence.h"
#include "render/job.h"

namespace brume {

// nullopt when it was stopped. Throws InputError.
std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job);

// The same of a sequence, each frame from the one before. As many as `files`, fewer when stopped.
std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job);

}  // namespace brume
