#include "tools/brume/submit/slurm_submission.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <thread>
#include <utility>

#include "core/io/disk/content_hash.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/submit/slurm_job.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr int max_attempts = 5;

std::vector<std::vector<int>> chunks_of(const std::vector<int>& frames, std::size_t size) {
  std::vector<std::vector<int>> chunks;
  for (std::size_t i = 0; i < frames.size(); i += size) {
    chunks.emplace_back(
        frames.begin() + static_cast<std::ptrdiff_t>(i),
        frames.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, frames.size())));
  }
  return chunks;
}

// Eight digits that other texts do not have.
std::string short_hash(const std::string& text) {
  ContentHash hash;
  hash.add(std::span<const char>(text));
  std::string digits;
  for (int i = 0; i < 8; ++i) digits += "0123456789abcdef"[hash.value() >> 4 * i & 15];
  return digits;
}

SlurmJob new_job(const SequenceJob& sequence, const std::vector<std::string>& sbatch) {
  const fs::path output = sequence.output();
  SlurmJob job;
  job.name = "brume-" + sequence.stem() + "-" + short_hash(output.string());
  job.script = output.parent_path() / (sequence.stem() + ".sbatch");
  job.command = {fs::read_symlink("/proc/self/exe").string(), "render"};
  for (std::string& argument : sequence.options.arguments(sequence.own_options)) {
    job.command.push_back(std::move(argument));
  }
  job.command.push_back("--skip-existing");
  job.options = sbatch;
  return job;
}

// Until no task of a job is queued or running.
void watch(const SequenceJob& sequence, const FrameFingerprint& fingerprint,
           const std::string& id) {
  const std::vector<int> frames = sequence.options.frames();
  const ProgressLine line("job " + id);
  const auto progress = line.progress();
  while (unfinished_tasks(id) > 0) {
    check_interrupted();
    if (progress) {
      const auto rest = static_cast<double>(sequence.not_current(frames, fingerprint).size());
      progress(1.0 - rest / static_cast<double>(frames.size()));
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

// Frames of which the logs of a job tell an error, which is passed on.
std::set<int> frames_that_failed(const SlurmJob& job, const std::string& id) {
  std::set<int> frames;
  for (std::size_t task = 0; task < job.chunks.size(); ++task) {
    const fs::path file = job.log(id, std::to_string(task));
    std::error_code error;
    if (!fs::is_regular_file(file, error)) continue;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
      constexpr std::string_view begin = "brume: error: frame ";
      if (!line.starts_with(begin)) continue;
      frames.insert(std::atoi(line.c_str() + begin.size()));
      print_note(line.substr(std::string_view("brume: ").size()));
    }
  }
  return frames;
}

}  // namespace

ExitCode submit_to_slurm(const SequenceJob& sequence, const FrameFingerprint& fingerprint,
                         const SlurmOptions& options) {
  SlurmJob job = new_job(sequence, options.sbatch);
  const std::vector<int> all = sequence.options.frames();
  std::vector<int> wanted = sequence.not_current(all, fingerprint);
  std::vector<int> failed;
  nlohmann::ordered_json result{{"jobs", nlohmann::json::array()}};
  const auto submit_video = [&](const std::string& after) {
    if (sequence.video.empty()) return;
    result["video"] = submit_after(
        after, job.name + "-video",
        sequence.video_command(FramePattern::parse(sequence.output().string())->printf_text(),
                               fs::absolute(sequence.video).lexically_normal()));
  };
  for (int attempt = 0; attempt < max_attempts && !wanted.empty(); ++attempt) {
    job.chunks = chunks_of(wanted, sequence.chunk);
    const std::string id = submit(job);
    result["jobs"].push_back(id);
    if (!options.watches) {
      submit_video(id);
      result["submitted"] = wanted;
      print_result(result.dump() + "\n");
      return done;
    }
    watch(sequence, fingerprint, id);
    wanted = sequence.not_current(wanted, fingerprint);
    const std::set<int> told = frames_that_failed(job, id);
    std::erase_if(wanted, [&](int frame) {
      if (told.contains(frame)) failed.push_back(frame);
      return told.contains(frame);
    });
    if (!wanted.empty()) {
      print_note("frames " + frames_text(wanted) + " were lost with their tasks");
    }
  }
  result["done"] = all.size() - failed.size() - wanted.size();
  result["failed"] = failed;
  result["lost"] = wanted;
  const bool is_whole = failed.empty() && wanted.empty();
  if (is_whole) submit_video("");
  print_result(result.dump() + "\n");
  return is_whole ? done : check_failed;
}

}  // namespace brume
