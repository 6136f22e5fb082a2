// The first hits of a frame's view rays.

#include <array>
#include <cstddef>
#include <span>

#include "core/scene/camera_rays.h"
#include "render/geometry/tiles.h"
#include "render/prepare/frame_stages.h"

namespace brume {
namespace {

// The view rays of a tile's pixels.
class ViewRays {
 public:
  ViewRays(const CameraRays& rays, const CameraRays::PixelRectangle& rectangle)
      : is_parallel_(rays.is_parallel()) {
    Tiles::each_pixel(rectangle, [&](int x, int y) {
      offsets_[count_] = rays.offset(x + 0.5, y + 0.5);
      directions_[count_++] = rays.direction(x + 0.5, y + 0.5);
    });
  }
  [[nodiscard]] std::span<const glm::dvec3> directions() const {
    return std::span(directions_).first(count_);
  }
  // Empty unless they are parallel.
  [[nodiscard]] std::span<const glm::dvec3> offsets() const {
    return std::span(offsets_).first(is_parallel_ ? count_ : 0);
  }

 private:
  std::array<glm::dvec3, Tiles::pixels> directions_, offsets_;
  std::size_t count_ = 0;
  bool is_parallel_;
};

// Calls keep(x, y, hit) for all pixels.
template <class Keep>
void trace_hits(const RayCaster& ray_caster, const FrameContext& work, Keep keep) {
  const Tiles tiles(work.frame.film);
  work.job.parallel_for(tiles.count(), [&](std::size_t tile) {
    const CameraRays::PixelRectangle rectangle = tiles.rectangle(tile);
    const ViewRays rays(work.rays, rectangle);
    std::array<SurfaceHit, Tiles::pixels> hits;
    ray_caster.first_hits(work.rays, rays.directions(), rays.offsets(),
                          std::span(hits).first(rays.directions().size()));
    std::size_t count = 0;
    Tiles::each_pixel(rectangle, [&](int x, int y) { keep(x, y, hits[count++]); });
  });
}

}  // namespace

void FrameStages::find_hits(FrameContext& work, StageClock& clock) {
  distances_.clear();
  copies_.clear();
  if (!work.plan.runs(Stage::visibility)) return;
  hits_.resize(work.frame.depth.size());  // all are set
  const auto width = static_cast<std::size_t>(work.frame.film.width);
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
  };
  const RayCaster& ray_caster = prepared_.ray_caster();
  if (work.plan.rasterizes && ray_caster.can_rasterize(work.rays)) {
    const Raster raster = ray_caster.raster(work.rays, work.frame.film, work.job);
    work.job.parallel_for(raster.bands(),
                          [&](std::size_t band) { raster.draw(band, hits_, work.frame.depth); });
  } else {
    distances_.resize(hits_.size());
    if (work.plan.has_copies) copies_.resize(hits_.size());
    trace_hits(ray_caster, work, [&](int x, int y, const SurfaceHit& hit) {
      const std::size_t i = index(x, y);
      set_hit(i, hit);
      work.frame.depth[i] = hits_[i].distance;
    });
  }
  meet_lights(work);
  clock.finish(Stage::visibility);
}

void FrameStages::meet_lights(FrameContext& work) {
  if (work.light_shapes.empty()) return;
  const auto width = static_cast<std::size_t>(work.frame.film.width);
  const Tiles tiles(work.frame.film);
  work.job.parallel_for(tiles.count(), [&](std::size_t tile) {
    const ViewRays rays(work.rays, tiles.rectangle(tile));
    std::array<SurfaceHit, Tiles::pixels> hits;
    std::array<std::size_t, Tiles::pixels> pixels;
    std::size_t count = 0;
    Tiles::each_pixel(tiles.rectangle(tile), [&](int x, int y) {
      pixels[count] = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      const std::size_t pixel = pixels[count];
      hits[count++].distance =
          distances_.empty() ? static_cast<double>(hits_[pixel].distance) : distances_[pixel];
    });
    work.light_shapes.meet(work.rays.eye(), rays.directions(), rays.offsets(),
                           std::span(hits).first(count));
    for (std::size_t k = 0; k < count; ++k) {
      if (hits[k].is_light()) set_hit(pixels[k], hits[k]);
      work.frame.depth[pixels[k]] = hits_[pixels[k]].distance;
    }
  });
}

}  // namespace brume
