#include "render/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "render/reference/reference_pixels.h"

namespace brume {

std::optional<ErrorSample> ErrorSample::take(const Scene& scene, const Camera& camera,
                                             const Frame& guide, std::size_t count,
                                             std::uint64_t seed, double tolerance,
                                             std::stop_token stop,
                                             const std::function<void(double)>& progress) {
  const std::size_t total = guide.depth.size();
  std::vector<double> square(total);
  double sum = 0.0;
  for (std::size_t i = 0; i < total; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = static_cast<double>(guide.airlight[3 * i + k]);
      square[i] += x * x;
    }
    sum += square[i];
  }

  // Systematic sampling: one random offset, then even steps through the cumulated probabilities,
  // which spreads the pixels over the rows of the frame.
  std::mt19937_64 random(seed);
  const double offset = static_cast<double>(random() >> 11) * 0x1p-53;
  ErrorSample sample;
  double cumulated = 0.0;
  for (std::size_t i = 0; i < total; ++i) {
    const double even = 1.0 / static_cast<double>(total);
    const double probability = sum > 0.0 ? 0.5 * even + 0.5 * square[i] / sum : even;
    const double before = cumulated * static_cast<double>(count);
    cumulated += probability;
    const double after = cumulated * static_cast<double>(count);
    // A bright pixel may be met several times; it is evaluated once and counts as often.
    const double times = std::ceil(after - offset) - std::ceil(before - offset);
    if (times > 0.0) {
      sample.pixels_.push_back(
          {i, times / (probability * static_cast<double>(count)), glm::dvec3(0.0)});
    }
  }

  std::vector<std::size_t> indices;
  for (const Pixel& pixel : sample.pixels_) indices.push_back(pixel.index);
  const ReferencePixels reference(scene, camera, guide.film, guide.time, tolerance);
  const std::vector<glm::dvec3> airlight = reference.airlight(indices, stop, progress);
  if (airlight.size() != indices.size()) return std::nullopt;
  for (std::size_t k = 0; k < airlight.size(); ++k) sample.pixels_[k].airlight = airlight[k];
  return sample;
}

ErrorEstimate ErrorSample::measure(const Frame& frame) const {
  // The ratio of two estimated sums, and its variance by the spread of their linear combination.
  std::vector<double> errors;
  std::vector<double> squares;
  double error = 0.0;
  double square = 0.0;
  for (const Pixel& pixel : pixels_) {
    double e = 0.0;
    double s = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double truth = pixel.airlight[static_cast<int>(k)];
      const double d = static_cast<double>(frame.airlight[3 * pixel.index + k]) - truth;
      e += d * d;
      s += truth * truth;
    }
    errors.push_back(pixel.weight * e);
    squares.push_back(pixel.weight * s);
    error += errors.back();
    square += squares.back();
  }
  ErrorEstimate estimate;
  estimate.pixels = pixels_.size();
  if (!(square > 0.0)) return estimate;
  const double ratio = error / square;
  double spread = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double d = errors[i] - ratio * squares[i];
    spread += d * d;
  }
  // The relative RMSE is the root of the ratio; squared errors have long tails, so the interval is
  // made on its logarithm, where it is nearly even, at 2.5 standard deviations instead of 1.96.
  const double relative = ratio > 0.0 ? std::sqrt(spread) / square / ratio : 0.0;
  estimate.rel_rmse = std::sqrt(ratio);
  const double factor = std::exp(0.5 * 2.5 * relative);
  estimate.low = estimate.rel_rmse / factor;
  estimate.high = estimate.rel_rmse * factor;
  return estimate;
}

}  // namespace brume
