#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "brume/output.h"
#include "brume/scene.h"
#include "core/io/frame_pattern.h"
#include "render/output/frame_file.h"
#include "render/samples/exposure.h"
#include "render/settings.h"
#include "tools/brume/backend_name.h"
#include "tools/brume/command_files.h"

namespace brume {

// The options of brume render, and what they mean. What is asked of it throws UsageError where an
// option is wrong, InputError where a file is.
class RenderOptions {
 public:
  explicit RenderOptions(CLI::App& app);

  // Everything that can be wrong without any file. Before any work; the rest relies on it.
  void check() const;
  // The outputs, which can be written.
  [[nodiscard]] CommandFiles outputs() const;

  [[nodiscard]] const std::string& scene_file() const { return scene_file_; }
  [[nodiscard]] const std::string& output() const { return output_; }
  [[nodiscard]] const std::string& stats_file() const { return stats_file_; }  // empty: none
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] bool is_sequence() const { return !frames_.empty(); }
  [[nodiscard]] std::vector<int> frames() const;
  [[nodiscard]] FramePattern output_pattern() const;
  [[nodiscard]] bool skips_existing() const { return skips_existing_; }
  // Whether its progress is for an engine of the Open Job Description.
  [[nodiscard]] bool tells_engine() const { return progress_ == "openjd"; }
  // All options that make a difference to a frame of a scene, and their values, of a look what its
  // files hold; `others`: of the same command, but not of frames.
  [[nodiscard]] std::string what_matters(const Scene& scene,
                                         const std::set<std::string>& others = {}) const;
  // Those given, as arguments of brume render in any folder, but what a farm says of its tasks:
  // --frames, --skip-existing and --progress.
  [[nodiscard]] std::vector<std::string> arguments(const std::set<std::string>& others) const;
  // As in arguments(); empty: none.
  [[nodiscard]] std::string color_config_file() const;
  [[nodiscard]] int repeat() const { return repeat_; }
  [[nodiscard]] double max_error() const { return max_error_; }
  // Whether `auto` measures its frames, beyond the choice of their settings.
  [[nodiscard]] bool auto_measures() const { return error_ != "none"; }
  // Whether frames whose method does not measure itself are measured: by default for the
  // statistics of one frame.
  [[nodiscard]] bool measures_error() const;

  // `threads` are no more than there are.
  [[nodiscard]] Settings settings() const;
  [[nodiscard]] Backend backend() const { return parse_backend(backend_); }
  [[nodiscard]] DisplayLook display() const;  // reads a configuration
  [[nodiscard]] int bits() const;             // of a PNG
  [[nodiscard]] OutputLayers layers() const;
  [[nodiscard]] bool is_deep() const;
  [[nodiscard]] double deep_error() const;

  // The scene with the camera and the frames per second that are chosen.
  [[nodiscard]] Scene adjusted(Scene scene) const;
  // Frame n of a sequence is at n / frame_rate() seconds.
  [[nodiscard]] double frame_rate(const Scene& scene) const;
  [[nodiscard]] Film film(const Scene& scene) const;
  [[nodiscard]] Exposure exposure(const Scene& animation) const;

 private:
  void check_deep_options() const;
  void check_sequence_options() const;

  const CLI::App& app_;
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
  std::string error_;  // empty: see measures_error()
  std::string scattering_ = to_string(Scattering::multiple);
  int slices_ = Settings{}.slices;
  std::uint32_t seed_ = 0;
  double tolerance_ = Settings{}.reference_tolerance;
  std::string layers_;  // empty: those by default
  std::optional<double> deep_error_;
  double time_ = 0.0;
  std::string frames_;                       // empty: one frame
  std::optional<double> frames_per_second_;  // absent: the scene's
  bool skips_existing_ = false;
  std::string progress_ = "terminal";
  int samples_ = 0;      // 0: not given
  std::string shutter_;  // empty: the scene's
  std::string backend_ = "auto";
  int threads_ = 0;
  int repeat_ = 1;
  std::optional<int> bits_;
  double exposure_ = 0.0;
  ColorChoice color_;  // empty: Brume's own view
  std::string stats_file_;
};

}  // namespace brume
