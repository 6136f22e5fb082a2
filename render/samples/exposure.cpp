#include "render/samples/exposure.h"
#include "core/scene/camera_rays.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <numeric>

#include "brume/at_time.h"
#include "render/samples/brightness.h"
#include "render/samples/mean_frame.h"
#include "render/samples/pixel_filter.h"

namespace brume {
namespace {

// Beyond this a blur is no picture, and pixels no integers.
constexpr double max_film_shift = 1e6;

// The k-th of `count` numbers in an order of its own for each stride: near to count * stride, and
// coprime to count, so that all come once.
int shuffled(int k, int count, double stride) {
  int step = std::max(1, static_cast<int>(std::lround(count * stride)));
  while (std::gcd(step, count) != 1) ++step;
  return static_cast<int>(static_cast<std::int64_t>(k) * step % count);
}

// Vogel's spiral ("A better way to construct the sunflower head", 1979), from the center to about
// the rim; its mean square distance from the center is that of the disk.
glm::dvec2 disk_point(int k, int count) {
  const double radius = std::sqrt(static_cast<double>(k) / std::max(count - 1, 1));
  const double angle = k * std::numbers::pi * (3.0 - std::sqrt(5.0));
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace

std::vector<ExposureSample> exposure_samples(int count) {
  if (count == 1) return {{}};
  const std::vector<glm::dvec2> pixels = pixel_samples(count);
  // Strides for which the three hardly correlate, of 16 to 256.
  std::vector<ExposureSample> samples;
  for (int k = 0; k < count; ++k) {
    samples.push_back({pixels[static_cast<std::size_t>(k)],
                       disk_point(shuffled(k, count, 0.385), count),
                       (shuffled(k, count, 0.44) + 0.5) / count});
  }
  return samples;
}

LensView seen_through(const Camera& camera, const Film& film, const glm::dvec2& lens) {
  LensView view{camera, film};
  view.camera.aperture = 0.0;
  const CameraRays rays(camera, film);
  const CameraRays::FilmPlane plane = rays.plane();
  const double width = glm::length(plane.per_x);
  const double height = glm::length(plane.per_y);
  const glm::dvec2 offset = camera.aperture * lens;
  // per_y points down.
  const glm::dvec3 moved = offset.x / width * plane.per_x - offset.y / height * plane.per_y;
  view.camera.eye += moved;
  view.camera.target += moved;
  const double distance = camera.focus_distance.value_or(glm::length(camera.target - camera.eye));
  view.film.shift += glm::clamp(glm::dvec2(-offset.x / width, offset.y / height) / distance,
                                -max_film_shift, max_film_shift);
  return view;
}

Exposure exposure_of(const Scene& animation) {
  Exposure exposure{animation.output.samples, animation.output.shutter};
  exposure.frames_per_second = frame_rate(animation);
  exposure.animated = is_animated(animation);
  return exposure;
}

bool is_blurred(const Exposure& exposure, const Camera& camera) {
  return exposure.samples != 1 &&
         (camera.aperture > 0.0 || (exposure.shutter && exposure.animated));
}

int samples_of(const Exposure& exposure, const Camera& camera, const Scene& scene) {
  if (exposure.samples) return *exposure.samples;
  return is_blurred(exposure, camera) ? blur_samples : chosen_samples(scene);
}

std::optional<Frame> render_exposure(FrameRenderer& renderer, const ExposedView& view,
                                     const Settings& settings, const Job& job) {
  const auto& [scene_at, time, camera, film, exposure] = view;
  Scene scene = scene_at(time);
  const auto seen_by = [&]() -> const Camera& { return camera ? *camera : scene.camera; };
  Settings sampled = settings;
  sampled.samples = samples_of(exposure, seen_by(), scene);
  const bool has_blur = is_blurred(exposure, seen_by());
  const int count = samples_of_paths(sampled);
  if (has_blur) sampled.samples = 1;
  const std::optional<Settings> of_picture =
      with_brightness(renderer, scene, seen_by(), film, sampled, {job.stop, {}});
  if (!of_picture) return std::nullopt;
  sampled = *of_picture;
  if (!has_blur) return renderer.render(scene, seen_by(), film, sampled, job.stop, job.progress);
  const double first = 1.0 / (count + 1);
  Settings of_center = sampled;
  of_center.paths = 1;
  const Job job_of_center = job.subrange(0.0, first);
  std::optional<Frame> center =
      renderer.render(scene, seen_by(), film, of_center, job.stop, job_of_center.progress);
  if (!center) return std::nullopt;

  const std::vector<ExposureSample> samples = exposure_samples(count);
  const auto render_sample = [&](int k, const Job& part) {
    const ExposureSample& sample = samples[static_cast<std::size_t>(k)];
    if (exposure.shutter && exposure.animated) {
      const double frames = glm::mix(exposure.shutter->open, exposure.shutter->close, sample.time);
      scene = scene_at(time + frames / exposure.frames_per_second);
    }
    LensView lens = seen_through(seen_by(), film, sample.lens);
    lens.film.shift += sample.pixel;
    return renderer.render(scene, lens.camera, lens.film, share_of_paths(sampled, k, count),
                           part.stop, part.progress);
  };
  return mean_frame(std::move(*center), count, job.subrange(first, 1.0), render_sample);
}

}  // namespace brume
