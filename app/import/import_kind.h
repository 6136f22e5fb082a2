#pragma once

#include <cstdint>
#include <filesystem>

namespace brume {

// The kinds of files that are imported and are no volumes.
enum class ImportKind : std::uint8_t { gaussians, splats, scene, mesh, environment };

// The extension tells, or the content where it may be either. Throws if that cannot be read.
ImportKind import_kind_of(const std::filesystem::path& file);

// The extensions tell.
bool can_import(const std::filesystem::path& file);
bool is_volume(const std::filesystem::path& file);
bool is_vtk_file(const std::filesystem::path& file);
bool is_scene_file(const std::filesystem::path& file);
bool may_be_frame(const std::filesystem::path& file);  // of a sequence

}  // namespace brume
