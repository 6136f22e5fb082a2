#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brume/density_grid.h"
#include "brume/export.h"
#include "brume/frame.h"
#include "brume/gaussian.h"
#include "brume/scene.h"
#include "brume/splat.h"

// Files in and out. All functions throw InputError, which names the file, the place in it and what
// is allowed. An existing file is replaced only by a complete one.
namespace brume {

// A scene file, version 1 (.brume), with all files that it refers to. Unknown keys and keys without
// effect are appended to `warnings`, a line each.
BRUME_EXPORT Scene load_scene(const std::filesystem::path& file,
                              std::vector<std::string>* warnings = nullptr);
// Writes a scene losslessly, with its Gaussians' ids; references become relative to the new file if
// possible. Throws DomainError, too.
BRUME_EXPORT void save_scene(const Scene& scene, const std::filesystem::path& file);

// The same with what a file has besides its scene: keys that Brume does not know, which are kept
// when it is saved, wherever their objects have moved, and the file of its Gaussians.
struct SceneExtras;
struct SceneFile {
  Scene scene{};
  std::shared_ptr<const SceneExtras> extras{};  // null: none
};
BRUME_EXPORT SceneFile load_scene_file(const std::filesystem::path& file,
                                       std::vector<std::string>* warnings = nullptr);
BRUME_EXPORT void save_scene_file(const SceneFile& scene, const std::filesystem::path& file);

// Gaussians in PLY or CSV: read by the first bytes, written by the extension, losslessly. What
// Gaussian splatting stores, PLY and glTF (KHR_gaussian_splatting), is read as well, and written
// for the extensions .glb and .gltf, as opaque as the Gaussians along the mean radius. Splats with
// numbers that no Gaussian has are left out if they are less than half; `warnings` gets their
// number and the first place. `ids` are those of the column or property `id`; empty where a file
// has none, as glTF. As many as Gaussians are written, none by default.
BRUME_EXPORT std::vector<Gaussian> load_gaussians(const std::filesystem::path& file,
                                                  const SplatInput& splats = {},
                                                  std::vector<std::string>* warnings = nullptr,
                                                  std::vector<GaussianNumber>* ids = nullptr);
BRUME_EXPORT void save_gaussians(std::span<const Gaussian> gaussians,
                                 const std::filesystem::path& file,
                                 std::span<const GaussianNumber> ids = {});

// Surfaces and lights that a file makes, to be placed in a scene: a mesh (OBJ, PLY, STL, OFF), and
// an environment map (EXR, HDR). A mesh whose vertices have colors gets a metallic-roughness
// material that shows them. What is left out or taken otherwise than the file says is appended to
// `warnings`, a line each.
BRUME_EXPORT Surface load_surface(const std::filesystem::path& mesh,
                                  std::vector<std::string>* warnings = nullptr);
// Placements of copies of a surface: PLY or CSV, see the manual.
BRUME_EXPORT Copies load_copies(const std::filesystem::path& file,
                                std::vector<std::string>* warnings = nullptr);
BRUME_EXPORT Environment load_environment(const std::filesystem::path& map,
                                          std::vector<std::string>* warnings = nullptr);

// A grid of an OpenVDB file as density, to be fitted; of several grids of the name their sum.
// `warnings` gets that the file's version of the format is newer than those known.
BRUME_EXPORT DensityGrid load_volume(const std::filesystem::path& file,
                                     const std::string& grid = "density",
                                     std::vector<std::string>* warnings = nullptr);
// The density of the Gaussians of a medium on a grid, sparse; voxel_size > 0 [u].
BRUME_EXPORT void save_volume(const Medium& medium, double voxel_size,
                              const std::filesystem::path& file);

// A frame as .exr, linear with all its layers, or as .png, exposed by so many stops.
BRUME_EXPORT void save_frame(const Frame& frame, const std::filesystem::path& file,
                             double exposure = 0.0);
// The bytes of that .png.
BRUME_EXPORT std::string encode_png(const Frame& frame, double exposure = 0.0);

}  // namespace brume
