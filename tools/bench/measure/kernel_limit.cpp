#include "tools/bench/measure/kernel_limit.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "core/scene/camera_rays.h"
#include "render/geometry/tiles.h"
#include "render/optical_depth/increment_kernels.h"
#include "render/prepare/prepared_scene.h"
#include "render/render_plan.h"
#include "render/slices/slice_boundaries.h"
#include "render/slices/slice_kernels.h"
#include "render/util/flush_denormals.h"
#include "tools/bench/measure/view_work.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

// The input of the loops for one tile.
struct ViewTile {
  GaussianBatch batch;
  PathBatch rays;
  std::vector<float> boundaries;  // those of all rays
  RaySlices slices;
};

using Lights = std::array<SliceLight, light_pack>;

struct View {
  PreparedScene prepared;
  std::vector<ViewTile> tiles;
  // With real tables, and with ones that fit into L1.
  Lights lights, small_lights;
  std::size_t light_count = 0;
};

Lights slice_lights(PreparedScene& prepared, const Scene& scene, const OpticalDepthTableSize& size,
                    int shadow_cells) {
  Lights lights;
  std::uint64_t pairs = 0;
  for (std::size_t l = 0; l < scene.lights.size(); ++l) {
    const glm::dvec3& position = scene.lights[l].position;
    const OpticalDepthTable& table = prepared.optical_depth_table(position, size, pairs);
    lights[l] = {glm::vec3(position - scene.camera.eye), 1e-3f, 1.0f, &table,
                 &prepared.shadow_map(position, table.map().resized(shadow_cells))};
    lights[l].map_origin = lights[l].position;
  }
  return lights;
}

void add_tile(View& view, const Scene& scene, const CameraRays& rays, int slices,
              const CameraRays::PixelRectangle& rectangle,
              std::span<const std::uint32_t> gaussians) {
  std::vector<glm::dvec3> directions;
  Tiles::each_pixel(rectangle,
                    [&](int x, int y) { directions.push_back(rays.direction(x + 0.5, y + 0.5)); });
  std::vector<SurfaceHit> hits(directions.size());
  view.prepared.ray_caster().first_hits(rays.eye(), directions, hits);
  std::vector<double> lengths;
  lengths.reserve(hits.size());
  for (const SurfaceHit& hit : hits) lengths.push_back(hit.distance);
  std::vector<SlicedLight> lights;
  for (const Light& light : scene.lights)
    lights.push_back({PointSource{{light.position, light.intensity}}});

  std::vector<double> boundaries;
  const glm::dvec3 center = glm::normalize(directions.front() + directions.back());
  const TileCone cone{rays.eye(), center, glm::length(directions.front() - center),
                      *std::ranges::max_element(lengths)};
  choose_slices(view.prepared.medium(), gaussians, lights, cone, slices, boundaries);
  if (boundaries.size() < 2) return;
  ViewTile& tile = view.tiles.emplace_back();
  tile.boundaries.assign(boundaries.begin(), boundaries.end());
  tile.batch.assign(view.prepared.medium(), rays.eye(), gaussians);
  tile.rays.assign(directions, lengths);
  tile.slices.assign(tile.boundaries, tile.rays);
}

void make_view(const Scene& scene, const Settings& settings, View& view) {
  view.prepared.update(scene, RenderPlan(scene, scene.film, settings));
  view.light_count = scene.lights.size();
  view.lights =
      slice_lights(view.prepared, scene, settings.optical_depth_table, settings.shadow_cells);
  const Film film{scene.film.width / settings.airlight_scale,
                  scene.film.height / settings.airlight_scale};
  const CameraRays rays(scene.camera, film);
  const Tiles tiles(film);
  const Tiles::Lists lists = tiles.lists(view.prepared.medium(), rays);
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    add_tile(view, scene, rays, settings.slices, tiles.rectangle(tile), lists.gaussians_of(tile));
  }
}

struct Seconds {
  double view = 0.0, sum = 0.0, small_sum = 0.0;
};

Seconds run_kernels(const View& view, float negligible) {
  Seconds seconds;
  std::vector<float> increments, moments;
  std::array<float, padded(Tiles::pixels)> depths;
  std::array<std::array<float, padded(Tiles::pixels)>, light_pack> radiance{};
  std::array<float*, light_pack> out{};
  for (std::size_t l = 0; l < light_pack; ++l) out[l] = radiance[l].data();
  const auto timed = [](double& sum, const auto& body) {
    const double begin = cpu_seconds();
    body();
    sum += cpu_seconds() - begin;
  };
  for (const ViewTile& tile : view.tiles) {
    increments.assign((tile.boundaries.size() - 1) * tile.rays.padded_size(), 0.0f);
    moments.assign(increments.size(), 0.0f);
    timed(seconds.view, [&] {
      accumulate_increments(tile.batch, tile.rays, tile.slices, increments.data(), moments.data());
    });
    const auto sum = [&](const Lights& lights) {
      sum_slices(tile.rays, tile.slices, increments.data(), moments.data(), {}, {}, negligible,
                 std::span(lights).first(view.light_count), depths.data(), {}, {}, out);
    };
    timed(seconds.sum, [&] { sum(view.lights); });
    timed(seconds.small_sum, [&] { sum(view.small_lights); });
  }
  return seconds;
}

void add(ViewWork& sum, const ViewWork& work) {
  sum.pairs += work.pairs;
  sum.increments += work.increments;
}

// Operations of `run` per second, measured over `count` of them.
template <class Run>
double rate_of(Run run, std::uint64_t count) {
  const double begin = cpu_seconds();
  const auto done = static_cast<double>(run(count));
  return done / (cpu_seconds() - begin);
}

}  // namespace

KernelShare measure_kernel_share(const Scene& scene, const Settings& settings, int rounds) {
  View view;
  make_view(scene, settings, view);
  PreparedScene small;
  small.update(scene, RenderPlan(scene, scene.film, settings));
  view.small_lights = slice_lights(small, scene, {8, 16}, 32);

  ViewWork in_vectors;
  ViewWork in_lanes;
  for (const ViewTile& tile : view.tiles) {
    add(in_vectors, count_view_work(tile.batch, tile.rays, tile.boundaries, vector_lanes()));
    add(in_lanes, count_view_work(tile.batch, tile.rays, tile.boundaries, 1));
  }
  const FlushDenormals flush;
  const auto negligible = static_cast<float>(0.1 * view.prepared.medium().tolerance());
  const auto pairs = static_cast<double>(in_vectors.pairs);
  const auto increments = static_cast<double>(in_vectors.increments);
  std::vector<double> limits, fractions, pair_fractions, sum_fractions;
  for (int round = 0; round < rounds; ++round) {
    const double limit = rate_of(increments_in_registers, 50'000'000);
    const double pair_limit = rate_of(pairs_in_registers, 20'000'000);
    const Seconds seconds = run_kernels(view, negligible);
    const double fraction = increments / seconds.view / limit;
    limits.push_back(limit);
    fractions.push_back(fraction);
    pair_fractions.push_back(fraction + pairs / seconds.view / pair_limit);
    sum_fractions.push_back(seconds.small_sum / seconds.sum);
  }
  return {spread_of(limits),         spread_of(fractions),
          spread_of(pair_fractions), spread_of(sum_fractions),
          increments / pairs,        static_cast<double>(in_lanes.increments) / increments};
}

}  // namespace brume
