#include "tools/brume/render_options.h"

#include <algorithm>
#include <array>
#include <memory>

#include "brume/at_time.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/disk/file_version.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/cameras.h"
#include "render/request.h"
#include "tools/brume/command.h"
#include "tools/brume/frame_range.h"
#include "tools/brume/request_arguments.h"

namespace brume {
namespace {

std::string absolute_text(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

// The content of a look, wherever its files lie.
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
  app.add_option("--camera", camera_, "the name of a camera of the scene; default: the one in use");
  add_request_options(app);
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
  check_request();
  check_sequence_options();
  static_cast<void>(bits());
}

void RenderOptions::check_request() const {
  if (!is_deep() && app_.get_option("--deep-error")->count() > 0) {
    throw UsageError("--deep-error: is of a deep frame; allowed: with -o X.deep.exr");
  }
  const bool has_layers = app_.get_option("--layers")->count() > 0;
  if (has_layers && (is_deep() || lower_case_extension(output_) != ".exr")) {
    throw UsageError("--layers: are of a flat EXR; allowed: with -o X.exr");
  }
  if (const std::optional<RequestProblem> problem = problem_of(request({}))) {
    throw UsageError("--" + problem->option + ": " + problem->why);
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

RenderRequest RenderOptions::request(const Film& film) const {
  RenderRequest request = request_of(app_, film);
  if (!request.error && !stats_file_.empty() && !is_sequence()) {
    request.error = ErrorMeasurement::quick;
  }
  if (is_deep() && !request.deep_error) request.deep_error = DeepSettings{}.error;
  return request;
}

FrameInfo RenderOptions::info() const {
  return {.scene = scene_file_, .look = display(), .bits = bits()};
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

bool RenderOptions::is_deep() const {
  return is_deep_file(output_);
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

}  // namespace brume
