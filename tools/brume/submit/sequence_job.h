#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tools/brume/frame_fingerprint.h"
#include "tools/brume/render_options.h"

namespace brume {

// A sequence that is handed to a scheduler, whichever.
struct SequenceJob {
  const RenderOptions& options;
  std::set<std::string> own_options{};  // those of the command that are not brume render's
  std::size_t chunk = 10;               // frames of a task
  std::string video{};                  // .mp4; empty: none
  double frames_per_second = default_frame_rate;  // of the video

  // Throws UsageError where frames cannot make the video.
  void check_video() const;
  // Throws UsageError where the job's command has control characters.
  void check_names() const;
  // The command that makes the video of frames, a pattern of printf().
  [[nodiscard]] std::vector<std::string> video_command(const std::string& frames,
                                                       const std::string& file) const;
  // The pattern of the frames, absolute, and what is made of its name for other files.
  [[nodiscard]] std::filesystem::path output() const;
  [[nodiscard]] std::string stem() const;
  // Those that are missing or made from something else.
  [[nodiscard]] std::vector<int> not_current(const std::vector<int>& frames,
                                             const FrameFingerprint& fingerprint) const;
};

// Throws UsageError for control characters: a newline would end a line of a script.
void check_line(const std::string& text);

// Frames as --frames takes them: "1-5", "1-9x2", "3,8". `step` is the sign before a step.
std::string frames_text(const std::vector<int>& frames, char step = 'x');

}  // namespace brume
