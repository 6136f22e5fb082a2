#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/commands/operation_numbers.h"
#include "brume/medium_sequence.h"
#include "core/fit/volume_fitter.h"
#include "render/util/job.h"

namespace brume {

class Document;

// nullopt when it was stopped. Throws InputError.
std::optional<std::vector<Gaussian>> fit_volume(const std::filesystem::path& file,
                                                const VolumeFit& how, const Job& job);

// Fits a sequence, each frame starting from the previous. Fewer results than `files` if stopped.
std::vector<SequenceFrame> fit_volumes(const std::vector<std::filesystem::path>& files,
                                       const VolumeFit& how, const Job& job);

// A volume that is in the document as it was fitted first, until it is as was asked for.
struct VolumePreview {
  explicit VolumePreview(std::vector<Gaussian> fitted) : gaussians(std::move(fitted)) {}

  std::vector<Gaussian> gaussians;
  ImportPlacement placement;
  std::vector<GaussianId> ids;
  bool is_last_operation = true;
};

// Adds it as the last operation, whose numbers can be adjusted while the volume is fitted.
void show_preview(Document& document, const std::shared_ptr<VolumePreview>& preview);

// Puts other Gaussians in its place: within its undo step if nothing else was done since, else as
// one of their own. Nothing is done if it is gone.
void refine_preview(Document& document, VolumePreview& preview,
                    const std::vector<Gaussian>& gaussians);

}  // namespace brume
