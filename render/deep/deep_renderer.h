#pragma once

#include <cstddef>
#include <optional>

#include "brume/scene.h"
#include "core/io/image/deep_exr_file.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"
#include "render/util/job.h"

namespace brume {

// How a deep frame is made, on the CPU, by slices (AirlightMethod::sliced, at every pixel).
struct DeepSettings {
  Settings settings;
  // Held out at any distance, no pixel's alpha is off by more than this, nor its airlight by more
  // than this share of its own, or of `airlight_rms` if that is more; (0, 1].
  double error = 0.01;
  double airlight_rms = 0.0;  // of the whole picture
};

struct DeepStatistics {
  std::size_t pixels = 0;
  std::size_t samples = 0;
  std::size_t max_samples = 0;   // of a pixel
  std::size_t coarse_tiles = 0;  // whose slices cannot be made fine enough for the error
};

// Whether channels differ in what the fog does to them: see DeepExrHeader.
bool has_colored_alpha(const Scene& scene);

// A distance at which what is seen behind everything stands, a sample without alpha [u].
inline constexpr float deep_background = 1e30f;

// Renders the scene as samples and hands them on a row of tiles after the other, so that memory is
// that of a flat frame. Samples of fog are volumes, of surfaces points; flattened they are the flat
// frame of the same settings to the rounding of slices. `transfers`: see Renderer. nullopt if
// stopped.
std::optional<DeepStatistics> render_deep(const Scene& scene, const Camera& camera,
                                          const Film& film, const DeepSettings& deep,
                                          const TransferStore& transfers, const TakeDeepRows& take,
                                          const Job& job = {});

}  // namespace brume
