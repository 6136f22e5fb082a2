#include "tools/bench/measure/shot.h"

#include <tbb/info.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/io/disk/file_bytes.h"
#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// Removed at the end.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("brume-shot-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] std::string frame(int workers, const std::string& number) const {
    return (path_ / (std::to_string(workers) + "_" + number + ".exr")).string();
  }

 private:
  fs::path path_;
};

ShotRow run_shot(const RunBrume& run_brume, const Folder& folder, int frames, int workers) {
  const int threads = std::max(1, tbb::info::default_concurrency() / workers);
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::future<std::string>> running;
  for (int k = 0; k < workers; ++k) {
    const std::string range =
        std::to_string(k) + "-" + std::to_string(frames - 1) + "x" + std::to_string(workers);
    running.push_back(std::async(std::launch::async, [&, range] {
      return run_brume({"render", sample_scene_file("stage").string(), "--frames", range, "--size",
                        "480x270", "--airlight", "sliced", "--airlight-scale", "4", "--scattering",
                        "single", "--backend", "cpu", "--threads", std::to_string(threads), "-o",
                        folder.frame(workers, "%04d")});
    }));
  }
  double lost = 0.0;
  for (std::future<std::string>& worker : running) {
    const auto seconds = nlohmann::json::parse(worker.get())["seconds"];
    lost += seconds["reading"].get<double>() + seconds["waiting_for_files"].get<double>();
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {workers, taken.count(), 3600.0 * frames / taken.count(),
          lost / (workers * taken.count())};
}

std::string number_of(int frame) {
  std::string number = std::to_string(frame);
  return std::string(4 - number.size(), '0') + number;
}

}  // namespace

std::vector<ShotRow> measure_shot(const RunBrume& run_brume, bool quick) {
  const Folder folder;
  const int frames = quick ? 8 : 48;
  const std::vector<ShotRow> rows{run_shot(run_brume, folder, frames, 1),
                                  run_shot(run_brume, folder, frames, 2)};
  for (int frame = 0; frame < frames; ++frame) {
    const std::string number = number_of(frame);
    if (read_bytes(folder.frame(1, number)) != read_bytes(folder.frame(2, number))) {
      throw std::runtime_error("one worker and two make different frames " + number);
    }
  }
  return rows;
}

}  // namespace brume
