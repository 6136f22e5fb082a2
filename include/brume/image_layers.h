#pragma once

#include <map>
#include <string>
#include <vector>

namespace brume {

// An image of named float channels ("R", "airlight.G", "Z"), each width * height values, rows
// from the top, plus text metadata.
struct ImageLayers {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<float>> channels;
  std::map<std::string, std::string> metadata;
};

}  // namespace brume
