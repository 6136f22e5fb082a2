#include "render/output/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace brume {
namespace {

// 0 / 0 is no difference at all.
double ratio(double difference, double reference) {
  return difference == 0.0 ? 0.0 : difference / reference;
}

}  // namespace

Comparison compare(std::span<const ChannelPair> channels) {
  Comparison result;
  double squared_difference = 0.0;
  double squared_reference = 0.0;
  double difference = 0.0;
  double reference = 0.0;
  for (const auto& [a, b] : channels) {
    assert(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::isinf(a[i]) && a[i] == b[i]) continue;
      if (!std::isfinite(a[i]) || !std::isfinite(b[i])) {
        ++result.incomparable;
        continue;
      }
      const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
      squared_difference += d * d;
      squared_reference += static_cast<double>(b[i]) * static_cast<double>(b[i]);
      difference += d;
      reference += static_cast<double>(b[i]);
      result.max_error = std::max(result.max_error, std::abs(d));
    }
  }
  result.rel_rmse = ratio(std::sqrt(squared_difference), std::sqrt(squared_reference));
  result.bias = ratio(difference, reference);
  return result;
}

std::vector<std::string> layer_channels(const ImageLayers& image, const std::string& layer) {
  if (image.channels.contains(layer)) return {layer};
  const std::string prefix = layer.empty() ? "" : layer + ".";
  std::vector<std::string> names{prefix + "R", prefix + "G", prefix + "B"};
  const bool has_all = std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return image.channels.contains(name);
  });
  return has_all ? names : std::vector<std::string>{};
}

}  // namespace brume
