#include "brume/frame.h"

namespace brume {
void add_time(std::vector<StageTime>& stages, Stage stage, double milliseconds) {
  const auto known = std::ranges::find(stages, stage, &StageTime::stage);
  if (known == stages.end()) {
    stages.push_back({stage, milliseconds});
  } else {
    known->milliseconds += milliseconds;
  }
}

std::optional<RelativeNoise> relative_noise(const Frame& frame) {
  const std::optional<PathNoise>& noise = frame.statistics.path_noise;
  if (!noise) return std::nullopt;
  // `stride` values per pixel, the first three of which count.
  const auto relative = [](double variance, const std::vector<float>& layer, std::size_t stride) {
    double square = 0.0;
    for (std::size_t i = 0; i < layer.size(); i += stride) {
      for (std::size_t c = 0; c < 3; ++c) {
        square += static_cast<double>(layer[i + c]) * static_cast<double>(layer[i + c]);
      }
    }
    return square > 0.0 ? std::sqrt(variance / square) : 0.0;
  };
  return RelativeNoise{
      noise->paths, relative(noise->airlight_variance, frame.airlight, 3),
      relative(noise->airlight_variance + noise->surface_variance, frame.beauty, 4)};
}

float exposure_gain(double stops) {
  // Sixty stops make anything black or white; more would overflow, and NaN is no exposure.
  return static_cast<float>(std::exp2(std::isfinite(stops) ? std::clamp(stops, -60.0, 60.0) : 0.0));
}

}  // namespace brume
