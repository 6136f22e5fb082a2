#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/bench/frontier.h"
#include "tools/bench/measurement.h"

namespace brume {

// What `brume bench` runs and finds.

struct BenchOptions {
  bool quick = false;                         // two minutes on two cores
  int threads = 0;                            // 0: all
  std::vector<std::filesystem::path> scenes;  // in place of the built-in ones
};

struct BenchScene {
  std::string name;
  Scene scene;
};

// A frame beside the reference, as PNGs.
struct BenchPicture {
  std::string setting;
  std::string frame, reference, error;
  double error_scale = 0.0;  // the error that is shown as white, beside the rms of the reference
};

struct SceneReport {
  std::string name;
  std::size_t gaussians = 0;
  std::size_t lights = 0;
  bool environment = false;
  Film film;
  double reference_cpu_milliseconds = 0.0;  // of a whole frame, from the pixels evaluated
  std::vector<Measurement> settings;
  BenchPicture picture;
};

struct CostCurve {
  std::string over;  // "Gaussians"
  std::vector<CostPoint> points;
  double exponent = 0.0;
};

struct TableOneRow {
  std::string name;
  double paper_fps = 0.0;
  Measurement measurement;
};

struct BenchReport {
  bool quick = false;
  int threads = 0;
  std::vector<SceneReport> scenes;
  std::vector<CostCurve> curves;
  std::vector<TableOneRow> table_one;
};

// The errors at which the fastest setting is asked for.
inline constexpr std::array bench_error_levels{0.003, 0.01, 0.02, 0.05, 0.1};

// `tell` hears what is measured next.
BenchReport run_bench(const BenchOptions& options,
                      const std::function<void(const std::string&)>& tell);

}  // namespace brume
