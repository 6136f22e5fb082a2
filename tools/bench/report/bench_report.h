#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/bench/errors/fog_errors.h"
#include "tools/bench/errors/scattering_errors.h"
#include "tools/bench/errors/unbiased_error.h"
#include "tools/bench/measure/cache_gains.h"
#include "tools/bench/measure/hard_cases.h"
#include "tools/bench/measure/measurement.h"
#include "tools/bench/measure/peers.h"
#include "tools/bench/measure/plan_decisions.h"

namespace brume {

// The results of `brume bench`.

// Error bounds for which the fastest settings are reported.
inline constexpr std::array bench_error_levels{0.003, 0.01, 0.02, 0.05, 0.1};

// A frame and the reference, as PNGs.
struct BenchPicture {
  std::string setting;
  std::string frame, reference, error;
  double error_scale = 0.0;  // the error displayed as white, relative to the rms of the reference
};

struct SceneReport {
  std::string name;
  std::size_t gaussians = 0;
  std::size_t lights = 0;
  bool environment = false;
  Film film;
  double reference_cpu_milliseconds = 0.0;  // of a full frame, from the pixels evaluated
  std::vector<Measurement> settings;
  std::vector<Measurement> on_gl;       // empty without that backend
  std::vector<OtherRendererRow> peers;  // what other programs take for the same picture
  BenchPicture picture;
};

struct CostCurve {
  std::string over;  // "Gaussians"
  std::vector<CostPoint> points;
  double exponent = 0.0;
};

// Frames by number of worker threads.
struct ThreadRow {
  int threads = 0;
  Spread milliseconds;
};

struct TableOneRow {
  std::string name;
  double paper_fps = 0.0;
  Measurement measurement;
  Spread all_orders_ratio;  // frame times, all orders of scattering over one
};

struct HardCaseRow {
  HardCase hard_case;
  HardCaseErrors errors;
};

struct BenchReport {
  std::string command;
  bool quick = false;
  int threads = 0;
  std::string gl_device;  // empty: no OpenGL was measured
  std::vector<SceneReport> scenes;
  std::vector<ThicknessRow> thickness;
  std::vector<SkyRow> skies;
  std::vector<ComparedError> patches;
  std::vector<InscatteringRow> glow;
  std::vector<ScaleRow> scales;
  std::vector<AllOrdersRow> all_orders;
  std::vector<LightKindRow> light_kinds;
  std::vector<SampleRow> samples;
  std::vector<ComparedError> point_light;     // on surfaces, as the next two
  std::vector<ComparedError> incident_light;  // of an environment
  std::vector<ComparedError> transfer;
  std::vector<NoiseDepthRow> noise_depths;
  std::vector<ComparedError> noise;
  std::vector<CostCurve> curves;
  std::vector<ThreadRow> thread_rows;
  std::vector<FogBankRow> fog_banks;
  std::vector<PlanSaving> savings;
  std::vector<HardCaseRow> hard_cases;
  std::vector<TableOneRow> table_one;
  std::vector<CacheGain> caches;
};

}  // namespace brume
