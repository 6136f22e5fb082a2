#include "render/composite.h"

#include <cmath>

namespace brume {

glm::vec3 behind_medium(const CameraRays& rays, const EnvironmentLight* environment,
                        std::span<const glm::vec3> surfaces, const Frame& frame,
                        std::size_t pixel) {
  if (!environment || std::isfinite(frame.depth[pixel])) {
    return surfaces.empty() ? glm::vec3(0.0f) : surfaces[pixel];
  }
  const auto width = static_cast<std::size_t>(frame.film.width);
  return environment->radiance(glm::vec3(rays.direction(static_cast<double>(pixel % width) + 0.5,
                                                        static_cast<double>(pixel / width) + 0.5)));
}

void composite(const CameraRays& rays, const EnvironmentLight* environment,
               std::span<const glm::vec3> surfaces, const Job& job, Frame& frame) {
  const auto width = static_cast<std::size_t>(frame.film.width);
  job.each(static_cast<std::size_t>(frame.film.height), [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const float transmittance = frame.transmittance[3 * i];
      const glm::vec3 behind = behind_medium(rays, environment, surfaces, frame, i);
      for (std::size_t k = 0; k < 3; ++k) {
        frame.beauty[4 * i + k] =
            finite(frame.airlight[3 * i + k] + transmittance * behind[static_cast<int>(k)]);
      }
      frame.beauty[4 * i + 3] = std::isfinite(frame.depth[i]) ? 1.0f : 1.0f - transmittance;
    }
  });
}

}  // namespace brume
