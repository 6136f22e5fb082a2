#include "render/paths/environment_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/lights/environment.h"
#include "core/scene/lights/radiance_map.h"

namespace brume {
namespace {

using std::numbers::pi;

double brightness(const glm::vec3& radiance) {
  return static_cast<double>(radiance.x) + static_cast<double>(radiance.y) +
         static_cast<double>(radiance.z);
}

// The mean brightness of the bilinear map over each pixel: rows and columns of weights 1/8, 3/4,
// 1/8 over the neighbours, around horizontally and clamped at the poles, as look-ups are.
std::vector<double> pixel_means(const RadianceMap& map) {
  constexpr double side = 0.125;
  const auto width = static_cast<std::size_t>(map.width);
  std::vector<double> means(map.pixels.size());
  std::vector<double> column(width);
  for (int y = 0; y < map.height; ++y) {
    const int above = std::max(y - 1, 0);
    const int below = std::min(y + 1, map.height - 1);
    for (int x = 0; x < map.width; ++x) {
      column[static_cast<std::size_t>(x)] =
          (1.0 - 2.0 * side) * brightness(map.pixel(x, y)) +
          side * (brightness(map.pixel(x, above)) + brightness(map.pixel(x, below)));
    }
    for (std::size_t x = 0; x < width; ++x) {
      means[static_cast<std::size_t>(y) * width + x] =
          (1.0 - 2.0 * side) * column[x] +
          side * (column[(x + width - 1) % width] + column[(x + 1) % width]);
    }
  }
  return means;
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(const Environment& environment)
    : environment_(environment), to_world_(environment_rotation(environment)) {
  const RadianceMap& map = *environment.map;
  const double side = std::sqrt(static_cast<double>(map.pixels.size()) / max_cells);
  pixels_ = std::max(1, static_cast<int>(std::ceil(side)));
  columns_ = (map.width + pixels_ - 1) / pixels_;
  const int rows = (map.height + pixels_ - 1) / pixels_;
  const std::vector<double> means = pixel_means(map);
  std::vector<double> weights;
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows));
  double sum = 0.0;
  for (int row = 0; row < rows; ++row) {
    const int y0 = row * pixels_;
    const int y1 = std::min(y0 + pixels_, map.height);
    const double height = std::cos(pi * y0 / map.height) - std::cos(pi * y1 / map.height);
    for (int column = 0; column < columns_; ++column) {
      const int x0 = column * pixels_;
      const int x1 = std::min(x0 + pixels_, map.width);
      double mean = 0.0;
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
          mean += means[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
                        static_cast<std::size_t>(x)];
        }
      }
      mean /= (x1 - x0) * (y1 - y0);
      cells_[weights.size()].pdf = mean;
      weights.push_back(mean * height * 2.0 * pi * (x1 - x0) / map.width);
      sum += weights.back();
    }
  }
  if (!(sum > 0.0) || !(environment.intensity > 0.0)) {
    cells_.clear();
    return;
  }
  for (Cell& cell : cells_) cell.pdf /= sum;
  for (double& weight : weights) weight *= static_cast<double>(weights.size()) / sum;
  make_aliases(std::move(weights));
}

// `weights` have a mean of 1.
void EnvironmentSampler::make_aliases(std::vector<double> weights) {
  std::vector<std::uint32_t> small;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    (weights[i] < 1.0 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t low = small.back();
    const std::uint32_t high = large.back();
    small.pop_back();
    cells_[low].keep = weights[low];
    cells_[low].alias = high;
    weights[high] -= 1.0 - weights[low];
    if (weights[high] < 1.0) {
      large.pop_back();
      small.push_back(high);
    }
  }
  // Entries that rounding leaves over keep themselves.
}

glm::dvec3 EnvironmentSampler::radiance(const glm::dvec3& direction) const {
  return environment_.intensity *
         map_radiance(*environment_.map, glm::conjugate(to_world_) * direction);
}

glm::dvec3 EnvironmentSampler::sample(PathRandom& random) const {
  const double scaled = random.uniform() * static_cast<double>(cells_.size());
  auto cell = std::min(static_cast<std::size_t>(scaled), cells_.size() - 1);
  if (random.uniform() >= cells_[cell].keep) cell = cells_[cell].alias;
  const RadianceMap& map = *environment_.map;
  const int x0 = static_cast<int>(cell % static_cast<std::size_t>(columns_)) * pixels_;
  const int y0 = static_cast<int>(cell / static_cast<std::size_t>(columns_)) * pixels_;
  const int x1 = std::min(x0 + pixels_, map.width);
  const int y1 = std::min(y0 + pixels_, map.height);
  const double azimuth = ((x0 + random.uniform() * (x1 - x0)) / map.width - 0.5) * 2.0 * pi;
  const double top = std::cos(pi * y0 / map.height);
  const double bottom = std::cos(pi * y1 / map.height);
  const double y = top + random.uniform() * (bottom - top);
  const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
  return to_world_ * glm::dvec3(r * std::sin(azimuth), y, -r * std::cos(azimuth));
}

double EnvironmentSampler::pdf(const glm::dvec3& direction) const {
  if (empty()) return 0.0;
  const RadianceMap& map = *environment_.map;
  const glm::dvec2 place = map_position(map, glm::conjugate(to_world_) * direction);
  const int x = std::clamp(static_cast<int>(place.x), 0, map.width - 1) / pixels_;
  const int y = std::clamp(static_cast<int>(place.y), 0, map.height - 1) / pixels_;
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(x)]
      .pdf;
}

}  // namespace brume
