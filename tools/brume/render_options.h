#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "brume/render.h"
#include "brume/scene.h"
#include "core/io/frame_pattern.h"
#include "render/output/frame_file.h"
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
  [[nodiscard]] bool is_deep() const;

  // The request for a frame, but for its time in a sequence; `film`: the scene's.
  [[nodiscard]] RenderRequest request(const Film& film) const;
  // The information besides in its file.
  [[nodiscard]] FrameInfo info() const;  // reads a configuration

  // The scene with the camera and the frames per second that are chosen.
  [[nodiscard]] Scene adjusted(Scene scene) const;
  // Frame n of a sequence is at n / frame_rate() seconds.
  [[nodiscard]] double frame_rate(const Scene& scene) const;

 private:
  void check_request() const;
  void check_sequence_options() const;
  [[nodiscard]] DisplayLook display() const;
  [[nodiscard]] int bits() const;  // of a PNG

  const CLI::App& app_;
  std::string scene_file_;
  std::string output_;
  std::string camera_;                       // empty: the one in use
  std::string frames_;                       // empty: one frame
  std::optional<double> frames_per_second_;  // absent: the scene's
  bool skips_existing_ = false;
  std::string progress_ = "terminal";
  int repeat_ = 1;
  std::optional<int> bits_;
  double exposure_ = 0.0;
  ColorChoice color_;  // empty: Brume's own view
  std::string stats_file_;
};

}  // namespace brume
