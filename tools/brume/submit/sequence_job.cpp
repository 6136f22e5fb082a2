#include "tools/brume/submit/sequence_job.h"

#include <algorithm>
#include <cctype>

#include "core/io/disk/file_bytes.h"
#include "core/io/mp4_arguments.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "tools/brume/command.h"

namespace brume {
namespace fs = std::filesystem;

void SequenceJob::check_video() const {
  if (video.empty()) return;
  const std::vector<int> frames = options.frames();
  for (std::size_t i = 1; i < frames.size(); ++i) {
    if (frames[i] != frames[i - 1] + 1) {
      throw UsageError("--video: allowed: of frames that follow each other");
    }
  }
  if (lower_case_extension(options.output()) != ".png") {
    throw UsageError("--video: allowed: of .png frames");
  }
}

void SequenceJob::check_names() const {
  for (const std::string& argument : options.arguments(own_options)) check_line(argument);
  if (!video.empty()) check_line(fs::absolute(video).string());
}

std::vector<std::string> SequenceJob::video_command(const std::string& frames,
                                                    const std::string& file) const {
  std::vector<std::string> command{"ffmpeg",
                                   "-y",
                                   "-loglevel",
                                   "error",
                                   "-framerate",
                                   quoted_text(frames_per_second),
                                   "-start_number",
                                   std::to_string(options.frames().front()),
                                   "-i",
                                   frames};
  command.insert(command.end(), mp4_arguments.begin(), mp4_arguments.end());
  command.push_back(file);
  return command;
}

fs::path SequenceJob::output() const {
  return fs::absolute(options.output()).lexically_normal();
}

std::string SequenceJob::stem() const {
  // The name without the frame's number and the extension.
  const fs::path file = options.output_pattern().file_without_number();
  std::string stem = fs::path("_" + file.filename().string()).stem().string().substr(1);
  std::erase_if(stem, [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; });
  while (stem.ends_with('_') || stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? "frames" : stem;
}

std::vector<int> SequenceJob::not_current(const std::vector<int>& frames,
                                          const FrameFingerprint& fingerprint) const {
  const FramePattern outputs = options.output_pattern();
  std::vector<int> rest;
  for (const int frame : frames) {
    if (fingerprint_of(outputs.file_of(frame)) != fingerprint.of(frame)) rest.push_back(frame);
  }
  return rest;
}

void check_line(const std::string& text) {
  if (std::ranges::none_of(text, [](unsigned char c) { return std::iscntrl(c) != 0; })) return;
  throw UsageError("found " + quoted_text(text) +
                   "; allowed for a scheduler: without control characters");
}

std::string frames_text(const std::vector<int>& frames, char step_sign) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    // Takes as many as follow in equal steps.
    const int step = i + 1 < frames.size() ? frames[i + 1] - frames[i] : 1;
    std::size_t end = i + 1;
    while (end < frames.size() && step > 0 && frames[end] - frames[end - 1] == step) ++end;
    if (end - i == 2 && step > 1) end = i + 1;
    text += (text.empty() ? "" : ",") + std::to_string(frames[i]);
    if (end - i > 1) text += "-" + std::to_string(frames[end - 1]);
    if (end - i > 1 && step > 1) text += step_sign + std::to_string(step);
    i = end;
  }
  return text;
}

}  // namespace brume
