#include "render/optical_depth/ray_slices.h"

#include <algorithm>

namespace brume {
namespace {

// Four nodes of a tile, and bilinear interpolation between them.
struct Cell {
  std::array<const float*, 4> corners;  // row by row

  Cell(const SliceNodes& nodes, std::size_t first)
      : corners{nodes.boundaries[first], nodes.boundaries[first + 1], nodes.boundaries[first + 3],
                nodes.boundaries[first + 4]} {}

  [[nodiscard]] float at(std::size_t k, float x, float y) const {
    const float above = corners[0][k] + x * (corners[1][k] - corners[0][k]);
    const float below = corners[2][k] + x * (corners[3][k] - corners[2][k]);
    return above + y * (below - above);
  }
};

// Places of a group's rays in the cells of their tile.
struct GroupPositions {
  std::array<std::size_t, RaySlices::group> cells;  // the first node of each
  std::array<float, RaySlices::group> x, y;         // from 0 to 1
  bool share_cell = true;

  // Padding rays repeat the last ray of a group.
  explicit GroupPositions(std::span<const glm::vec2> positions) {
    for (std::size_t i = 0; i < RaySlices::group; ++i) {
      const glm::vec2 position = 2.0f * positions[std::min(i, positions.size() - 1)];
      const glm::vec2 first(position.x < 1.0f ? 0.0f : 1.0f, position.y < 1.0f ? 0.0f : 1.0f);
      cells[i] = static_cast<std::size_t>(first.x) + 3 * static_cast<std::size_t>(first.y);
      x[i] = position.x - first.x;
      y[i] = position.y - first.y;
      share_cell = share_cell && cells[i] == cells[0];
    }
  }
};

}  // namespace

void RaySlices::resize(std::size_t count, const PathBatch& rays) {
  count_ = count;
  t_.resize(count * rays.padded_size());
  nearest_.resize(count * rays.padded_size() / group);
  farthest_.resize(nearest_.size());
}

void RaySlices::interpolate(const SliceNodes& nodes, std::span<const glm::vec2> positions,
                            const PathBatch& rays) {
  resize(nodes.count, rays);
  for (std::size_t first = 0; first < positions.size(); first += group) {
    const GroupPositions group_positions(positions.subspan(first));
    const auto& [cells, x, y, share_cell] = group_positions;
    const float* const lengths = rays.length.data() + first;
    float* const nearest = nearest_.data() + first / group * count_;
    float* const farthest = farthest_.data() + first / group * count_;
    const Cell first_cell(nodes, cells[0]);
    std::array<float, group> before{};
    for (std::size_t k = 0; k < count_; ++k) {
      float* const t = t_.data() + (first / group * count_ + k) * group;
      std::array<float, group> now;
      if (share_cell) {
        for (std::size_t i = 0; i < group; ++i) now[i] = first_cell.at(k, x[i], y[i]);
      } else {
        for (std::size_t i = 0; i < group; ++i) now[i] = Cell(nodes, cells[i]).at(k, x[i], y[i]);
      }
      // Rounding must not turn slices round.
      for (std::size_t i = 0; i < group; ++i) before[i] = before[i] < now[i] ? now[i] : before[i];
      for (std::size_t i = 0; i < group; ++i)
        t[i] = before[i] < lengths[i] ? before[i] : lengths[i];
      std::array<float, group> low = before;
      std::array<float, group> high = before;
      for (std::size_t half = group / 2; half > 0; half /= 2) {
        for (std::size_t i = 0; i < half; ++i) {
          low[i] = low[i] < low[i + half] ? low[i] : low[i + half];
          high[i] = high[i] < high[i + half] ? high[i + half] : high[i];
        }
      }
      nearest[k] = low[0];
      farthest[k] = high[0];
    }
  }
}

void RaySlices::assign(std::span<const float> boundaries, const PathBatch& rays) {
  resize(boundaries.size(), rays);
  for (std::size_t first = 0; first < rays.padded_size(); first += group) {
    for (std::size_t k = 0; k < count_; ++k) {
      float* const t = t_.data() + (first / group * count_ + k) * group;
      for (std::size_t i = 0; i < group; ++i) {
        t[i] = std::min(boundaries[k], rays.length[first + i]);
      }
      nearest_[first / group * count_ + k] = boundaries[k];
      farthest_[first / group * count_ + k] = boundaries[k];
    }
  }
}

void RaySlices::subdivide(std::size_t parts) {
  if (parts == 1 || count_ < 2) return;
  // `lanes` values for each boundary, group by group.
  const auto cut = [&](std::vector<float>& values, std::size_t lanes) {
    std::vector<float> all;
    all.reserve(values.size() * parts);
    const std::size_t groups = values.size() / (count_ * lanes);
    for (std::size_t g = 0; g < groups; ++g) {
      const float* source = values.data() + g * count_ * lanes;
      for (std::size_t k = 0; k + 1 < count_; ++k, source += lanes) {
        for (std::size_t part = 0; part < parts; ++part) {
          const float x = static_cast<float>(part) / static_cast<float>(parts);
          for (std::size_t i = 0; i < lanes; ++i) {
            all.push_back(source[i] + x * (source[lanes + i] - source[i]));
          }
        }
      }
      all.insert(all.end(), source, source + lanes);
    }
    values.swap(all);
  };
  cut(t_, group);
  cut(nearest_, 1);
  cut(farthest_, 1);
  count_ = (count_ - 1) * parts + 1;
}

}  // namespace brume
