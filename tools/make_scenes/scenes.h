#pragma once

#include <filesystem>

namespace brume {

// Each writes scene files, and the generated files they refer to, into a folder. Bunny and teapot
// are expected in ../meshes, environments in ../environments, seen from there.

// bunny_fog, teapot_steam, light_inside, camera_inside, evening_mist, stage.
void write_object_scenes(const std::filesystem::path& folder);

// box_3008 and dense_cloud.
void write_cloud_scenes(const std::filesystem::path& folder);

// ground_fog.
void write_terrain_scene(const std::filesystem::path& folder);

// courtyard.
void write_courtyard_scene(const std::filesystem::path& folder);

// forest.
void write_forest_scene(const std::filesystem::path& folder);

// headlights.
void write_headlights_scene(const std::filesystem::path& folder);

// candle.
void write_candle_scene(const std::filesystem::path& folder);

// harbour.
void write_harbour_scene(const std::filesystem::path& folder);

// room and tunnel.
void write_interior_scenes(const std::filesystem::path& folder);

// The templates of the editor's start page: room, landscape, stage and street.
void write_template_scenes(const std::filesystem::path& folder);

}  // namespace brume
