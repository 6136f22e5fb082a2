#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/camera.h"

namespace brume {

// What another program takes for the airlight of a scene, as tools/compare-peers measures it.
struct PeerRow {
  std::string scene;
  Film film;
  std::string program;  // "POV-Ray"
  std::string setting;  // "8 intervals"
  double cpu_milliseconds = 0.0;
  double rel_rmse = 0.0;  // against Brume's reference
};

// Throws InputError if the file is not what tools/compare-peers writes.
std::vector<PeerRow> read_peers(const std::filesystem::path& file);

// The rows of one scene and film.
std::vector<PeerRow> peers_of(const std::vector<PeerRow>& peers, const std::string& scene,
                              const Film& film);

}  // namespace brume
