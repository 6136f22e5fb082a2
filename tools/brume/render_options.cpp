#include "tools/brume/render_options.h"

#include <tbb/info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>

#include "brume/at_time.h"
#include "brume/limits.h"
#include "core/io/file_bytes.h"
#include "core/io/file_version.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/cameras.h"
#include "render/deep/deep_file.h"
#include "render/layers/frame_layers.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/frame_range.h"
#include "tools/brume/layer_names.h"

namespace brume {
namespace {

constexpr int max_march_steps = 65'536;

std::string absolute_text(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

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

// WIDTHxHEIGHT, or the longer side of a film with the proportions of `film`.
Film parse_size(const std::string& text, const Film& film) {
  const std::size_t cross = text.find('x');
  const auto side = [&](std::string_view part) {
    const auto value = parse_integer(part);
    if (!value || *value < 1 || *value > limits::film_side) {
      throw UsageError("--size: found " + quoted_text(text) +
                       "; allowed: WIDTHxHEIGHT or one number, the longer side, each 1 to " +
                       std::to_string(limits::film_side));
    }
    return static_cast<int>(*value);
  };
  const std::string_view view = text;
  if (cross != std::string::npos) {
    return {side(view.substr(0, cross)), side(view.substr(cross + 1))};
  }
  const double scale = static_cast<double>(side(view)) / std::max(film.width, film.height);
  const auto scaled = [scale](int length) {
    return std::max(1, static_cast<int>(std::lround(scale * length)));
  };
  return {scaled(film.width), scaled(film.height)};
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

// What a look shows, wherever its files lie.
std::string content_of(const DisplayLook& look) {
  std::string text = view_name(look);
  if (!look.view) return text;
  if (look.view->files().empty()) text += look.view->choice().config;
  for (const std::filesystem::path& file : look.view->files()) {
    const std::optional<FileVersion> version = FileVersion::read(file);
    text += ' ' + (version ? version->text() : "missing");
  }
  return text;
}

}  // namespace

RenderOptions::RenderOptions(CLI::App& app) : app_(app) {
  app.add_option("SCENE", scene_file_, "the scene, .brume")->type_name("FILE")->required();
  app.add_option("-o,--output", output_,
                 "the image: .exr (linear, all layers), .deep.exr (samples in depth) or .png")
      ->type_name("FILE")
      ->required();
  app.add_option("--size", size_,
                 "WIDTHxHEIGHT in pixels, instead of the scene's film, or its longer side alone");
  app.add_option("--region", region_,
                 "x0,y0,x1,y1: renders this part of the picture only; fractions of its sides, "
                 "from the upper left corner");
  app.add_option("--camera", camera_, "the name of a camera of the scene; default: the one in use");
  app.add_option("--airlight", airlight_, "how the airlight is computed")
      ->type_name("TEXT:{auto,paper,sliced,reference,march:STEPS,path:PATHS}")
      ->capture_default_str();
  app.add_option("--scattering", scattering_,
                 "of sliced; multiple: all orders of scattering and reflection")
      ->type_name("TEXT:{single,multiple}")
      ->capture_default_str();
  app.add_option("--slices", slices_, "slices per view ray, for sliced")
      ->check(finite_in(4, 256))
      ->capture_default_str();
  app.add_option("--seed", seed_,
                 "of path: another seed is another, independent picture, 0 to 4294967295")
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
  app.add_option("--max-error", max_error_, "the relative RMSE of the airlight that auto must meet")
      ->check(finite_in(1e-4, 10.0))
      ->capture_default_str();
  app.add_option("--error", error_,
                 "whether the error of the airlight is measured: none: no, and auto only chooses; "
                 "full: until its interval is narrow; default: full for auto and for --stats of "
                 "one frame")
      ->type_name("TEXT:{none,full}")
      ->check(CLI::IsMember({"none", "full"}));
  app.add_option("--tolerance", tolerance_, "relative tolerance of the reference")
      ->check(finite_in(1e-12, 1.0))
      ->capture_default_str();
  app.add_option("--layers", layers_,
                 "more layers of an .exr, one or several with commas between them")
      ->type_name(
          "TEXT:{lights,environment,emission,direct,multiple,optical_depth,depth.planar,normal,"
          "albedo,position,motion,objects,materials}");
  app.add_option("--deep-error", deep_error_,
                 "of a .deep.exr: how far its alpha and airlight may be off wherever they are "
                 "held out")
      ->check(finite_in(1e-5, 0.5));
  app.add_option("--time", time_, "time to render [s], for keyframes, emitters and noise")
      ->check(finite_in(-1e9, 1e9))
      ->capture_default_str();
  app.add_option("--frames", frames_,
                 "FIRST-LAST, FIRST-LASTxSTEP or FRAME, several with commas between them: renders "
                 "a sequence; the image needs %04d for the frame")
      ->excludes("--time");
  add_frame_rate(app, frames_per_second_);
  app.add_flag("--skip-existing", skips_existing_,
               "leave frames alone that are complete and made from the same scene, files, options "
               "and version");
  app.add_option("--progress", progress_,
                 "of a sequence; openjd: lines that engines of the Open Job Description read")
      ->type_name("TEXT:{terminal,openjd}")
      ->check(CLI::IsMember({"terminal", "openjd"}))
      ->capture_default_str();
  app.add_option("--samples", samples_,
                 "samples of pixels at edges, filtered; 1: the centers of all pixels; default: "
                 "the scene's, else 16 with surfaces, 64 where a lens or a shutter blurs")
      ->check(finite_in(1, limits::samples));
  app.add_option("--shutter", shutter_,
                 "OPEN,CLOSE: motion blur, from and to so many frames after the time, or none; "
                 "default: the scene's");
  app.add_option("--backend", backend_, "gl: OpenGL 4.5; auto uses it if a GPU answers")
      ->type_name("TEXT:{auto,cpu,gl}")
      ->capture_default_str();
  app.add_option("--threads", threads_, "maximum number of worker threads; default: all")
      ->check(finite_in(1, 1024));
  app.add_option("--repeat", repeat_,
                 "frames with a moved camera to render after the first, for --stats")
      ->check(finite_in(1, 1e6))
      ->capture_default_str();
  app.add_option("--bits", bits_, "of each value of a .png: 8, dithered, or 16; default: 8")
      ->check(CLI::IsMember({8, 16}));
  app.add_option("--exposure", exposure_, "exposure of a .png, in stops")
      ->check(finite_in(-100.0, 100.0))
      ->capture_default_str();
  app.add_option("--color-config", color_.config,
                 "of a .png: a configuration of OpenColorIO, .ocio, or aces for ACES 1.0; "
                 "default: $OCIO, else aces, with --display or --view")
      ->type_name("FILE");
  app.add_option("--display", color_.display, "a display of it; default: the first");
  app.add_option("--view", color_.view,
                 "a view of it; default: the first. Without any of the three: Khronos PBR "
                 "Neutral in sRGB");
  app.add_option("--stats", stats_file_, "write timings and measured error as JSON")
      ->type_name("FILE");
}

void RenderOptions::check() const {
  static_cast<void>(settings());
  check_deep_options();
  check_sequence_options();
  static_cast<void>(layers());
  static_cast<void>(backend());
  static_cast<void>(film({}));
  static_cast<void>(bits());
  if (!shutter_.empty()) static_cast<void>(parse_shutter(shutter_));
}

void RenderOptions::check_deep_options() const {
  if (!is_deep()) {
    if (deep_error_) {
      throw UsageError("--deep-error: is of a deep frame; allowed: with -o X.deep.exr");
    }
    return;
  }
  const AirlightMethod method = settings().airlight;
  if (method != AirlightMethod::auto_ && method != AirlightMethod::sliced) {
    throw UsageError("--airlight: found " + quoted_text(airlight_) +
                     "; allowed for a deep frame: auto, sliced");
  }
}

void RenderOptions::check_sequence_options() const {
  if (is_sequence() != FramePattern::is_pattern(output_)) {
    throw UsageError("-o: found " + quoted_text(output_) +
                     "; a sequence needs --frames, and %04d for the frame in the image's name");
  }
  if (!is_sequence()) {
    if (skips_existing_ || tells_engine()) {
      throw UsageError(std::string(skips_existing_ ? "--skip-existing" : "--progress") +
                       ": is of a sequence; allowed: with --frames");
    }
    return;
  }
  static_cast<void>(frames());
  static_cast<void>(output_pattern());
  if (repeat_ != 1) throw UsageError("--repeat: is of one frame; allowed: without --frames");
}

std::vector<int> RenderOptions::frames() const {
  return parse_frames(frames_);
}

FramePattern RenderOptions::output_pattern() const {
  return parse_pattern(output_);
}

bool RenderOptions::measures_error() const {
  return error_ == "full" || (error_.empty() && !stats_file_.empty() && !is_sequence());
}

std::string RenderOptions::what_matters(const Scene& scene,
                                        const std::set<std::string>& others) const {
  // Whatever is added counts, unless it is listed here.
  constexpr std::array does_not{"SCENE",   "output", "frames", "skip-existing", "progress",
                                "threads", "repeat", "stats",  "time",          "color-config",
                                "display", "view",   "fps"};
  std::string text = "frame_rate=" + quoted_text(frame_rate(scene)) + "\n";
  for (const CLI::Option* option : app_.get_options()) {
    const std::string name = option->get_single_name();
    if (option->count() == 0 || std::ranges::find(does_not, name) != does_not.end() ||
        others.contains(name)) {
      continue;
    }
    text += name + "=";
    for (const std::string& value : option->results()) text += value + ",";
    text += "\n";
  }
  return text + content_of(display());
}

std::string RenderOptions::color_config_file() const {
  return color_.config.empty() || !is_config_file(color_.config) ? ""
                                                                 : absolute_text(color_.config);
}

std::vector<std::string> RenderOptions::arguments(const std::set<std::string>& others) const {
  constexpr std::array known{"SCENE", "output", "frames", "skip-existing", "progress"};
  std::vector<std::string> arguments{absolute_text(scene_file_), "--output",
                                     absolute_text(output_)};
  for (const CLI::Option* option : app_.get_options()) {
    const std::string name = option->get_single_name();
    if (option->count() == 0 || std::ranges::find(known, name) != known.end() ||
        others.contains(name)) {
      continue;
    }
    arguments.push_back("--" + name);
    if (name == "color-config" && is_config_file(color_.config)) {
      arguments.push_back(color_config_file());
    } else if (option->get_expected_max() > 0) {
      for (const std::string& value : option->results()) arguments.push_back(value);
    }
  }
  return arguments;
}

CommandFiles RenderOptions::outputs() const {
  check_frame_extension(output_);
  CommandFiles files;
  if (is_sequence()) {
    const FramePattern pattern = output_pattern();
    for (const int frame : frames()) files.add_output(pattern.file_of(frame));
  } else {
    files.add_output(output_);
  }
  if (!stats_file_.empty()) files.add_output(stats_file_);
  return files;
}

Settings RenderOptions::settings() const {
  Settings settings = sliced_settings({}, slices_);
  set_airlight(settings, airlight_);
  settings.scattering = parse_scattering(scattering_);
  settings.max_error = max_error_;
  settings.path_seed = seed_;
  settings.paper = paper_;
  settings.paper_spread = paper_spread_;
  const bool is_path = settings.airlight == AirlightMethod::path;
  if (airlight_scale_ > 1 && (is_path || settings.airlight == AirlightMethod::reference)) {
    throw UsageError(std::string("--airlight-scale: ") + (is_path ? "path" : "the reference") +
                     " is never interpolated; allowed: 1");
  }
  const int scale = settings.airlight == AirlightMethod::auto_ ? 4 : 1;
  settings.airlight_scale = airlight_scale_ > 0 ? airlight_scale_ : scale;
  settings.reference_tolerance = tolerance_;
  // TBB warns of more, and --stats reports the real number.
  const int hardware_threads = tbb::info::default_concurrency();
  settings.threads = threads_ > 0 ? std::min(threads_, hardware_threads) : hardware_threads;
  return settings;
}

DisplayLook RenderOptions::display() const {
  if (color_ == ColorChoice{}) return {exposure_, nullptr};
  if (lower_case_extension(output_) != ".png") {
    throw UsageError("--color-config, --display, --view: an EXR is linear; allowed for .png");
  }
  ColorChoice choice = color_;
  if (choice.config.empty()) choice.config = default_color_config();
  return {exposure_, std::make_shared<const ColorView>(choice)};
}

int RenderOptions::bits() const {
  if (bits_ && lower_case_extension(output_) != ".png") {
    throw UsageError("--bits: an EXR has 32-bit floats; allowed for .png");
  }
  return bits_.value_or(8);
}

OutputLayers RenderOptions::layers() const {
  if (layers_.empty()) return {};
  if (is_deep() || lower_case_extension(output_) != ".exr") {
    throw UsageError("--layers: are of a flat EXR; allowed: with -o X.exr");
  }
  return parse_layers(layers_);
}

bool RenderOptions::is_deep() const {
  return is_deep_file(output_);
}

double RenderOptions::deep_error() const {
  return deep_error_.value_or(DeepSettings{}.error);
}

Scene RenderOptions::adjusted(Scene scene) const {
  if (frames_per_second_) set_frame_rate(scene, *frames_per_second_);
  if (camera_.empty() || use_camera(scene, camera_)) return scene;
  std::string names = quoted_text(scene.camera_name);
  for (const NamedCamera& camera : scene.cameras) names += ", " + quoted_text(camera.name);
  throw UsageError("--camera: found " + quoted_text(camera_) + "; allowed: " + names);
}

double RenderOptions::frame_rate(const Scene& scene) const {
  return frames_per_second_.value_or(brume::frame_rate(scene));
}

Film RenderOptions::film(const Scene& scene) const {
  const Film whole = size_.empty() ? scene.film : parse_size(size_, scene.film);
  return region_.empty() ? whole : parse_region(region_, whole);
}

Exposure RenderOptions::exposure(const Scene& animation) const {
  Exposure exposure = exposure_of(animation);
  if (samples_ > 0) exposure.samples = samples_;
  if (is_deep()) exposure.samples = 1;  // a deep pixel is one ray
  if (!shutter_.empty()) exposure.shutter = parse_shutter(shutter_);
  return exposure;
}

}  // namespace brume
