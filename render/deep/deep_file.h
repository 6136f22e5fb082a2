#pragma once

#include <filesystem>
#include <optional>

#include "brume/frame.h"
#include "render/deep/deep_renderer.h"
#include "render/frame_renderer.h"
#include "render/output/frame_file.h"

namespace brume {

struct DeepFileStatistics {
  DeepStatistics image;
  std::uintmax_t bytes = 0;
  double milliseconds = 0.0;
};

// The settings of a deep frame from those of a flat one. nullopt if stopped.
std::optional<DeepSettings> deep_settings(FrameRenderer& renderer, const Scene& scene,
                                          const Camera& camera, const Film& film,
                                          const Settings& settings, double error,
                                          const Job& job = {});

// Renders the deep file of a frame of the scene at its time, with the same metadata. nullopt, and
// the file as it was, if stopped. Throws InputError.
std::optional<DeepFileStatistics> write_deep_frame(const std::filesystem::path& file,
                                                   const Scene& scene, const Frame& frame,
                                                   const FrameInfo& info, const DeepSettings& deep,
                                                   const TransferStore& transfers,
                                                   const Job& job = {});

}  // namespace brume
