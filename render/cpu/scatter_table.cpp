#include "render/cpu/scatter_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brume {
namespace {

constexpr std::size_t intervals = 1024;
constexpr float greatest_root = 5.0f;  // nothing comes through T = 25

}  // namespace

template <class Spread>
ScatterTable::ScatterTable(const Spread& spread) {
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double root = greatest_root * static_cast<double>(i) / intervals;
    const double T = root * root;
    const ZonalSh<double> zonal = spread(T);
    Bands& bands = nodes_.emplace_back();
    for (std::size_t l = 0; l < bands.size(); ++l) {
      const double to_factor = std::sqrt(4.0 * std::numbers::pi / (2.0 * double(l) + 1.0));
      bands[l] = static_cast<float>(T * std::exp(-T) * to_factor * zonal[l]);
    }
  }
}

const ScatterTable& ScatterTable::point() {
  static const ScatterTable table(SpreadTable::point());
  return table;
}

const ScatterTable& ScatterTable::distant() {
  static const ScatterTable table(SpreadTable::distant());
  return table;
}

const ScatterTable& ScatterTable::paper() {
  static const ScatterTable table([](double) { return paper_point_spread_sh; });
  return table;
}

ScatterTable::Bands ScatterTable::operator()(float T) const {
  const float at = std::sqrt(std::max(T, 0.0f)) * (intervals / greatest_root);
  Bands result{};
  if (!(at < static_cast<float>(intervals))) return result;
  const auto cell = static_cast<std::size_t>(at);
  const float t = at - static_cast<float>(cell);
  for (std::size_t l = 0; l < result.size(); ++l) {
    result[l] = nodes_[cell][l] + t * (nodes_[cell + 1][l] - nodes_[cell][l]);
  }
  return result;
}

}  // namespace brume
