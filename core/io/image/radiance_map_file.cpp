#include "core/io/image/radiance_map_file.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/exr_picture.h"
#include "core/io/image/hdr_file.h"
#include "core/io/image/image_file.h"
#include "core/number_domain.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr float max_half = 65504.0f;

std::string place_of(const glm::ivec2& pixel) {
  return "pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
}

// Half floats have no brighter sun than infinity, and filters make NaN of it.
void make_finite(const fs::path& file, ExrPicture& picture, std::vector<std::string>* warnings) {
  std::size_t count = 0;
  std::size_t first = 0;
  float max_value = max_half;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float value = picture.pixels[i][c];
      if (std::isfinite(value)) {
        max_value = std::max(max_value, value);
      } else if (count++ == 0) {
        first = i;
      }
    }
  }
  if (count == 0) return;
  for (glm::vec3& pixel : picture.pixels) {
    for (int c = 0; c < 3; ++c) {
      if (!std::isfinite(pixel[c])) pixel[c] = pixel[c] > 0.0f ? max_value : 0.0f;
    }
  }
  if (warnings == nullptr) return;
  const auto width = static_cast<std::size_t>(picture.width);
  warnings->push_back(
      InputError(file, place_of({first % width, first / width}),
                 "found " + std::to_string(count) +
                     (count == 1 ? " value that is" : " values from here on that are") +
                     " not finite; infinity is taken as " +
                     quoted_text(static_cast<double>(max_value)) + ", NaN as 0")
          .what());
}

RadianceMap from_exr(const fs::path& file, std::vector<std::string>* warnings) {
  ExrPicture picture = read_exr_picture(file, warnings);
  if (picture.is_cube) {
    throw InputError(file, "attribute envmap",
                     "found a cube map; allowed: latitude and longitude, which OpenEXR's program "
                     "exrenvmap makes of it");
  }
  make_finite(file, picture, warnings);
  picture.convert_to_rec709();
  return {picture.width, picture.height, std::move(picture.pixels)};
}

// Negative values come from resampling, and from colours beyond Rec. 709.
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
      throw InputError(file, place_of({i % width, i / width}),
                       "found " + quoted_text(static_cast<double>(value)) +
                           "; allowed: a finite radiance up to 1e20");
    }
  }
}

}  // namespace

std::shared_ptr<const RadianceMap> read_radiance_map(const fs::path& file,
                                                     std::vector<std::string>* warnings) {
  const bool is_hdr = read_first_bytes(file, 2) == "#?";
  if (!is_hdr && !is_exr(file)) {
    throw InputError(file, "header", "found neither an OpenEXR nor a Radiance HDR image");
  }
  auto map = std::make_shared<RadianceMap>(is_hdr ? read_hdr(file) : from_exr(file, warnings));
  check(file, *map);
  return map;
}

}  // namespace brume
