#include "app/panels/forms/environment_picture.h"

#include <algorithm>
#include <cmath>

#include "app/frames/view_mode.h"
#include "brume/frame.h"
#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {

QImage environment_picture(const Environment& environment, int width, int height) {
  Frame frame;
  frame.film = {width, height};
  RadianceMap grid;  // for its directions only
  grid.width = width;
  grid.height = height;
  double sum = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 radiance =
          environment_radiance(environment, map_direction(grid, {x + 0.5, y + 0.5}));
      for (int c = 0; c < 3; ++c) {
        frame.beauty.push_back(static_cast<float>(radiance[c]));
        sum += radiance[c] / 3.0;
      }
      frame.beauty.push_back(1.0F);
    }
  }
  // A sun's worth of light in few pixels must not leave the rest black.
  const double mean = sum / (static_cast<double>(width) * height);
  const double exposure = mean > 0.0 ? std::clamp(std::log2(0.4 / mean), -30.0, 30.0) : 0.0;
  return to_picture(frame, {exposure, nullptr}, ViewMode::final);
}

}  // namespace brume
