#include "tools/bench/bench_run.h"

#include <tbb/info.h>

#include <algorithm>
#include <cmath>

#include "core/io/image_file.h"
#include "core/io/scene_file.h"
#include "core/scene/radiance_map.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tools/bench/benchmark_scenes.h"
#include "tools/bench/table_one_scenes.h"

namespace brume {
namespace {

constexpr Film frontier_film{200, 150};

Scene under_a_sky(Scene scene) {
  auto map = std::make_shared<RadianceMap>(RadianceMap{64, 32, {}});
  for (int i = 0; i < 64 * 32; ++i) {
    const glm::dvec3 d = map_direction(*map, {i % 64 + 0.5, i / 64 + 0.5});
    map->pixels.emplace_back(glm::dvec3(0.2, 0.25, 0.3) + std::max(d.y, 0.0));
  }
  scene.environment.emplace().map = map;
  scene.lights.clear();
  return scene;
}

std::vector<BenchScene> built_in_scenes() {
  std::vector<BenchScene> scenes = {{"two Gaussians", two_gaussians()},
                                    {"30 Gaussians, depth 1", cloud(30, 1.0)},
                                    {"300 Gaussians, depth 3", cloud(300, 3.0)},
                                    {"3,000 small ones, depth 3", box_scene(3000, 1)},
                                    {"30 Gaussians, depth 10", cloud(30, 10.0)}};
  Scene inside = cloud(100, 3.0);
  inside.lights[0].position = {0.2, 0.1, 0.0};
  inside.lights[0].intensity = glm::dvec3(1.0);
  scenes.push_back({"lamp inside", inside});
  Scene fog = cloud(100, 2.0);
  fog.medium.set_homogeneous_density(0.05);
  fog.lights.push_back({{-2.0, 1.0, 1.0}, {4, 6, 8}, {}});
  scenes.push_back({"cloud in fog, two lamps", fog});
  scenes.push_back({"under a sky", under_a_sky(cloud(100, 3.0))});
  scenes.push_back({"statue", statue_scene()});
  for (BenchScene& s : scenes) s.scene.film = frontier_film;
  return scenes;
}

std::vector<Settings> tried_settings(const BenchOptions& options) {
  Settings base;
  base.threads = options.threads;
  std::vector<Settings> settings = {base};
  const std::vector<int> slices = options.quick ? std::vector{4, 8, 16, 32, 96}
                                                : std::vector{4, 6, 8, 12, 16, 24, 32, 48, 64, 128};
  const std::vector<int> steps =
      options.quick ? std::vector{4, 16, 64} : std::vector{2, 4, 8, 16, 32, 64, 128, 256};
  for (const int scale : {4, 1}) {
    Settings scaled = base;
    scaled.airlight_scale = scale;
    for (const int k : slices) settings.push_back(sliced_settings(scaled, k));
    if (scale == 4 && options.quick) continue;
    for (const int n : steps) {
      Settings march = scaled;
      march.airlight = AirlightMethod::march;
      march.march_steps = n;
      settings.push_back(march);
    }
  }
  return settings;
}

// How far apart the airlights of two frames are, pixel by pixel: white is `white`.
std::string error_map(const Frame& frame, const Frame& reference, double white) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d =
          static_cast<double>(frame.airlight[3 * i + c] - reference.airlight[3 * i + c]);
      square += d * d / 3.0;
    }
    const double share = std::min(std::sqrt(square) / white, 1.0);
    rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255.0 * share)));
  }
  return encode_png(frame.film.width, frame.film.height, rgb);
}

BenchPicture picture(const Scene& scene, const Settings& settings, bool quick) {
  const Film film = quick ? Film{64, 48} : Film{120, 90};
  Settings exact = settings;
  exact.airlight = AirlightMethod::reference;
  exact.airlight_scale = 1;
  exact.reference_tolerance = 1e-3;
  const Frame frame = *Renderer().render(scene, scene.camera, film, settings);
  const Frame reference = *Renderer().render(scene, scene.camera, film, exact);
  double square = 0.0;
  for (const float x : reference.airlight)
    square += static_cast<double>(x) * static_cast<double>(x);
  const double rms = std::sqrt(square / static_cast<double>(reference.airlight.size()));
  constexpr double white = 0.1;
  const auto png = [](const Frame& f) {
    return encode_png(f.film.width, f.film.height, to_display(f, 0.0));
  };
  return {setting_name(settings), png(frame), png(reference),
          error_map(frame, reference, std::max(white * rms, 1e-30)), white};
}

SceneReport measure_scene(const BenchScene& bench, const BenchOptions& options) {
  const Scene& scene = bench.scene;
  SceneReport report;
  report.name = bench.name;
  report.gaussians = scene.medium.size();
  report.lights = scene.lights.size();
  report.environment = scene.environment.has_value();
  report.film = scene.film;
  const std::size_t pixels = scene.medium.size() > 1000 ? 150 : 400;
  const Truth truth = find_truth(scene, options.quick ? pixels / 2 : pixels);
  report.reference_cpu_milliseconds = truth.frame_cpu_milliseconds;
  for (const Settings& settings : tried_settings(options)) {
    Renderer renderer;
    report.settings.push_back(
        measure(renderer, scene, settings, truth.sample, options.quick ? 0.15 : 1.0));
  }
  const auto shown = cheapest_within(report.settings, 0.02);
  report.picture = picture(
      scene, report.settings[shown.value_or(report.settings.size() - 1)].settings, options.quick);
  return report;
}

// One thing at a time grows; the rest is the box of Gaussians with one lamp, sliced 24.
std::vector<CostCurve> cost_curves(const BenchOptions& options,
                                   const std::function<void(const std::string&)>& tell) {
  Settings base;
  base.threads = options.threads;
  const auto cost = [&](const Scene& scene, int slices) {
    Renderer renderer;
    const Settings settings = sliced_settings(base, slices);
    static_cast<void>(renderer.render(scene, scene.camera, scene.film, settings));
    std::vector<double> times;
    for (int i = 1; i <= (options.quick ? 3 : 9); ++i) {
      Camera camera = scene.camera;
      camera.eye += i * 1e-6 * (camera.target - camera.eye);
      const double begin = cpu_seconds();
      static_cast<void>(renderer.render(scene, camera, scene.film, settings));
      times.push_back(1e3 * (cpu_seconds() - begin));
    }
    return spread_of(times).median;
  };
  std::vector<CostCurve> curves;
  const auto add = [&](const char* over, const std::vector<int>& sizes, const auto& at) {
    tell(std::string("cost over ") + over);
    CostCurve curve{over, {}, 0.0};
    for (const int size : sizes) curve.points.push_back({static_cast<double>(size), at(size)});
    curve.exponent = fitted_exponent(curve.points);
    curves.push_back(curve);
  };
  std::vector<int> counts = {100, 1000, 10'000};
  if (!options.quick) counts.push_back(100'000);
  add("Gaussians", counts, [&](int n) { return cost(box_scene(n, 1), 24); });
  add("lights", {1, 2, 4, 8}, [&](int n) { return cost(box_scene(1000, n), 24); });
  add("slices", {8, 16, 32, 64, 128}, [&](int k) { return cost(box_scene(1000, 1), k); });
  add("pixels", {7'500, 30'000, 120'000}, [&](int pixels) {
    Scene scene = box_scene(1000, 1);
    const int height = static_cast<int>(std::lround(std::sqrt(pixels * 0.75)));
    scene.film = {pixels / height, height};
    return cost(scene, 24);
  });
  return curves;
}

TableOneRow table_one_row(const TableOneScene& kind, const BenchOptions& options) {
  const Scene scene = kind.make();
  const auto transfers = std::make_shared<TransferStore>();
  transfers->make(RenderPlan(scene, AirlightMethod::sliced).transfers, {});
  Renderer renderer(transfers);
  Settings settings = fewest_slices(renderer, scene);
  settings.threads = options.threads;
  const Truth truth = find_truth(scene, 300);
  return {kind.name, kind.frames_per_second, measure(renderer, scene, settings, truth.sample, 2.0)};
}

}  // namespace

BenchReport run_bench(const BenchOptions& options,
                      const std::function<void(const std::string&)>& tell) {
  BenchReport report;
  report.quick = options.quick;
  report.threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  std::vector<BenchScene> scenes;
  for (const auto& file : options.scenes) {
    BenchScene& added = scenes.emplace_back(file.filename().string(), load_scene(file));
    const Film& film = added.scene.film;
    if (options.quick && film.width * film.height > frontier_film.width * frontier_film.height) {
      added.scene.film = frontier_film;
    }
  }
  if (scenes.empty()) scenes = built_in_scenes();
  for (const BenchScene& scene : scenes) {
    tell(scene.name);
    report.scenes.push_back(measure_scene(scene, options));
  }
  if (!options.scenes.empty()) return report;
  report.curves = cost_curves(options, tell);
  for (const TableOneScene& kind : table_one_scenes) {
    // In two minutes there is no time for radiance transfer.
    if (options.quick && std::string_view(kind.name) != "box") continue;
    tell(std::string("Table 1: ") + kind.name);
    report.table_one.push_back(table_one_row(kind, options));
  }
  return report;
}

}  // namespace brume
