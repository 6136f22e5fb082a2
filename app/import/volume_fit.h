#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/commands/gaussians/operation_numbers.h"
#include "brume/medium_sequence.h"
#include "core/fit/volume_fitter.h"
#include "render/util/job.h"

class QObject;

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
  std::vector<Gaussian> gaussians;  // before they are placed
  ImportPlacement placement;
  std::vector<GaussianId> ids;  // in the document; none until it is shown
  std::vector<Gaussian> added;  // as they were in the document at first
  bool is_last_operation = false;
};

// Adds it as the last operation, whose numbers can be adjusted while the volume is fitted. Nothing
// is added if there is no room.
void show_preview(Document& document, const std::shared_ptr<VolumePreview>& preview);

// Calls `gone` when a preview that was shown is there no more, or another scene is. `receiver`: as
// long as it lives.
void follow_preview(Document& document, const std::shared_ptr<VolumePreview>& preview,
                    QObject* receiver, const std::function<void()>& gone);

// Puts other Gaussians in its place: within its undo step if nothing else was done since, else as
// one of their own. False: nothing is done because the preview was edited, hidden or locked.
bool refine_preview(Document& document, VolumePreview& preview,
                    const std::vector<Gaussian>& gaussians);

}  // namespace brume
