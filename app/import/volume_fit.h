#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/gaussian_fit.h"
#include "core/scene/medium_sequence.h"
#include "render/job.h"

namespace brume {

// How a volume becomes Gaussians.
struct VolumeFit {
  std::string grid = "density";
  FitOptions options;
  double density_scale = 1.0;  // what a density of 1 scatters [1/u]
  bool z_up = false;           // z is turned to y
};

// nullopt when it was stopped. Throws InputError.
std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job);

// The same of a sequence, each frame from the one before. As many as `files`, fewer when stopped.
std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job);

}  // namespace brume
