#include "tools/bench/bench_run.h"

#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string_view>

#include "core/io/image/image_file.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/imported_scene.h"
#include "core/scene/lights/sky.h"
#include "render/display/to_display.h"
#include "render/render_plan.h"
#include "render/renderer.h"
#include "render/transfer/transfer_store.h"
#include "tools/bench/errors/incident_light_errors.h"
#include "tools/bench/errors/surface_light_errors.h"
#include "tools/bench/errors/transfer_errors.h"
#include "tools/bench/measure/cache_gains.h"
#include "tools/bench/measure/frames.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/table_one_scenes.h"

namespace brume {
namespace {

std::vector<Settings> tried_settings(const BenchOptions& options) {
  Settings base;
  base.threads = options.threads;
  Settings paper = base;
  paper.airlight = AirlightMethod::paper;
  std::vector<Settings> settings = {paper};
  const std::vector<int> slices = options.quick ? std::vector{4, 8, 16, 32, 96}
                                                : std::vector{4, 6, 8, 12, 16, 24, 32, 48, 64, 128};
  for (const int scale : {4, 1}) {
    Settings scaled = base;
    scaled.airlight_scale = scale;
    for (const int k : slices) settings.push_back(sliced_settings(scaled, k));
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
    const double level = std::min(std::sqrt(square) / white, 1.0);
    rgb.insert(rgb.end(), 3, static_cast<std::uint8_t>(std::lround(255.0 * level)));
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
    return encode_png(f.film.width, f.film.height, to_display(f, {}));
  };
  return {setting_name(settings), png(frame), png(reference),
          error_map(frame, reference, std::max(white * rms, 1e-30)), white};
}

// One scene with all settings that are tried, their errors, and a picture. `gl` may be null.
SceneReport measure_scene(const BenchScene& bench, const BenchOptions& options, GlRenderer* gl) {
  const Scene& scene = bench.scene;
  SceneReport report;
  report.name = bench.name;
  report.gaussians = scene.medium.size();
  report.lights = scene.lights.size();
  report.environment = scene.environment.has_value();
  report.film = scene.film;
  const std::size_t pixels = scene.medium.size() > 1000 ? 150 : 400;
  const ReferenceSample reference = find_reference(scene, options.quick ? pixels / 2 : pixels);
  const double seconds = options.quick ? 0.15 : 0.4;
  report.reference_cpu_milliseconds = reference.frame_cpu_milliseconds;
  for (const Settings& settings : tried_settings(options)) {
    Renderer renderer;
    report.settings.push_back(measure(renderer, scene, settings, reference.sample, seconds));
    if (gl) report.on_gl.push_back(measure(*gl, scene, settings, reference.sample, seconds));
  }
  report.peers = other_renderers_of(options.peers, report.name, report.film);
  const auto shown = cheapest_within(report.settings, 0.02);
  report.picture = picture(
      scene, report.settings[shown.value_or(report.settings.size() - 1)].settings, options.quick);
  return report;
}

// After a first frame, which makes what the others keep.
MovedFrames cost(const Scene& scene, const Settings& settings, bool quick) {
  Renderer renderer;
  static_cast<void>(render_frame(renderer, scene, settings));
  return moved_frames(renderer, scene, settings, quick ? 3 : 9);
}

// Varies one parameter at a time; base scene: the box of 1,000 Gaussians with one light, sliced 24.
std::vector<CostCurve> measure_cost_curves(const BenchOptions& options,
                                           const std::function<void(const std::string&)>& log) {
  Settings base;
  base.threads = options.threads;
  const auto cpu = [&](const Scene& scene, int slices) {
    return cost(scene, sliced_settings(base, slices), options.quick).cpu_milliseconds.median;
  };
  std::vector<CostCurve> curves;
  const auto add = [&](const char* over, const std::vector<int>& sizes, const auto& at) {
    log(std::string("cost over ") + over);
    CostCurve curve{over, {}, 0.0};
    for (const int size : sizes) curve.points.push_back({static_cast<double>(size), at(size)});
    curve.exponent = fitted_exponent(curve.points);
    curves.push_back(curve);
  };
  std::vector<int> counts = {100, 1000, 10'000};
  if (!options.quick) counts.insert(counts.end(), {100'000, 1'000'000});
  add("Gaussians", counts, [&](int n) { return cpu(box_scene(n, 1), 24); });
  add("lights", {1, 2, 4, 8}, [&](int n) { return cpu(box_scene(1000, n), 24); });
  add("slices", {8, 16, 32, 64, 128}, [&](int k) { return cpu(box_scene(1000, 1), k); });
  add("pixels", {7'500, 30'000, 120'000}, [&](int pixels) {
    Scene scene = box_scene(1000, 1);
    const int height = static_cast<int>(std::lround(std::sqrt(pixels * 0.75)));
    scene.film = {pixels / height, height};
    return cpu(scene, 24);
  });
  return curves;
}

// That box at 800 x 600, with 1, 2, 4 ... threads and with all.
std::vector<ThreadRow> measure_threads(const BenchOptions& options) {
  const int hardware = tbb::info::default_concurrency();
  const int all = options.threads > 0 ? std::min(options.threads, hardware) : hardware;
  Scene scene = box_scene(1000, 1);
  scene.film = {800, 600};
  std::vector<ThreadRow> rows;
  for (int threads = 1; threads <= all;
       threads = threads < all ? std::min(2 * threads, all) : all + 1) {
    Settings settings = sliced_settings({}, 24);
    settings.threads = threads;
    rows.push_back({threads, cost(scene, settings, options.quick).milliseconds});
  }
  return rows;
}

constexpr Film frontier_film{200, 150};

// In which caches are measured: those that differ in what they cache.
constexpr std::array<std::string_view, 4> cached_scenes{"statue", "box", "machine", "terrain_sky"};

void add_cache_gains(const MovingView& view, const BenchOptions& options, BenchReport& report) {
  std::ranges::move(measure_caches(view, options.quick ? 3 : 5), std::back_inserter(report.caches));
}

// One of its scenes, and what caches give in it.
void measure_table_one(const TableOneScene& kind, const BenchOptions& options,
                       BenchReport& report) {
  const Scene scene = kind.make();
  const auto transfers = std::make_shared<TransferStore>();
  transfers->make(needed_transfers(scene), {});
  Renderer chooser(transfers);
  Settings settings = fewest_slices(chooser, scene);
  settings.threads = options.threads;
  const ReferenceSample reference = find_reference(scene, 300, 1e-3);
  TableOneRow row{kind.name, kind.frames_per_second, {}, {}};
  Renderer renderer(transfers);
  static_cast<void>(render_frame(renderer, scene, settings));
  // The camera turns as in the editor: each frame shows triangles that the last one did not.
  constexpr double turn = 0.5;
  row.measurement = measure(renderer, scene, settings, reference.sample, 2.0, {turn, 1});
  Settings all_orders = settings;
  all_orders.scattering = Scattering::multiple;
  row.all_orders_ratio =
      frame_time_ratio({Renderer(transfers), Renderer(transfers)}, scene, {settings, all_orders},
                       options.quick ? 3 : 15, {turn, 1});
  report.table_one.push_back(std::move(row));
  if (std::ranges::find(cached_scenes, kind.name) == cached_scenes.end()) return;
  add_cache_gains({kind.name, scene, transfers, settings}, options, report);
}

// Measures what merging keeps, at rest and in motion.
void measure_merged_media(const BenchOptions& options, BenchReport& report) {
  Settings settings = sliced_settings({}, 8);
  settings.airlight_scale = 4;
  settings.threads = options.threads;
  const MovingView bank{"bank of 100,000", fog_bank(100'000), nullptr, settings};
  add_cache_gains(bank, options, report);
  MovingView motion = bank;
  motion.name += ", in motion";
  motion.motion.has_own_medium = true;
  add_cache_gains(motion, options, report);
}

// Null if OpenGL is not requested or not available.
std::unique_ptr<GlRenderer> gl_renderer(Backend backend) {
  if (backend == Backend::cpu) return nullptr;
  std::string problem;
  std::unique_ptr<GlRenderer> gl = GlRenderer::create(nullptr, problem);
  if (gl && backend == Backend::auto_ && gl->is_software()) return nullptr;
  if (!gl && backend == Backend::gl) throw std::runtime_error("--backend gl: " + problem);
  return gl;
}

std::vector<BenchScene> chosen_scenes(const BenchOptions& options) {
  if (options.scenes.empty()) return built_in_scenes(options.quick);
  std::vector<BenchScene> scenes;
  for (const auto& file : options.scenes) {
    BenchScene& added = scenes.emplace_back(file.stem().string(), load_scene(file));
    added.scene.surfaces = shown_surfaces(added.scene.surfaces, 0.0);
    apply_sky(added.scene);
    const Film& film = added.scene.film;
    if (options.quick && film.width * film.height > frontier_film.width * frontier_film.height) {
      added.scene.film = frontier_film;
    }
  }
  return scenes;
}

// For which two minutes are too short.
void measure_errors(BenchReport& report, const std::function<void(const std::string&)>& log) {
  log("errors of environment inscattering");
  report.skies = measure_skies();
  report.patches = measure_patches();
  report.glow = measure_inscattering();
  log("errors of interpolation and noise");
  report.scales = measure_scales();
  report.noise_depths = measure_noise_depths();
  report.noise = measure_noise_errors(400);
  log("light on surfaces: lights");
  report.point_light = measure_surface_light(40'000);
  log("light on surfaces: environment");
  report.incident_light = measure_incident_light(2'000);
  log("light on surfaces: radiance transfer");
  report.transfer = measure_transfer(2'000);
}

}  // namespace

std::vector<BenchScene> built_in_scenes(bool quick) {
  std::vector<BenchScene> scenes = {{"two_gaussians", two_gaussians()},
                                    {"cloud_30_depth_1", cloud(30, 1.0)},
                                    {"cloud_30_depth_10", cloud(30, 10.0)},
                                    {"cloud_300_depth_3", cloud(300, 3.0)},
                                    {"box_3000_depth_3", box_scene(3000, 1)}};
  Scene inside = cloud(100, 3.0);
  inside.lights[0].position = {0.2, 0.1, 0.0};
  inside.lights[0].intensity = glm::dvec3(1.0);
  scenes.push_back({"light_in_cloud", inside});
  Scene fog = cloud(100, 2.0);
  fog.medium.set_homogeneous_density(0.05);
  fog.lights.push_back({{-2.0, 1.0, 1.0}, {4, 6, 8}, {}});
  scenes.push_back({"cloud_in_fog", fog});
  Scene under_a_sky = cloud(100, 3.0);
  under_a_sky.lights.clear();
  under_a_sky.environment.emplace().map = gradient_sky();
  scenes.push_back({"under_a_sky", under_a_sky});
  scenes.push_back({"statue", statue_scene()});
  if (!quick) {
    for (const char* name : {"bunny_fog", "dense_cloud", "light_inside", "ground_fog"}) {
      scenes.push_back({name, sample_airlight(name)});
    }
  }
  for (BenchScene& s : scenes) s.scene.film = frontier_film;
  return scenes;
}

BenchReport run_bench(const BenchOptions& options,
                      const std::function<void(const std::string&)>& log) {
  BenchReport report;
  report.quick = options.quick;
  report.threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
  const std::unique_ptr<GlRenderer> gl = gl_renderer(options.backend);
  if (gl) report.gl_device = gl->device_name();
  for (const BenchScene& scene : chosen_scenes(options)) {
    log(scene.name);
    report.scenes.push_back(measure_scene(scene, options, gl.get()));
  }
  if (!options.scenes.empty()) return report;
  log("errors over optical depth");
  report.thickness = measure_thickness(options.quick ? 100 : 400);
  log("all orders of scattering");
  report.all_orders = measure_all_orders(options.quick);
  log("kinds of lights");
  report.light_kinds = measure_light_kinds(options.quick);
  log("filtered pixels");
  report.samples = measure_samples(options.quick);
  if (!options.quick) measure_errors(report, log);
  report.curves = measure_cost_curves(options, log);
  log("threads");
  report.thread_rows = measure_threads(options);
  log("many Gaussians");
  report.fog_banks = measure_fog_banks(options.quick);
  measure_merged_media(options, report);
  log("skipped stages");
  for (const PlanDecision& decision : plan_decisions()) {
    report.savings.push_back(measure_saving(decision, options.quick ? 3 : 9));
  }
  log("edge cases");
  for (HardCase& hard_case : load_hard_cases()) {
    const HardCaseErrors errors = measure_hard_case(hard_case, gl.get());
    report.hard_cases.push_back({std::move(hard_case), errors});
  }
  for (const TableOneScene& kind : table_one_scenes) {
    // In two minutes there is no time for radiance transfer.
    if (options.quick && std::string_view(kind.name) != "box") continue;
    log(std::string("Table 1: ") + kind.name);
    measure_table_one(kind, options, report);
  }
  return report;
}

}  // namespace brume
