#include "app/import/import_kind.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/ply.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 2> tables{".csv", ".ply"};
constexpr std::array<std::string_view, 2> vtk_files{".vtp", ".vtu"};
constexpr std::array<std::string_view, 3> meshes{".obj", ".stl", ".off"};
constexpr std::array<std::string_view, 3> scenes{".gltf", ".glb", ".fbx"};
constexpr std::array<std::string_view, 2> environments{".exr", ".hdr"};
// These are not read; the refusal says what to do with them.
constexpr std::array<std::string_view, 4> compressed_splats{".spz", ".sog", ".splat", ".ksplat"};

bool is_one_of(const fs::path& file, const auto& extensions) {
  return std::ranges::find(extensions, lower_case_extension(file)) != extensions.end();
}

bool has_faces(const fs::path& file) {
  const std::string bytes = read_bytes(file);
  return std::ranges::any_of(PlyFile(file, bytes).elements(), [](const PlyFile::Element& element) {
    return (element.name == "face" || element.name == "tristrips") && element.count > 0;
  });
}

}  // namespace

ImportKind import_kind_of(const fs::path& file) {
  const std::string extension = lower_case_extension(file);
  const bool is_ply = extension == ".ply";
  if (is_one_of(file, environments)) return ImportKind::environment;
  if ((is_ply || extension == ".gltf" || extension == ".glb") && has_splats(file)) {
    return ImportKind::splats;
  }
  if (is_one_of(file, scenes)) return ImportKind::scene;
  if (extension == ".obj" && obj_has_materials(file)) return ImportKind::scene;
  const bool is_mesh = is_ply ? has_faces(file) : is_one_of(file, meshes);
  return is_mesh ? ImportKind::mesh : ImportKind::gaussians;
}

bool is_volume(const fs::path& file) {
  return lower_case_extension(file) == ".vdb";
}

bool is_vtk_file(const fs::path& file) {
  return is_one_of(file, vtk_files);
}

bool is_scene_file(const fs::path& file) {
  return is_one_of(file, scenes);
}

bool may_be_frame(const fs::path& file) {
  return is_volume(file) || is_one_of(file, tables) || is_vtk_file(file);
}

bool can_import(const fs::path& file) {
  return is_volume(file) || is_one_of(file, tables) || is_vtk_file(file) ||
         is_one_of(file, meshes) || is_scene_file(file) || is_one_of(file, environments) ||
         is_one_of(file, compressed_splats);
}

}  // namespace brume
