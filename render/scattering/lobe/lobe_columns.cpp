#include "render/scattering/lobe/lobe_columns.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

namespace brume {
namespace {

constexpr std::size_t column_index(int x, int y) {
  return static_cast<std::size_t>(y * LobeColumns::size.x + x);
}

constexpr std::size_t first_of(int layer) {
  return static_cast<std::size_t>(layer) * LobeColumns::count();
}

// 0: none is finite.
double median_of_finite(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

LobeColumns::LobeColumns(const CameraRays& rays, const RayCaster& ray_caster,
                         std::span<const Surface> surfaces, double start, double min_distance,
                         double medium_end)
    : eye_(rays.eye()), start_(start) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec2 place =
          glm::dvec2(rays.whole_size()) * glm::dvec2(x, y) / glm::dvec2(size.x - 1, size.y - 1);
      directions_.push_back(rays.whole_direction(place));
      offsets_.push_back(rays.whole_offset(place));
    }
  }
  std::vector<SurfaceHit> hits(count());
  ray_caster.first_hits(
      rays, directions_,
      rays.is_parallel() ? std::span(std::as_const(offsets_)) : std::span<const glm::dvec3>(),
      hits);
  for (std::size_t i = 0; i < count(); ++i) {
    SurfacePoint point;
    if (hits[i] && !hits[i].is_light()) {
      point = ray_caster.point(hits[i], eye_ + offsets_[i], directions_[i], surfaces);
    }
    surfaces_.push_back(hits[i].distance);
    points_.push_back(point.position);
    normals_.push_back(point.normal);
  }
  distance_ = std::max(median_of_finite(surfaces_) - start, min_distance);
  const auto is_finite = [](double distance) { return std::isfinite(distance); };
  const auto ended = static_cast<std::size_t>(std::ranges::count_if(surfaces_, is_finite));
  // Where most rays see the sky its light counts as far as that.
  constexpr double share_of_end = 1.0 / 6.0;
  if (2 * ended < count()) distance_ = std::max(distance_, share_of_end * (medium_end - start));
}

double LobeColumns::end(std::size_t column) const {
  constexpr double gathered = 0.75;
  return start_ + gathered * (surfaces_[column] - start_);
}

std::vector<bool> LobeColumns::hidden_on(int layer) const {
  std::vector<bool> is_hidden(count());
  for (std::size_t i = 0; i < count(); ++i) is_hidden[i] = hides(i, layer);
  return is_hidden;
}

bool LobeColumns::goes_on(std::size_t column, std::size_t neighbour, int layer) const {
  const glm::dvec3 passing = eye_ + offsets_[neighbour] + distance(layer) * directions_[neighbour];
  return glm::dot(passing - points_[column], normals_[column]) > 0.0;
}

template <class Visit>
void LobeColumns::each_seen_beside(const Place& place, const std::vector<bool>& is_hidden,
                                   Visit visit) const {
  for (int v = std::max(place.y - 1, 0); v <= std::min(place.y + 1, size.y - 1); ++v) {
    for (int u = std::max(place.x - 1, 0); u <= std::min(place.x + 1, size.x - 1); ++u) {
      if (!is_hidden[column_index(u, v)]) visit(column_index(u, v));
    }
  }
}

void LobeColumns::pass_by_hidden(std::span<glm::vec4> values) const {
  for (int layer = 0; layer < size.z; ++layer) {
    const std::vector<bool> is_hidden = hidden_on(layer);
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        const std::size_t column = column_index(x, y);
        if (!is_hidden[column]) continue;
        glm::vec4 sum(0.0f);
        float number = 0.0f;
        each_seen_beside({x, y, layer}, is_hidden, [&](std::size_t neighbour) {
          if (goes_on(column, neighbour, layer)) return;
          sum += values[first_of(layer) + neighbour];
          number += 1.0f;
        });
        if (number > 0.0f) values[first_of(layer) + column] = sum / number;
      }
    }
  }
}

void LobeColumns::fill_hidden(std::span<glm::vec4> values) const {
  for (int layer = 0; layer < size.z; ++layer) {
    std::vector<bool> is_hidden = hidden_on(layer);
    for (bool changes = true; changes;) {
      changes = false;
      const std::vector<bool> was_hidden = is_hidden;
      for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
          const std::size_t column = column_index(x, y);
          if (!was_hidden[column]) continue;
          const std::optional<glm::vec4> value = mean_continued(values, {x, y, layer}, was_hidden);
          if (!value) continue;
          values[first_of(layer) + column] = *value;
          is_hidden[column] = false;
          changes = true;
        }
      }
    }
  }
}

std::optional<glm::vec4> LobeColumns::mean_continued(std::span<const glm::vec4> values,
                                                     const Place& place,
                                                     const std::vector<bool>& is_hidden) const {
  glm::vec4 sum(0.0f);
  float number = 0.0f;
  each_seen_beside(place, is_hidden, [&](std::size_t neighbour) {
    sum += continued(values, place, neighbour);
    number += 1.0f;
  });
  if (number == 0.0f) return std::nullopt;
  return sum / number;
}

// A floor that goes on below the ray beside this one scatters to both alike, but more where the ray
// points down to it: from its end on the value changes as the one beside it does. A silhouette
// hides a place of which only that tells.
glm::vec4 LobeColumns::continued(std::span<const glm::vec4> values, const Place& place,
                                 std::size_t neighbour) const {
  const std::size_t column = column_index(place.x, place.y);
  const std::size_t layer = first_of(place.layer);
  if (!goes_on(column, neighbour, place.layer)) return values[layer + neighbour];
  if (place.layer == 0 || !hides(column, place.layer - 1)) return values[layer + column];
  const std::size_t nearer = first_of(place.layer - 1);
  return values[nearer + column] + values[layer + neighbour] - values[nearer + neighbour];
}

}  // namespace brume
