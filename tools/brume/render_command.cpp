#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/text_scanner.h"
#include "core/limits.h"
#include "core/scene/at_time.h"
#include "core/scene/cameras.h"
#include "render/deep/deep_file.h"
#include "render/gl_renderer.h"
#include "render/layers/frame_layers.h"
#include "render/output/frame_file.h"
#include "render/quality/auto_quality.h"
#include "render/render_plan.h"
#include "render/samples/exposure.h"
#include "render/transfer/transfer_cache.h"
#include "render/transfer/transfer_store.h"
#include "tools/brume/backend_name.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/interruption.h"
#include "tools/brume/layer_names.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/render_statistics.h"

namespace brume {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int max_march_steps = 65'536;

// N of `name` = "method:N", in [1, max].
std::optional<int> method_count(std::string_view name, AirlightMethod method, int max) {
  const std::string prefix = std::string(to_string(method)) + ':';
  if (!name.starts_with(prefix)) return std::nullopt;
  const auto count = parse_integer(name.substr(prefix.size()));
  if (!count || *count < 1 || *count > max) return std::nullopt;
  return static_cast<int>(*count);
}

// Sets the method and what belongs to it.
void set_airlight(Settings& settings, const std::string& name) {
  for (const auto method : {AirlightMethod::auto_, AirlightMethod::paper, AirlightMethod::sliced,
                            AirlightMethod::reference}) {
    if (name != to_string(method)) continue;
    settings.airlight = method;
    return;
  }
  if (const auto steps = method_count(name, AirlightMethod::march, max_march_steps)) {
    settings.airlight = AirlightMethod::march;
    settings.march_steps = *steps;
    return;
  }
  if (const auto paths = method_count(name, AirlightMethod::path, max_paths)) {
    settings.airlight = AirlightMethod::path;
    settings.paths = *paths;
    return;
  }
  throw UsageError("--airlight: found " + quoted_text(name) +
                   "; allowed: auto, paper, sliced, reference, march:N with N from 1 to " +
                   std::to_string(max_march_steps) + ", path:N with N from 1 to " +
                   std::to_string(max_paths));
}

Scattering parse_scattering(const std::string& name) {
  for (const auto scattering : {Scattering::single, Scattering::multiple}) {
    if (name == to_string(scattering)) return scattering;
  }
  throw UsageError("--scattering: found " + quoted_text(name) + "; allowed: single, multiple");
}

Film parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto side = [&](std::string_view part) {
    const auto value = parse_integer(part);
    if (!value || *value < 1 || *value > limits::film_side) {
      throw UsageError("--size: found " + quoted_text(text) +
                       "; allowed: WIDTHxHEIGHT, each 1 to " + std::to_string(limits::film_side));
    }
    return static_cast<int>(*value);
  };
  const std::string_view view = text;
  return {side(view.substr(0, cross)),
          side(cross == std::string::npos ? std::string_view{} : view.substr(cross + 1))};
}

// "x0,y0,x1,y1": fractions of the film's sides from the upper left corner.
Film parse_region(const std::string& text, const Film& film) {
  std::array<double, 4> numbers{};
  std::string_view rest = text;
  bool is_good = true;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::size_t comma = rest.find(',');
    const std::optional<double> number = parse_number(rest.substr(0, comma));
    is_good = is_good && number && *number >= 0.0 && *number <= 1.0 &&
              (comma == std::string_view::npos) == (k + 1 == numbers.size());
    numbers[k] = number.value_or(0.0);
    rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
  }
  const auto& [x0, y0, x1, y1] = numbers;
  if (!is_good || !(x0 < x1) || !(y0 < y1)) {
    throw UsageError("--region: found " + quoted_text(text) +
                     "; allowed: x0,y0,x1,y1, each from 0 to 1, with x0 < x1 and y0 < y1");
  }
  return film_region(film, {x0, y0}, {x1, y1});
}

// "open,close" in frames, or "none".
std::optional<Shutter> parse_shutter(const std::string& text) {
  if (text == "none") return std::nullopt;
  const std::size_t comma = text.find(',');
  const std::string_view view = text;
  const auto open = parse_number(view.substr(0, comma));
  const auto close =
      comma == std::string::npos ? std::nullopt : parse_number(view.substr(comma + 1));
  if (!open || !close || !domain::shutter.contains(*open) || !domain::shutter.contains(*close) ||
      !(*open < *close)) {
    throw UsageError("--shutter: found " + quoted_text(text) +
                     "; allowed: OPEN,CLOSE, two numbers of frames from -2 to 2 with OPEN < CLOSE, "
                     "or none");
  }
  return Shutter{*open, *close};
}

class RenderCommand final : public Command {
 public:
  explicit RenderCommand(CLI::App& app) {
    app.add_option("SCENE", scene_file_, "the scene, .brume")->required();
    app.add_option("-o,--output", output_,
                   "the image: .exr (linear, all layers), .deep.exr (samples in depth) or .png")
        ->required();
    app.add_option("--size", size_, "WIDTHxHEIGHT in pixels, instead of the scene's film");
    app.add_option("--region", region_,
                   "x0,y0,x1,y1: renders this part of the picture only; fractions of its sides, "
                   "from the upper left corner");
    app.add_option("--camera", camera_,
                   "the name of a camera of the scene; default: the one in use");
    app.add_option("--airlight", airlight_,
                   "auto, paper, sliced, reference, march:STEPS or path:PATHS")
        ->capture_default_str();
    app.add_option("--scattering", scattering_,
                   "sliced: single or multiple, all orders of scattering and reflection")
        ->capture_default_str();
    app.add_option("--slices", slices_, "slices per view ray, for sliced")
        ->check(finite_in(4, 256))
        ->capture_default_str();
    app.add_option("--airlight-scale", airlight_scale_,
                   "compute the airlight at 1/1, 1/2 or 1/4 of the width and height and upsample "
                   "it; default: 4 for auto, else 1")
        ->check(CLI::IsMember({1, 2, 4}));
    app.add_flag("--paper-mean", paper_.at_mean,
                 "paper: evaluate the light of a Gaussian at its mean on the ray");
    app.add_flag("--paper-energy", paper_.conserve_energy,
                 "paper: scale the airlight of a ray to conserve energy");
    app.add_flag("--paper-spread", paper_spread_,
                 "light scattered onto surfaces: use the paper's single point spread function");
    app.add_option("--max-error", max_error_,
                   "the relative RMSE of the airlight that auto must meet")
        ->check(finite_in(1e-4, 10.0))
        ->capture_default_str();
    app.add_option("--tolerance", tolerance_, "relative tolerance of the reference")
        ->check(finite_in(1e-12, 1.0))
        ->capture_default_str();
    app.add_option("--layers", layers_,
                   "NAME,...: more layers of an .exr: lights, environment, emission, direct, "
                   "multiple, optical_depth, normal, albedo, position, motion, objects, materials");
    app.add_option("--deep-error", deep_error_,
                   "of a .deep.exr: how far its alpha and airlight may be off wherever they are "
                   "held out")
        ->check(finite_in(1e-5, 0.5));
    app.add_option("--time", time_, "time to render [s], for keyframes, emitters and noise")
        ->check(finite_in(-1e9, 1e9))
        ->capture_default_str();
    app.add_option("--samples", samples_,
                   "samples of pixels at edges, filtered; 1: the centers of all pixels; default: "
                   "the scene's, else 16 with surfaces, 64 where a lens or a shutter blurs")
        ->check(finite_in(1, limits::samples));
    app.add_option("--shutter", shutter_,
                   "OPEN,CLOSE: motion blur, from and to so many frames after the time, or none; "
                   "default: the scene's");
    app.add_option("--backend", backend_,
                   "auto, cpu or gl (OpenGL 4.5); auto uses gl if a GPU answers")
        ->capture_default_str();
    app.add_option("--threads", threads_, "maximum number of worker threads; default: all")
        ->check(finite_in(1, 1024));
    app.add_option("--repeat", repeat_,
                   "frames with a moved camera to render after the first, for --stats")
        ->check(finite_in(1, 1e6))
        ->capture_default_str();
    app.add_option("--exposure", exposure_, "exposure of a .png, in stops")
        ->check(finite_in(-100.0, 100.0))
        ->capture_default_str();
    app.add_option("--color-config", color_.config,
                   "of a .png: a configuration of OpenColorIO, .ocio, or aces for ACES 1.0; "
                   "default: $OCIO, else aces, with --display or --view");
    app.add_option("--display", color_.display, "a display of it; default: the first");
    app.add_option("--view", color_.view,
                   "a view of it; default: the first. Without any of the three: Khronos PBR "
                   "Neutral in sRGB");
    app.add_option("--stats", stats_file_, "write timings and measured error as JSON");
  }

  ExitCode run() override {
    Settings settings = sliced_settings({}, slices_);
    set_airlight(settings, airlight_);
    const bool is_auto = settings.airlight == AirlightMethod::auto_;
    settings.scattering = parse_scattering(scattering_);
    settings.max_error = max_error_;
    settings.paper = paper_;
    settings.paper_spread = paper_spread_;
    const bool is_path = settings.airlight == AirlightMethod::path;
    const bool is_truth = is_path || settings.airlight == AirlightMethod::reference;
    if (airlight_scale_ > 1 && is_truth) {
      throw UsageError(std::string("--airlight-scale: ") + (is_path ? "path" : "the reference") +
                       " is never interpolated; allowed: 1");
    }
    settings.airlight_scale = airlight_scale_ > 0 ? airlight_scale_ : is_auto ? 4 : 1;
    settings.reference_tolerance = tolerance_;
    // Clamped to the available threads: TBB warns of more, and --stats reports the real number.
    const int hardware_threads = tbb::info::default_concurrency();
    settings.threads = threads_ > 0 ? std::min(threads_, hardware_threads) : hardware_threads;
    // Frames have their own arenas; this also limits everything else.
    const tbb::global_control bound(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(settings.threads));
    const bool is_deep = is_deep_file(output_);
    check_deep_options(is_deep, settings);
    const OutputLayers layers = wanted_layers(is_deep);
    const Backend backend = parse_backend(backend_);
    const Film wanted = size_.empty() ? Film{} : parse_size(size_);
    if (!region_.empty()) static_cast<void>(parse_region(region_, wanted));
    if (!shutter_.empty()) static_cast<void>(parse_shutter(shutter_));
    const DisplayLook display{exposure_, color_view()};
    CommandFiles files = outputs();

    const Clock::time_point start = Clock::now();
    const Scene animation = seen_by_camera(read_scene(scene_file_, files));
    const Scene scene = evaluate_at(animation, time_);
    const Film whole = size_.empty() ? scene.film : wanted;
    const Film film = region_.empty() ? whole : parse_region(region_, whole);
    check_layer_memory(scene, film, layers);
    const auto transfers = std::make_shared<TransferStore>();
    const double transfer_milliseconds =
        is_path ? 0.0 : make_transfers(scene, settings, *transfers);
    std::string problem;
    const std::unique_ptr<FrameRenderer> made = make_renderer(backend, transfers, problem);
    FrameRenderer& renderer = *made;
    Exposure exposure = exposure_of(animation);
    if (samples_ > 0) exposure.samples = samples_;
    if (is_deep) exposure.samples = 1;  // a deep pixel is one ray
    if (!shutter_.empty()) exposure.shutter = parse_shutter(shutter_);
    const auto scene_at = [&](double time) {
      return time == time_ ? scene : evaluate_at(animation, time);
    };
    const auto render = [&](const Camera& camera, int number) {
      const ProgressLine line(frame_title(number));
      return finished(
          render_exposure(renderer, scene_at, time_, camera, film, settings, exposure, line.job()));
    };
    settings.samples = samples_of(exposure, scene.camera, scene);
    std::optional<ErrorEstimate> error;
    std::optional<Frame> first_frame;
    if (is_auto) {
      const bool is_final = !is_blurred(exposure, scene.camera);
      Settings first = settings;
      if (!is_final) first.samples = 1;
      const ProgressLine line("auto");
      RequestedFrame rendered = finished(render_requested(renderer, scene, scene.camera, film,
                                                          first, interruption(), line.progress()));
      error = rendered.error;
      settings = rendered.settings;
      if (is_final) first_frame = std::move(rendered.frame);
    }
    if (!first_frame) first_frame = render(scene.camera, 1);
    settings.samples = samples_of(exposure, scene.camera, scene);
    Frame& frame = *first_frame;
    const std::chrono::duration<double, std::milli> first = Clock::now() - start;
    if (backend == Backend::gl) warn_of_cpu(problem, frame.statistics);
    if (error && error->high > max_error_) {
      std::ostringstream text;
      text << "no setting is certain to meet --max-error " << max_error_
           << "; this one has a relative RMSE of " << error->rel_rmse << ", " << error->low
           << " to " << error->high;
      print_warnings({text.str()});
    }

    std::vector<FrameStatistics> moved;
    for (int i = 1; i <= moved_frames(); ++i) {
      // Too small a step to change the cost, but nothing of the last view can be reused.
      Camera camera = scene.camera;
      camera.eye += (1 + i % 1000) * 1e-6 * (camera.target - camera.eye);
      moved.push_back(render(camera, i + 1).statistics);
    }
    check_interrupted();
    const FrameInfo info{scene_file_, airlight_name(settings), frame.statistics.backend, display,
                         relative_noise(frame)};
    const LayeredFrame layered{
        animation,
        scene,
        nullptr,
        settings,
        render_lit_by(renderer, {scene_at, time_, scene.camera, film, exposure}),
        frame};
    std::optional<DeepFileStatistics> deep;
    if (is_deep) {
      const ProgressLine line("deep frame");
      deep = finished(write_deep_frame(output_, scene, scene.camera, film,
                                       deep_settings(settings, *deep_error_, frame), *transfers,
                                       info, line.job()));
      warn_of_coarse_slices(*deep);
    } else if (has_more_layers(layers)) {
      const ProgressLine line("layers");
      const ImageLayers more = finished(render_layers(layered, layers, line.job()));
      write_frame(output_, frame, info, more);
    } else {
      write_frame(output_, frame, info);
    }
    if (!stats_file_.empty()) {
      // What paths say of their error is their noise; the integral is scattered once only.
      if (!error && !is_truth) {
        const ProgressLine line("measuring the error");
        error =
            finished(measure_error(scene, scene.camera, frame, interruption(), line.progress()));
      }
      const RenderRun run{scene_file_,   film,
                          settings,      repeat_,
                          first.count(), transfer_milliseconds,
                          error,         relative_noise(frame),
                          deep};
      write_atomically(stats_file_, statistics_json(run, frame.statistics, moved));
    }
    return done;
  }

 private:
  void check_deep_options(bool is_deep, const Settings& settings) {
    if (!is_deep) {
      if (deep_error_)
        throw UsageError("--deep-error: is of a deep frame; allowed: with -o X.deep.exr");
      return;
    }
    if (settings.airlight != AirlightMethod::auto_ && settings.airlight != AirlightMethod::sliced) {
      throw UsageError("--airlight: found " + quoted_text(airlight_) +
                       "; allowed for a deep frame: auto, sliced");
    }
    if (!deep_error_) deep_error_ = DeepSettings{}.error;
  }

  [[nodiscard]] OutputLayers wanted_layers(bool is_deep) const {
    if (layers_.empty()) return {};
    if (is_deep || lower_case_extension(output_) != ".exr") {
      throw UsageError("--layers: are of a flat EXR; allowed: with -o X.exr");
    }
    return parse_layers(layers_);
  }

  static void check_layer_memory(const Scene& scene, const Film& film, const OutputLayers& layers) {
    const std::size_t bytes = layer_bytes(scene, film, layers);
    if (bytes <= limits::scene_bytes) return;
    throw UsageError("--layers: they take " + std::to_string(bytes) + " bytes; allowed: at most " +
                     std::to_string(limits::scene_bytes) + "; choose fewer, or a smaller --size");
  }

  static void warn_of_coarse_slices(const DeepFileStatistics& deep) {
    if (deep.image.coarse_tiles == 0) return;
    print_warnings({"--deep-error: " + std::to_string(deep.image.coarse_tiles) +
                    " tiles of 16 x 8 pixels are too steep for this error; more --slices help"});
  }

  // Reports when gl was requested but did not render.
  static void warn_of_cpu(std::string problem, const FrameStatistics& statistics) {
    if (statistics.backend == "gl") return;
    if (problem.empty() && !statistics.on_cpu.empty()) problem = statistics.on_cpu.front().why;
    print_warnings({"--backend gl: rendered on the CPU: " + problem});
  }

  [[nodiscard]] Scene seen_by_camera(Scene scene) const {
    if (camera_.empty() || use_camera(scene, camera_)) return scene;
    std::string names = quoted_text(scene.camera_name);
    for (const NamedCamera& camera : scene.cameras) names += ", " + quoted_text(camera.name);
    throw UsageError("--camera: found " + quoted_text(camera_) + "; allowed: " + names);
  }

  // Null: Brume's own.
  [[nodiscard]] std::shared_ptr<const ColorView> color_view() const {
    if (color_ == ColorChoice{}) return nullptr;
    if (lower_case_extension(output_) != ".png") {
      throw UsageError("--color-config, --display, --view: an EXR is linear; allowed for .png");
    }
    ColorChoice choice = color_;
    if (choice.config.empty()) choice.config = default_color_config();
    return std::make_shared<const ColorView>(choice);
  }

  // Checks everything that could fail before the work.
  [[nodiscard]] CommandFiles outputs() const {
    check_frame_extension(output_);
    CommandFiles files;
    files.add_output(output_);
    if (!stats_file_.empty()) files.add_output(stats_file_);
    return files;
  }

  // Frames rendered after the first, whose times are reported: in them everything is built.
  [[nodiscard]] int moved_frames() const {
    return stats_file_.empty() && repeat_ == 1 ? 0 : repeat_;
  }

  [[nodiscard]] std::string frame_title(int number) const {
    return "frame " + std::to_string(number) + " of " + std::to_string(1 + moved_frames());
  }

  // Radiance transfer of the scene, from the disk cache or computed. Returns the time [ms].
  static double make_transfers(const Scene& scene, const Settings& settings,
                               TransferStore& transfers) {
    const Clock::time_point start = Clock::now();
    const std::vector<TransferRequest> needed = needed_transfers(scene, settings);
    if (needed.empty()) return 0.0;
    std::vector<std::string> warnings;
    {
      const ProgressLine line("radiance transfer");
      transfers.make(needed, cache_folder(), line.job(), &warnings);
      check_interrupted();
    }
    print_warnings(warnings);
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

  std::string scene_file_;
  std::string output_;
  std::string size_;
  std::string region_;  // empty: all of the film
  std::string camera_;  // empty: the one in use
  std::string airlight_ = "auto";
  int airlight_scale_ = 0;  // 0: not given
  PaperOptions paper_;
  bool paper_spread_ = false;
  double max_error_ = Settings{}.max_error;
  std::string scattering_ = to_string(Scattering::multiple);
  int slices_ = Settings{}.slices;
  double tolerance_ = Settings{}.reference_tolerance;
  std::string layers_;  // empty: those by default
  std::optional<double> deep_error_;
  double time_ = 0.0;
  int samples_ = 0;      // 0: not given
  std::string shutter_;  // empty: the scene's
  std::string backend_ = "auto";
  int threads_ = 0;
  int repeat_ = 1;
  double exposure_ = 0.0;
  ColorChoice color_;  // empty: Brume's own view
  std::string stats_file_;
};

}  // namespace

std::unique_ptr<Command> make_render_command(CLI::App& app) {
  return std::make_unique<RenderCommand>(app);
}

}  // namespace brume
