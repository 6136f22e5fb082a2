#include "brume/files.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "brume/error.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/io/copies_file.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_file.h"
#include "core/number_domain.h"
#include "core/volume/medium_grid.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

fs::path absolute_name(const fs::path& file) {
  std::error_code error;
  fs::path path = fs::absolute(file, error);
  if (error || file.empty()) throw InputError(file, "", "allowed: the name of a file");
  return path;
}

}  // namespace

SceneFile load_scene_file(const fs::path& file, std::vector<std::string>* warnings) {
  SceneDocument document = load_document(file, warnings);
  return {std::move(document.scene),
          std::make_shared<const SceneExtras>(std::move(document.extras))};
}

void save_scene_file(const SceneFile& scene, const fs::path& file) {
  check(scene.scene);
  for (std::size_t i = 0; i < scene.scene.surfaces.size(); ++i) {
    const Surface& surface = scene.scene.surfaces[i];
    if (!surface.primitive && surface.mesh_file.empty()) {
      throw DomainError("surfaces[" + std::to_string(i) + "].mesh",
                        "it is in memory alone; allowed in a file: a primitive, or of a mesh_file");
    }
    if (surface.copies && surface.copies->placements && surface.copies->file.empty()) {
      throw DomainError(
          "surfaces[" + std::to_string(i) + "].copies",
          "they are in memory alone; allowed in a file: those of a file, or scattered");
    }
  }
  save_document({scene.scene, scene.extras ? *scene.extras : SceneExtras{}}, absolute_name(file));
}

void save_scene(const Scene& scene, const fs::path& file) {
  save_scene_file({scene, nullptr}, file);
}

std::vector<Gaussian> load_gaussians(const fs::path& file, const SplatInput& splats,
                                     std::vector<std::string>* warnings,
                                     std::vector<GaussianNumber>* ids) {
  if (ids) return read_with_ids(file, *ids, splats, warnings);
  return read_gaussians(file, nullptr, limits::gaussians, splats, warnings);
}

void save_gaussians(std::span<const Gaussian> gaussians, const fs::path& file,
                    std::span<const GaussianNumber> ids) {
  if (!ids.empty() && ids.size() != gaussians.size()) {
    throw DomainError("ids", "found " + std::to_string(ids.size()) + " for " +
                                 std::to_string(gaussians.size()) +
                                 " Gaussians; allowed: one each");
  }
  write_gaussians(file, gaussians, ids);
}

Surface load_surface(const fs::path& mesh, std::vector<std::string>* warnings) {
  Surface surface;
  surface.mesh_file = absolute_name(mesh);
  surface.mesh = read_mesh(mesh, warnings);
  if (!to_arrays(*surface.mesh).colors.empty()) {
    surface.material.type = Material::Type::metallic_roughness;
    surface.material.metallic_roughness.metallic = 0.0;
  }
  return surface;
}

Copies load_copies(const fs::path& file, std::vector<std::string>* warnings) {
  return {absolute_name(file),
          std::make_shared<const CopyPlacements>(read_copies(file, limits::copies, warnings))};
}

Environment load_environment(const fs::path& map, std::vector<std::string>* warnings) {
  return {absolute_name(map), read_radiance_map(map, warnings)};
}

DensityGrid load_volume(const fs::path& file, const std::string& grid,
                        std::vector<std::string>* warnings) {
  DensityGrid volume = read_volume(file, grid);
  if (warnings) std::ranges::copy(volume_warnings(file), std::back_inserter(*warnings));
  return volume;
}

void save_volume(const Medium& medium, double voxel_size, const fs::path& file) {
  constexpr std::size_t max_blocks = (std::size_t{2} << 30) / sizeof(DensityGrid::Block);
  check(medium);
  if (!domain::length.contains(voxel_size)) {
    throw DomainError("voxel_size", domain::length.refusal(voxel_size));
  }
  const auto sampling = MediumSampling::plan(medium, voxel_size, max_blocks);
  if (!sampling) {
    throw DomainError("voxel_size", "the grid would take more than 2 GiB; allowed: a larger one");
  }
  write_volume(file, *sampling->sample(), false);
}

}  // namespace brume
