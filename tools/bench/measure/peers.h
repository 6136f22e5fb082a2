#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brume/camera.h"

namespace brume {

// Time of another renderer for the airlight of a scene, measured by tools/compare-peers.
struct OtherRendererRow {
  std::string scene;
  Film film;
  std::string program;  // "POV-Ray"
  std::string setting;  // "8 intervals"
  double cpu_milliseconds = 0.0;
  double rel_rmse = 0.0;  // against Brume's reference
};

// Throws InputError if the file is not what tools/compare-peers writes.
std::vector<OtherRendererRow> read_other_renderers(const std::filesystem::path& file);

// The rows of one scene and film.
std::vector<OtherRendererRow> other_renderers_of(const std::vector<OtherRendererRow>& peers,
                                                 const std::string& scene, const Film& film);

}  // namespace brume
