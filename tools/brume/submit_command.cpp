#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "brume/error.h"
#include "core/io/content_hash.h"
#include "core/io/file_bytes.h"
#include "core/number_domain.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/frame_fingerprint.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/render_options.h"
#include "tools/brume/slurm_job.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

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

class SubmitCommand final : public Command {
 public:
  explicit SubmitCommand(CLI::App& app) : options_(with_scheduler(app)) {
    app.add_option("--chunk", chunk_, "frames of a task")
        ->check(finite_in(1, 100'000))
        ->capture_default_str();
    app.add_option("--sbatch", sbatch_,
                   "an option of sbatch without its dashes, such as mem=4G; several times");
    app.add_option("--video", video_, "an .mp4 of .png frames, made by ffmpeg when all are there")
        ->type_name("FILE");
    app.add_flag("--watch", watches_,
                 "wait for the frames, tell how many are done, and submit again what was lost");
    app.footer(
        "All options of brume render are those of the frames, which --skip-existing leaves "
        "alone where\nthey are current. The script and the logs of tasks lie beside the frames.");
    own_ = {"SCHEDULER", "chunk", "sbatch", "video", "watch"};
  }

  ExitCode run() override {
    options_.check();
    if (!options_.is_sequence()) throw UsageError("--frames is required: a farm makes sequences");
    check_video();
    static_cast<void>(options_.outputs());
    CommandFiles files;
    std::vector<fs::path> missing;
    const FrameFingerprint fingerprint(read_document(options_.scene_file(), files, missing),
                                       options_.what_matters(own_));
    fingerprint_ = &fingerprint;
    SlurmJob job = new_job();
    const std::vector<int> all = options_.frames();
    std::vector<int> wanted = not_current(all);
    nlohmann::ordered_json result{{"jobs", nlohmann::json::array()}};
    std::vector<int> failed;
    for (int attempt = 0; attempt < max_attempts && !wanted.empty(); ++attempt) {
      job.chunks = chunks_of(wanted, chunk_);
      const std::string id = submit(job);
      result["jobs"].push_back(id);
      if (!watches_) {
        if (!video_.empty())
          result["video"] = submit_after(id, job.name + "-video", video_command());
        result["submitted"] = wanted;
        print_result(result.dump() + "\n");
        return done;
      }
      watch(id, all);
      wanted = not_current(wanted);
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
    if (failed.empty() && wanted.empty() && !video_.empty()) {
      result["video"] = submit_after("", job.name + "-video", video_command());
    }
    print_result(result.dump() + "\n");
    return failed.empty() && wanted.empty() ? done : check_failed;
  }

 private:
  static constexpr int max_attempts = 5;

  CLI::App& with_scheduler(CLI::App& app) {
    app.add_option("SCHEDULER", scheduler_, "slurm")->type_name("TEXT:{slurm}")->required()->check(CLI::IsMember({"slurm"}));
    return app;
  }

  void check_video() const {
    if (video_.empty()) return;
    const std::vector<int> frames = options_.frames();
    for (std::size_t i = 1; i < frames.size(); ++i) {
      if (frames[i] != frames[i - 1] + 1) {
        throw UsageError("--video: allowed: of frames that follow each other");
      }
    }
    if (lower_case_extension(options_.output()) != ".png") {
      throw UsageError("--video: allowed: of .png frames");
    }
  }

  [[nodiscard]] std::vector<std::string> video_command() const {
    return {"ffmpeg",
            "-y",
            "-loglevel",
            "error",
            "-framerate",
            quoted_text(options_.frames_per_second()),
            "-start_number",
            std::to_string(options_.frames().front()),
            "-i",
            fs::absolute(options_.output()).string(),
            "-pix_fmt",
            "yuv420p",
            fs::absolute(video_).string()};
  }

  [[nodiscard]] SlurmJob new_job() const {
    const fs::path output = fs::absolute(options_.output()).lexically_normal();
    std::string stem = output.stem().string();
    std::erase_if(stem,
                  [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; });
    SlurmJob job;
    job.name = "brume-" + stem + "-" + short_hash(output.string());
    job.script = output.parent_path() / (stem + ".sbatch");
    job.command = {fs::read_symlink("/proc/self/exe").string(), "render"};
    for (std::string& argument : options_.arguments(own_))
      job.command.push_back(std::move(argument));
    job.command.push_back("--skip-existing");
    job.options = sbatch_;
    return job;
  }

  [[nodiscard]] std::vector<int> not_current(const std::vector<int>& frames) const {
    const FramePattern outputs = options_.output_pattern();
    std::vector<int> rest;
    for (const int frame : frames) {
      if (fingerprint_of(outputs.file_of(frame)) != fingerprint_->of(frame)) rest.push_back(frame);
    }
    return rest;
  }

  void watch(const std::string& id, const std::vector<int>& frames) const {
    const ProgressLine line("job " + id);
    const auto progress = line.progress();
    while (unfinished_tasks(id) > 0) {
      check_interrupted();
      if (progress) {
        progress(1.0 - static_cast<double>(not_current(frames).size()) /
                           static_cast<double>(frames.size()));
      }
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }

  // Frames of which the logs of a job tell an error, which is passed on.
  [[nodiscard]] static std::set<int> frames_that_failed(const SlurmJob& job,
                                                        const std::string& id) {
    std::set<int> frames;
    std::string log = job.log().string();
    log.replace(log.find("%A"), 2, id);
    for (std::size_t task = 0; task < job.chunks.size(); ++task) {
      std::string file = log;
      file.replace(file.find("%a"), 2, std::to_string(task));
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

  std::string scheduler_;
  std::vector<std::string> own_;
  RenderOptions options_;
  std::size_t chunk_ = 10;
  std::vector<std::string> sbatch_;
  std::string video_;
  bool watches_ = false;
  const FrameFingerprint* fingerprint_ = nullptr;
};

}  // namespace

std::unique_ptr<Command> make_submit_command(CLI::App& app) {
  return std::make_unique<SubmitCommand>(app);
}

}  // namespace brume
