#pragma once

#include <QString>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace brume {

// Files of the asset library. Meshes, Gaussians and volumes are as they are imported; what the
// editor saves are scene files by the names mist.fog.brume, key.light.brume, wide.camera.brume and
// chair.surface.brume, and files of brushes by soft.brush.json. Any other scene file is one, too.
enum class AssetKind : std::uint8_t { surface, fog, light, camera, brush, scene };

// Nullopt for other files. Content is looked at only where the name leaves it open; throws if that
// cannot be read.
std::optional<AssetKind> asset_kind(const std::filesystem::path& file);

// "mist" of mist.fog.brume, "chair" of chair.glb.
QString asset_name(const std::filesystem::path& file);

// The end of the names of files that the editor saves: ".fog.brume". Not of whole scenes.
std::string asset_extension(AssetKind kind);
// A file name with that end, which is appended where it is missing: "mist v1.2.fog.brume".
std::filesystem::path asset_file(std::filesystem::path file, AssetKind kind);

// Assets of the user, in the application's data; and of a scene, in its folder.
std::filesystem::path user_asset_folder();
std::filesystem::path scene_asset_folder(const std::filesystem::path& scene);

}  // namespace brume
