#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "brume/frame.h"
#include "render/display/color_view.h"
#include "render/display/plate_behind.h"

namespace brume {

// How linear radiance is shown. A view transform is never baked into an EXR.
struct DisplayLook {
  double exposure = 0.0;                    // [stops]
  std::shared_ptr<const ColorView> view{};  // null: Khronos PBR Neutral in sRGB, see neutral_view.h
  std::shared_ptr<const PlateBehind> plate{};  // null: none

  bool operator==(const DisplayLook&) const = default;
};

// The name of a look's view transform.
std::string view_name(const DisplayLook& look);

// Linear radiance as Khronos PBR Neutral in sRGB shows it, in [0, 1].
glm::vec3 to_display(const glm::vec3& radiance, double exposure);

// A frame as values of a display, RGB per pixel: of 8 bits, dithered by the place in the whole
// picture (see dither.h), for the screen, PNG and videos; or of 16 bits, rounded.
std::vector<std::uint8_t> to_display(const Frame& frame, const DisplayLook& look);
std::vector<std::uint16_t> to_display_16(const Frame& frame, const DisplayLook& look);

}  // namespace brume
