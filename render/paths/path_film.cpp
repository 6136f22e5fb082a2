#include "render/paths/path_film.h"

#include <algorithm>
#include <cmath>

#include "render/visibility/holdout.h"

namespace brume {
namespace {

// Rays with less have no airlight: products with random numbers must stay normal.
constexpr double min_depth = 1e-200;

// Streams of random numbers of a pixel.
enum Stream : std::uint64_t { block_stream, airlight_stream, surface_stream };

std::size_t index_of(const glm::ivec2& pixel, int width) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(pixel.x);
}

void set_pixel(std::vector<float>& layer, std::size_t pixel, const glm::dvec3& value) {
  for (std::size_t c = 0; c < 3; ++c) {
    layer[3 * pixel + c] = finite(static_cast<float>(value[static_cast<int>(c)]));
  }
}

}  // namespace

void PathFilm::trace(const PathKey& key, const View& view, const Job& job, Frame& frame) {
  const std::size_t pixels = frame.depth.size();
  if (key != key_ || view.paths < paths_ || counts_.size() != pixels) {
    key_ = key;
    counts_.assign(pixels, 0);
    airlight_.assign(view.has_medium ? pixels : 0, {});
    surfaces_.assign(view.has_surfaces ? pixels : 0, {});
  }
  paths_ = view.paths;
  surface_radiance_.assign(view.has_surfaces ? pixels : 0, glm::vec3(0.0f));

  const PathTracer tracer(view.scene);
  const auto columns = static_cast<std::size_t>(view.pixels.x1 - view.pixels.x0);
  const std::size_t traced = columns * static_cast<std::size_t>(view.pixels.y1 - view.pixels.y0);
  const std::size_t runs = (traced + run - 1) / run;
  std::vector<Variances> variances(runs);
  job.parallel_for_with_progress(runs, [&](std::size_t r) {
    for (std::size_t i = r * run; i < std::min((r + 1) * run, traced); ++i) {
      const glm::ivec2 position(i % columns, i / columns);
      trace_pixel(view, tracer, glm::ivec2(view.pixels.x0, view.pixels.y0) + position, job, frame,
                  variances[r]);
    }
  });
  if (job.stop.stop_requested()) return;
  if (view.has_medium) {
    for (const float pairs : frame.statistics.pixel_pairs) {
      frame.statistics.view_pairs += static_cast<std::uint64_t>(pairs);
    }
  }
  if (view.paths < 2) return;
  std::optional<PathNoise>& known = frame.statistics.path_noise;
  PathNoise& noise = known ? *known : known.emplace();
  noise.paths = view.paths;
  for (const Variances& each : variances) {
    noise.airlight_variance += each.airlight;
    noise.surface_variance += each.surfaces;
  }
}

void PathFilm::trace_pixel(const View& view, const PathTracer& tracer, const glm::ivec2& position,
                           const Job& job, Frame& frame, Variances& variances) {
  const std::size_t pixel = index_of(position, frame.film.width);
  const double passing = view.passing ? static_cast<double>(view.passing(pixel)) : 1.0;
  if (!(passing > 0.0)) return;
  // On the whole film, so that regions have the same random numbers.
  const std::size_t stream = index_of(view.rays.first_pixel() + position, view.rays.whole_size().x);
  const glm::dvec3 eye = view.rays.origin(position.x + 0.5, position.y + 0.5);
  const glm::dvec3 w = view.rays.direction(position.x + 0.5, position.y + 0.5);
  const SurfaceHit hit = view.has_surfaces ? view.hit(pixel) : SurfaceHit{};
  const double end = hit ? hit.distance : view.open_end;
  std::optional<CameraRay> ray;
  if (view.has_medium) ray.emplace(view.scene.medium.index(), eye, w, end);
  const double depth = ray ? ray->depth() : 0.0;
  const bool has_airlight = depth > min_depth;
  const bool sees_surface = hit && !hit.is_light() && depth < PathTracer::hidden_depth &&
                            !is_held_out(view.scene.surfaces, hit);
  SurfacePoint point;
  if (sees_surface) point = view.scene.ray_caster.point(hit, eye, w, view.scene.surfaces);

  if (hit.is_light()) surface_radiance_[pixel] = view.scene.light_shapes->of(hit).radiance;

  int& count = counts_[pixel];
  for (; count < view.paths; ++count) {
    if (!has_airlight && !sees_surface) {
      count = view.paths;
      break;
    }
    if (job.stop.stop_requested()) return;
    const auto sample = static_cast<std::uint64_t>(count);
    if (has_airlight) {
      const PathRandom block(key_.seed, stream, sample / path_block, block_stream);
      PathRandom random(key_.seed, stream, sample, airlight_stream);
      const StratifiedPair stratified(block, static_cast<unsigned>(count % path_block), random);
      airlight_[pixel].add(count, tracer.airlight(*ray, stratified, random).sum(), key_.channels);
    }
    if (sees_surface) {
      PathRandom random(key_.seed, stream, sample, surface_stream);
      surfaces_[pixel].add(count, tracer.surface(point, random).sum(), key_.channels);
    }
  }

  const double transmittance = std::exp(-depth);
  if (view.has_medium) {
    set_pixel(frame.transmittance, pixel, glm::dvec3(transmittance));
    frame.statistics.pixel_pairs[pixel] = static_cast<float>(ray->gaussians());
  }
  if (view.paths == 0) return;
  if (has_airlight) {
    set_pixel(frame.airlight, pixel, airlight_[pixel].mean(view.paths));
    variances.airlight += passing * passing * airlight_[pixel].variance(view.paths, key_.channels);
  }
  if (sees_surface) {
    const glm::dvec3 radiance = surfaces_[pixel].mean(view.paths);
    for (int c = 0; c < 3; ++c) {
      surface_radiance_[pixel][c] = finite(static_cast<float>(radiance[c]));
    }
    const double reaching = passing * transmittance;
    variances.surfaces +=
        reaching * reaching * surfaces_[pixel].variance(view.paths, key_.channels);
  }
}

}  // namespace brume
