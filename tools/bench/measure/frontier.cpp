#include "tools/bench/measure/frontier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace brume {

std::vector<std::size_t> frontier(std::span<const Measurement> settings) {
  std::vector<std::size_t> order(settings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {},
                           [&](std::size_t i) { return settings[i].cpu_milliseconds.median; });
  std::vector<std::size_t> result;
  double min_error = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(settings[i].error.rel_rmse < min_error)) continue;
    min_error = settings[i].error.rel_rmse;
    result.push_back(i);
  }
  return result;
}

std::optional<std::size_t> cheapest_within(std::span<const Measurement> settings, double error) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!(settings[i].error.high <= error)) continue;
    if (!best || settings[i].cpu_milliseconds.median < settings[*best].cpu_milliseconds.median) {
      best = i;
    }
  }
  return best;
}

double fitted_exponent(std::span<const CostPoint> points) {
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const CostPoint& point : points) {
    const double u = std::log(point.size);
    const double v = std::log(point.cpu_milliseconds);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace brume
