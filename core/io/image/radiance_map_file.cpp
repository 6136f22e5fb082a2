#include "core/io/image/radiance_map_file.h"

#include <algorithm>
#include <array>

#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/file_bytes.h"
#include "core/io/image/hdr_file.h"
#include "core/io/image/image_file.h"
#include "core/number_domain.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

RadianceMap from_exr(const fs::path& file) {
  const ImageLayers image = read_exr(file);
  RadianceMap map{image.width, image.height, {}};
  map.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  int component = 0;
  for (const char* name : {"R", "G", "B"}) {
    const auto channel = image.channels.find(name);
    if (channel == image.channels.end()) {
      throw InputError(file, "header", std::string("there is no channel ") + name);
    }
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
      map.pixels[i][component] = channel->second[i];
    }
    ++component;
  }
  return map;
}

void check(const fs::path& file, RadianceMap& map) {
  const auto max_radiance = static_cast<float>(limits::intensity);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      float& value = map.pixels[i][c];
      if (value <= max_radiance && value >= -max_radiance) {
        value = std::max(value, 0.0f);
        continue;
      }
      const auto width = static_cast<std::size_t>(map.width);
      throw InputError(
          file, "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")",
          "found " + quoted_text(static_cast<double>(value)) +
              "; allowed: a finite radiance up to 1e20");
    }
  }
}

}  // namespace

std::shared_ptr<const RadianceMap> read_radiance_map(const fs::path& file) {
  const bool is_hdr = read_first_bytes(file, 2) == "#?";
  if (!is_hdr && !is_exr(file)) {
    throw InputError(file, "header", "found neither an OpenEXR nor a Radiance HDR image");
  }
  auto map = std::make_shared<RadianceMap>(is_hdr ? read_hdr(file) : from_exr(file));
  check(file, *map);
  return map;
}

}  // namespace brume
