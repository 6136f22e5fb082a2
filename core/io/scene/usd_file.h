#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "brume/density_grid.h"
#include "brume/scene.h"
#include "brume/splat.h"

namespace brume {

// Scenes as USD's text (.usda), for other programs.

// A moment of a scene.
struct UsdFrame {
  std::optional<int> frame{};    // the time code; absent: of a moment alone, which has none
  Scene scene;                   // as evaluate_at() makes it
  std::filesystem::path volume;  // OpenVDB file of its medium as the stage names it; empty: none
  bool has_albedo = false;       // grids of the volume besides density
  bool has_emission = false;
  std::vector<Gaussian> splats{};  // of the medium; in no frame: none are written
};

// The OpenVDB file beside a stage: NAME_fog.vdb, of a frame NAME_fog_0001.vdb.
std::filesystem::path volume_of_stage(const std::filesystem::path& stage,
                                      std::optional<int> frame = {});
// Has a volume stand for the medium but for its homogeneous density.
void replace_medium(UsdFrame& frame, const std::filesystem::path& volume,
                    const VolumeColors& colors);

// Writes a stage: the camera, lights (UsdLux), the environment (DomeLight), surfaces as meshes with
// UsdPreviewSurface and their textures, and the medium as a Volume of OpenVDB assets; as splats
// too, if frames have them: a ParticleField3DGaussianSplat (OpenUSD 26.03), for views (purpose
// proxy), while the Volume is then for renders. Textures within another file become
// NAME_texture_1.png and so on, beside it. One unit of the scene is a meter; y is up. What differs
// between frames, or might where there is a time code alone, gets time samples. What USD has no
// words for is in attributes `brume:...`. Frames ascend, at least one, and are of one scene: they
// have the same lights and surfaces. `add_output` is told of each texture before it is written, and
// may throw. Throws InputError if a file cannot be written.
using AddOutput = std::function<void(const std::filesystem::path& file)>;
void write_usd(const std::filesystem::path& file, std::span<const UsdFrame> frames,
               double frames_per_second, OpacityAlong along = OpacityAlong::mean,
               const AddOutput& add_output = {});

}  // namespace brume
