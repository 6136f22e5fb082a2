#include "render/gl/film_airlight.h"

#include <algorithm>

#include "render/geometry/ray_range.h"
#include "render/geometry/tiles.h"
#include "render/gl/shader_structs.h"
#include "render/prepare/light_pixels.h"

namespace brume::gl {
namespace {

// Pixels that the cells of one tile hold at most: those of the last ones go on to the film's end.
int max_requests(int scale) {
  return (Tiles::width * scale + 1) * (Tiles::height * scale + 1);
}

}  // namespace

void FilmTextures::reserve(const Film& film) {
  const glm::ivec2 size(film.width, film.height);
  depth.reserve(Texture::Format::r32f, size);
  airlight.reserve(Texture::Format::rgba32f, size);
  pairs.reserve(Texture::Format::r32f, size);
  behind.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                 sizeof(glm::vec4));
  beauty.reserve(Texture::Format::rgba32f, size);
}

std::string ray_definitions(const CameraRays& rays) {
  return rays.is_parallel() ? " PARALLEL" : "";
}

void set_fog(const Program& program, const BatchFog& fog) {
  program.set("b0", fog.density);
  program.set("fog_center", fog.center);
  program.set("fog_radius", fog.radius);
}

void set_rays(const Program& program, const CameraRays& rays) {
  const CameraRays::FilmPlane plane = rays.plane();
  program.set("corner", rays.is_parallel() ? rays.whole_offset(glm::dvec2(0.0)) : plane.corner);
  program.set("parallel_direction", rays.forward());
  program.set("per_x", plane.per_x);
  program.set("per_y", plane.per_y);
  program.set("first_pixel", rays.first_pixel());
}

std::size_t FilmAirlight::run(Programs& programs, DeviceClock& clock, const Program& method,
                              const std::function<void()>& bind, TileLists& lists,
                              const FilmView& view, FilmTextures& textures) {
  const int scale = view.plan.settings.airlight_scale;
  const glm::ivec2 tiles = lists.tiles();
  const auto tile_count = static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
  const glm::ivec2 sample_film = lists.sample_film();
  const auto sample_count =
      static_cast<std::size_t>(sample_film.x) * static_cast<std::size_t>(sample_film.y);
  const auto capacity = static_cast<std::size_t>(max_requests(scale));
  // Nodes of curved cells are requested beside pixels.
  const auto nodes_at = static_cast<int>(tile_count * capacity);
  const int batches_at = 2 * nodes_at;
  samples_.reserve(Texture::Format::rgba32f, sample_film);
  textures.pairs.fill(0.0f);

  // `batches_before`: of those that were requested, as many have run.
  const auto run_method = [&](bool again, std::size_t groups, std::size_t batches_before) {
    set_rays(method, view.rays);
    method.set("film", glm::ivec2(view.film.width, view.film.height));
    method.set("sample_film", sample_film);
    method.set("tiles", tiles);
    method.set("scale", scale);
    method.set("ray_end", static_cast<float>(std::min(view.ray_end, endless)));
    method.set("again", again ? 1 : 0);
    method.set("groups", static_cast<int>(groups));
    method.set("batches_at", batches_at + static_cast<int>(batches_before * sizeof(PixelBatch) /
                                                           sizeof(std::uint32_t)));
    bind();
    lists.bind(method);
    method.bind("Requests", requests_);
    method.bind("depths", textures.depth);
    method.bind("samples", samples_);
    method.bind("airlight_image", textures.airlight);
    method.bind("pairs_image", textures.pairs);
    method.dispatch_linear(groups);
  };
  clock.time(view.plan.medium_stage(), [&] { run_method(false, tile_count, 0); });
  if (!view.plan.runs(Stage::upsample)) return sample_count;

  // A batch is at least one pixel that was asked for: in three runs.
  const std::size_t batches = 3 * tile_count * ((capacity + Tiles::pixels - 1) / Tiles::pixels);
  requests_.reserve(2 * tile_count * capacity * sizeof(std::uint32_t) +
                    batches * sizeof(PixelBatch));
  curved_cells_.reserve(tile_count * Tiles::pixels * sizeof(std::uint32_t));
  UpsamplingTotals totals;
  if (view.airlight_rms) {
    totals.mean_square = static_cast<float>(*view.airlight_rms * *view.airlight_rms);
  }
  totals_.upload(std::span<const UpsamplingTotals>(&totals, 1));
  const TilePixels near_lights =
      sort_into_tiles(light_pixels(view.plan.lights, view.rays, view.film, light_block),
                      {sample_film.x, sample_film.y}, scale);
  light_offsets_.upload(std::span<const std::uint32_t>(near_lights.offsets));
  light_pixels_.upload(std::span<const glm::ivec2>(near_lights.pixels));
  const auto run_upsampling = [&](const Program& program, int requests_at) {
    program.set("film", glm::ivec2(view.film.width, view.film.height));
    program.set("sample_film", sample_film);
    program.set("tiles", tiles);
    program.set("scale", scale);
    program.set("b0", view.fog.density);
    program.set("tolerance", static_cast<float>(view.plan.settings.upsampling_tolerance));
    program.set("capacity", static_cast<int>(capacity));
    program.set("requests_at", requests_at);
    program.set("batches_at", batches_at);
    program.bind("depths", textures.depth);
    program.bind("airlight_image", textures.airlight);
    program.bind("Totals", totals_);
    program.bind("Requests", requests_);
    program.bind("CurvedCells", curved_cells_);
    lists.bind(program);
    program.dispatch_linear(tile_count);
  };
  clock.time(Stage::upsample, [&] {
    if (!view.airlight_rms) {
      const Program& rms = programs["rms"];
      rms.set("size", sample_film);
      rms.bind("samples", samples_);
      rms.bind("Totals", totals_);
      rms.dispatch(1);
    }
    const Program& interpolate = programs.get("interpolate", lists.defined());
    interpolate.bind("samples", samples_);
    interpolate.bind("LightOffsets", light_offsets_);
    interpolate.bind("LightPixels", light_pixels_);
    run_upsampling(interpolate, 0);
    run_upsampling(programs.get("curved_nodes", lists.defined()), nodes_at);
  });
  totals_.download(std::span(&totals, 1));
  clock.time(view.plan.medium_stage(), [&] { run_method(true, totals.batches, 0); });
  if (totals.curved_cells == 0) return sample_count + totals.asked_pixels;
  clock.time(Stage::upsample, [&] {
    const Program& halve = programs.get("halve", lists.defined());
    halve.bind("nodes", textures.airlight);
    run_upsampling(halve, 0);
  });
  const std::size_t batches_before = totals.batches;
  totals_.download(std::span(&totals, 1));
  clock.time(view.plan.medium_stage(),
             [&] { run_method(true, totals.batches - batches_before, batches_before); });
  return sample_count + totals.asked_pixels;
}

}  // namespace brume::gl
