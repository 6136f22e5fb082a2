#include "render/cpu/pane_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace brume {
namespace {

glm::vec3 rgb(const std::vector<float>& layer, std::size_t pixel, std::size_t channels) {
  const float* const first = layer.data() + channels * pixel;
  return {first[0], first[1], first[2]};
}

}  // namespace

PaneLayers::PaneLayers(const Frame& frame) : pixels_(frame.depth.size()) {
  for (Pixel& pixel : pixels_) pixel.depth = std::numeric_limits<float>::infinity();
}

void PaneLayers::add(std::span<const SeenPane> panes, const Frame& layer) {
  is_open_ = false;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel& pixel = pixels_[i];
    if (!(pixel.passing > 0.0f)) continue;
    const SeenPane& pane = panes[i];
    const float transmittance = rgb(layer.transmittance, i, 3).x;  // grey within a group
    const glm::vec3 airlight = rgb(layer.airlight, i, 3);
    const glm::vec3 attenuated = rgb(layer.beauty, i, 4) - airlight;
    const glm::vec3 scattered = pixel.passing * (airlight - pixel.airlight_before);
    pixel.airlight += scattered;
    pixel.beauty += scattered + pixel.passing * static_cast<float>(pane.covered) * attenuated;
    pixel.airlight_before = airlight;
    const bool is_surface = std::isfinite(layer.depth[i]);
    const float passing = is_surface ? pixel.passing * static_cast<float>(pane.passing) : 0.0f;
    pixel.alpha += (pixel.passing - passing) * layer.beauty[4 * i + 3];
    if (!pixel.has_depth) pixel.transmittance = transmittance;
    if (is_surface && pane.opaque > 0.5 && !pixel.has_depth) {
      pixel.depth = layer.depth[i];
      pixel.has_depth = true;
    }
    if (is_surface) {
      pixel.passing = passing;
      if (pixel.passing > 0.0f) is_open_ = true;
      continue;
    }
    pixel.background = pixel.passing * attenuated;
    if (!pixel.has_depth) pixel.transmittance = pixel.passing * transmittance;
    pixel.passing = 0.0f;
  }
}

void PaneLayers::write(Frame& frame) const {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    for (std::size_t c = 0; c < 3; ++c) {
      frame.airlight[3 * i + c] = pixel.airlight[static_cast<int>(c)];
      frame.transmittance[3 * i + c] = pixel.transmittance;
      frame.beauty[4 * i + c] = pixel.beauty[static_cast<int>(c)];
      if (frame.background.empty()) continue;
      frame.background[3 * i + c] = pixel.background[static_cast<int>(c)];
    }
    frame.beauty[4 * i + 3] = std::min(pixel.alpha, 1.0f);
    frame.depth[i] = pixel.depth;
  }
}

PaneView::PaneView(const FrameStages& stages, const FrameContext& work)
    : open_(stages.ray_ends(work).open),
      around_{work.frame.film.width, work.frame.film.height, 0, 0} {
  const RayCaster& ray_caster = stages.prepared().ray_caster();
  const auto width = static_cast<std::size_t>(work.frame.film.width);
  const std::size_t count = work.frame.depth.size();
  first_.distances.resize(count);
  last_.distances.resize(count);
  pixels_.assign(count, PixelDetail::none);
  hits_.assign(count, ray_caster.pixel_of({}));
  copies_.assign(work.plan.has_copies ? count : 0, 0);
  work.job.parallel_for(count / width, [&](std::size_t y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t pixel = y * width + x;
      const SurfaceHit first = stages.hit(pixel);
      first_.distances[pixel] = last_.distances[pixel] = first.distance;
      if (!first || !(ray_caster.pane(first, 0.0).passing > 0.0)) continue;
      const glm::dvec2 place(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
      const glm::dvec3 origin = work.rays.origin(place.x, place.y);
      const glm::dvec3 direction = work.rays.direction(place.x, place.y);
      const double nearest = work.rays.clip_end(origin, direction);
      SurfaceHit end = ray_caster.hits_on_ray(origin, direction, nearest).end;
      work.light_shapes.meet(origin, direction, end);
      last_.distances[pixel] = end.distance;
      hits_[pixel] = ray_caster.pixel_of(end);
      if (!copies_.empty()) copies_[pixel] = end.copy;
      pixels_[pixel] = PixelDetail::surfaces;
    }
  });
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    if (pixels_[pixel] == PixelDetail::none) continue;
    const auto x = static_cast<int>(pixel % width);
    const auto y = static_cast<int>(pixel / width);
    around_ = {std::min(around_.x0, x), std::min(around_.y0, y), std::max(around_.x1, x + 1),
               std::max(around_.y1, y + 1)};
  }
}

void PaneView::find_fog(Frame& frame, const std::function<void()>& integrate) {
  first_.airlight = frame.airlight;
  first_.transmittance = frame.transmittance;
  first_.depth = frame.depth;
  last_.depth.assign(last_.distances.begin(), last_.distances.end());
  frame.depth = last_.depth;
  integrate();
  last_.airlight = std::exchange(frame.airlight, first_.airlight);
  last_.transmittance = std::exchange(frame.transmittance, first_.transmittance);
  frame.depth = first_.depth;
  // integrate() may have left anything beside the pixels.
  for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
    if (pixels_[pixel] != PixelDetail::none) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      last_.airlight[i] = first_.airlight[i];
      last_.transmittance[i] = first_.transmittance[i];
    }
  }
}

}  // namespace brume
