#include "render/cpu/composite.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/simd/composite_kernels.h"

namespace brume {

void behind_medium(const CameraRays& rays, const EnvironmentLight* environment,
                   std::span<const glm::vec3> surfaces, const Frame& frame, std::size_t y,
                   std::span<glm::vec3> behind) {
  const std::size_t width = behind.size();
  if (surfaces.empty()) {
    std::ranges::fill(behind, glm::vec3(0.0f));
  } else {
    std::ranges::copy(surfaces.subspan(y * width, width), behind.begin());
  }
  if (!environment) return;
  CameraRays::FilmPlane plane = rays.plane();
  if (rays.is_parallel()) plane = {rays.forward(), glm::dvec3(0.0), glm::dvec3(0.0)};
  const glm::ivec2 first = rays.first_pixel();
  const glm::dvec3 start =
      plane.corner + 0.5 * plane.per_x + (first.y + static_cast<double>(y) + 0.5) * plane.per_y;
  environment->show(start, plane.per_x, first.x, std::span(frame.depth).subspan(y * width, width),
                    behind);
}

void composite(const CameraRays& rays, const EnvironmentLight* environment,
               std::span<const glm::vec3> surfaces, const Job& job, Frame& frame) {
  const auto width = static_cast<std::size_t>(frame.film.width);
  job.parallel_for(static_cast<std::size_t>(frame.film.height), [&](std::size_t y) {
    thread_local std::vector<glm::vec3> behind;
    behind.resize(width);
    behind_medium(rays, environment, surfaces, frame, y, behind);
    const auto row = [&](auto& layer, std::size_t channels) {
      return std::span(layer).subspan(channels * y * width, channels * width);
    };
    composite_row({row(frame.airlight, 3), row(frame.transmittance, 3), row(frame.depth, 1)},
                  behind, row(frame.beauty, 4));
  });
}

void hold_out(const std::function<bool(std::size_t pixel)>& is_held_out, const Job& job,
              Frame& frame) {
  const auto width = static_cast<std::size_t>(frame.film.width);
  job.parallel_for(static_cast<std::size_t>(frame.film.height), [&](std::size_t y) {
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      if (!is_held_out(i)) continue;
      for (std::size_t c = 0; c < 3; ++c) frame.beauty[4 * i + c] = frame.airlight[3 * i + c];
      frame.beauty[4 * i + 3] = 1.0f - frame.transmittance[3 * i];  // grey within a group
    }
  });
}

void set_background_apart(Frame& frame) {
  frame.background.assign(frame.airlight.size(), 0.0f);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (std::isfinite(frame.depth[i])) continue;  // a surface
    for (std::size_t c = 0; c < 3; ++c) {
      frame.background[3 * i + c] =
          std::max(frame.beauty[4 * i + c] - frame.airlight[3 * i + c], 0.0f);
    }
  }
}

}  // namespace brume
