#include "tools/bench/measure/fog_banks.h"

#include "tools/bench/scenes/benchmark_scenes.h"

namespace brume {
namespace {

constexpr double max_error = 0.02;

FogBankRow measure_bank(int count, bool quick) {
  const Scene scene = fog_bank(count);
  const ReferenceSample reference = find_reference(scene, quick ? 50 : 200, 1e-3);
  FogBankRow row{.gaussians = count};
  for (const int slices : {8, 12, 16, 24, 32, 48}) {
    Settings settings = sliced_settings({}, slices);
    settings.airlight_scale = 4;
    Renderer renderer;
    row.measurement = measure(renderer, scene, settings, reference.sample, quick ? 0.5 : 2.0);
    if (row.measurement.error.rel_rmse <= max_error) break;
  }
  const Settings& merging = row.measurement.settings;
  Renderer renderer;
  const auto frame = renderer.render(scene, scene.camera, scene.film, merging);
  row.merged = frame->statistics.gaussians_merged;
  Settings plain = merging;
  plain.merge_error = 0.0;
  row.unmerged_ratio =
      frame_time_ratio({Renderer(), Renderer()}, scene, {merging, plain}, quick ? 3 : 9);
  return row;
}

}  // namespace

std::vector<FogBankRow> measure_fog_banks(bool quick) {
  std::vector<int> counts{10'000};
  if (!quick) counts.insert(counts.end(), {100'000, 1'000'000});
  std::vector<FogBankRow> rows;
  for (const int count : counts) rows.push_back(measure_bank(count, quick));
  return rows;
}

}  // namespace brume
