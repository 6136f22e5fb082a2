#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace brume {

// Where files are that are not where a scene refers to them.
using FoundFiles = std::map<std::filesystem::path, std::filesystem::path>;

// The files that a scene refers to and that are not there. Paths are absolute; of a sequence it is
// the pattern of its names.
struct MissingFiles {
  FoundFiles found;                            // of those, where they are now
  std::vector<std::filesystem::path> missing;  // the others
};

// As load_scene(), but goes on where files are missing: reads those of `missing.found` from there,
// and adds the others to `missing.missing`. A surface is one triangle without area, Gaussians and
// those of a sequence are none, an environment is black, a measured material is gray. All
// references stay, so that nothing is lost when the scene is saved.
Scene load_scene(const std::filesystem::path& file, std::vector<std::string>* warnings,
                 MissingFiles& missing);

}  // namespace brume
