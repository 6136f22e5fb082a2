// How fast the OpenGL backend is on this machine's device, as JSON: frames per second, milliseconds
// of each stage, and pairs of Gaussian and ray per second.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "render/gl/egl_context.h"
#include "render/gl_renderer.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/table_one_scenes.h"

namespace brume {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string output;
  std::vector<Film> films{{800, 600}, {1920, 1080}};
  std::vector<int> counts{10'000, 100'000, 1'000'000};
  std::vector<int> scales{1, 4};
  std::vector<std::string> scenes;  // empty: all
  int frames = 20;
  int slices = 12;
  bool table_one = true;
};

double median(std::vector<double> values) {
  const auto it = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), it, values.end());
  return *it;
}

// The stages that a frame's device runs; the others are the processor's.
bool is_on_device(Stage stage) {
  static const StageSet stages{Stage::visibility, Stage::lists,    Stage::light_table,
                               Stage::shadow_map, Stage::airlight, Stage::transmittance,
                               Stage::upsample,   Stage::surfaces, Stage::composite};
  return stages.has(stage);
}

// One scene with one film, scale and scattering: the first frame makes everything, the others move
// the camera.
Json measure(GlRenderer& renderer, const Scene& scene, const Film& film, int scale,
             Scattering scattering, const Options& options) {
  Settings settings;
  settings.airlight_scale = scale;
  settings.scattering = scattering;
  settings = sliced_settings(settings, options.slices);
  Json row;
  row["film"] = {film.width, film.height};
  row["scale"] = scale;
  row["scattering"] = to_string(scattering);
  const Frame first = *renderer.render(scene, scene.camera, film, settings);
  row["backend"] = first.statistics.backend;
  if (first.statistics.backend != "gl") {
    row["why"] = first.statistics.on_cpu.front().why;
    return row;
  }
  row["first_frame_ms"] = first.statistics.frame_milliseconds;
  std::vector<Stage> ran;
  std::vector<std::vector<double>> times;
  std::vector<double> frame_times;
  std::vector<double> shown_times;
  std::vector<double> device_times;
  double pairs = 0.0;
  const auto moved = [&](int i) {
    Camera camera = scene.camera;
    camera.eye += i * 1e-4 * (camera.target - camera.eye);
    return camera;
  };
  // One after the other: between frames that are read back, the device idles and slows its clock.
  for (int i = 1; i <= options.frames; ++i) {
    shown_times.push_back(
        renderer.show(scene, moved(i), film, settings, {})->frame.statistics.frame_milliseconds);
  }
  for (int i = 1; i <= options.frames; ++i) {
    const FrameStatistics statistics = renderer.render(scene, moved(i), film, settings)->statistics;
    frame_times.push_back(statistics.frame_milliseconds);
    double device = 0.0;
    for (const StageTime& stage : statistics.stages) {
      const auto it = std::ranges::find(ran, stage.stage);
      const auto index = static_cast<std::size_t>(it - ran.begin());
      if (it == ran.end()) {
        ran.push_back(stage.stage);
        times.emplace_back();
      }
      times[index].push_back(stage.milliseconds);
      if (is_on_device(stage.stage)) device += stage.milliseconds;
    }
    device_times.push_back(device);
    pairs = static_cast<double>(statistics.view_pairs);
  }
  // Device only; with the CPU's part, displayed on the device; and with readback.
  row["device_fps"] = 1000.0 / std::max(median(device_times), 1e-9);
  row["shown_fps"] = 1000.0 / std::max(median(shown_times), 1e-9);
  row["fps"] = 1000.0 / std::max(median(frame_times), 1e-9);
  row["device_ms"] = median(device_times);
  row["shown_ms"] = median(shown_times);
  row["frame_ms"] = median(frame_times);
  Json stages;
  for (std::size_t i = 0; i < ran.size(); ++i) {
    const double time = median(times[i]);
    stages[to_string(ran[i])] = time;
    if (ran[i] == Stage::airlight && time > 0.0) {
      row["pairs_per_second"] = 1e3 * pairs / time;
    }
  }
  row["pairs"] = pairs;
  row["stages_ms"] = std::move(stages);
  return row;
}

int run(const Options& options) {
  std::string problem;
  auto context = EglContext::create(&problem);
  const std::unique_ptr<GlRenderer> renderer =
      context ? GlRenderer::create(std::move(context), nullptr, problem, gl::PicturePool::create())
              : nullptr;
  if (!renderer) {
    std::cerr << "brume-gl-bench: " << problem << '\n';
    return 1;
  }
  check_writable(options.output);
  Json report;
  report["device"] = renderer->device_name();
  report["is_software"] = renderer->is_software();
  report["slices"] = options.slices;
  std::printf("%s\n", renderer->device_name().c_str());

  Json rows = Json::array();
  const auto measure_row = [&](const std::string& name, const Scene& scene, double paper_fps,
                               const Film& film, int scale, Scattering scattering) {
    Json row;
    row["scene"] = name;
    row["gaussians"] = scene.medium.size();
    if (paper_fps > 0.0) row["paper_fps"] = paper_fps;
    row.update(measure(*renderer, scene, film, scale, scattering, options));
    std::printf("%-12s %4d x %-4d scale %d, %-8s: ", name.c_str(), film.width, film.height, scale,
                to_string(scattering));
    if (row.contains("fps")) {
      std::printf("%8.1f fps on the device, %8.1f shown, %8.1f fetched; first %.0f ms\n",
                  row["device_fps"].get<double>(), row["shown_fps"].get<double>(),
                  row["fps"].get<double>(), row["first_frame_ms"].get<double>());
    } else {
      std::printf("on the CPU: %s\n", row["why"].get<std::string>().c_str());
    }
    std::fflush(stdout);
    rows.push_back(std::move(row));
  };
  const auto is_asked_for = [&](const std::string& name) {
    return options.scenes.empty() ||
           std::ranges::find(options.scenes, name) != options.scenes.end();
  };
  const auto measure_all = [&](const std::string& name, const Scene& scene, double paper_fps) {
    for (const Film& film : options.films) {
      for (const int scale : options.scales) {
        measure_row(name, scene, paper_fps, film, scale, Scattering::single);
      }
      measure_row(name, scene, paper_fps, film, options.scales.back(), Scattering::multiple);
    }
  };
  // The paper's five rows; the others are the same without point lights.
  for (const TableOneScene& kind : std::span(table_one_scenes).first(options.table_one ? 5 : 0)) {
    if (is_asked_for(kind.name)) measure_all(kind.name, kind.make(), kind.frames_per_second);
  }
  for (const int count : options.counts) {
    const std::string name = std::to_string(count);
    if (is_asked_for(name)) measure_all(name, box_scene(count, 2), 0.0);
  }
  report["rows"] = std::move(rows);
  write_atomically(options.output, report.dump(2) + "\n");
  return 0;
}

}  // namespace
}  // namespace brume

int main(int argc, char** argv) {
  CLI::App app("Measures the OpenGL backend");
  brume::Options options;
  bool is_quick = false;
  app.add_option("-o,--output", options.output, "the report, .json")->required();
  app.add_option("--frames", options.frames, "frames with a moved camera per row")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  app.add_option("--scenes", options.scenes,
                 "only these: statue, box, terrain, city, machine, or a number of Gaussians")
      ->delimiter(',');
  app.add_flag("--quick", is_quick, "tiny films and media, only to check that it works");
  CLI11_PARSE(app, argc, argv);
  if (is_quick) {
    options.films = {{48, 36}};
    options.counts = {100, 1000};
    options.frames = 1;
  }
  try {
    return brume::run(options);
  } catch (const std::exception& error) {
    std::cerr << "brume-gl-bench: " << error.what() << '\n';
    return 1;
  }
}
