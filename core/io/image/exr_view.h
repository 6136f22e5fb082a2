#pragma once

#include <glm/mat4x4.hpp>

namespace brume {

// How a rendered picture sees its scene: standard attributes of OpenEXR.
struct ExrView {
  // worldToCamera: x to the right, y up, z along the view [u].
  glm::dmat4 world_to_camera{1.0};
  // worldToNDC: x and y from (0, 0), the upper left corner of the picture, to (1, 1).
  glm::dmat4 world_to_ndc{1.0};
  double frames_per_second = 0.0;  // 0: not known
};

}  // namespace brume
