#include "render/cpu/halved_cells.h"

#include <array>
#include <cmath>

namespace brume {
namespace {

// Row by row, a pixel of the film at every second place of a cell: its corners, which are samples,
// the middles of its sides and its center.
constexpr int nodes_across = 3;

std::size_t index_of(const Frame& frame, const glm::ivec2& pixel) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(frame.film.width) +
         static_cast<std::size_t>(pixel.x);
}

glm::vec4 airlight_of(const Frame& frame, const glm::ivec2& pixel) {
  const std::size_t i = index_of(frame, pixel);
  const float* const rgb = &frame.airlight[3 * i];
  return {rgb[0], rgb[1], rgb[2], frame.transmittance[3 * i]};
}

struct Nodes {
  std::array<glm::vec4, nodes_across * nodes_across> values;
  std::array<float, nodes_across * nodes_across> distances;

  Nodes(const Frame& frame, const CurvedCell& cell) {
    for (int k = 0; k < nodes_across * nodes_across; ++k) {
      const glm::ivec2 pixel = cell.first + 2 * glm::ivec2(k % nodes_across, k / nodes_across);
      values[static_cast<std::size_t>(k)] = airlight_of(frame, pixel);
      distances[static_cast<std::size_t>(k)] = frame.depth[index_of(frame, pixel)];
    }
  }
};

// A quarter of a cell: 2 x 2 pixels between four nodes.
struct Quarter {
  const Nodes& nodes;
  int x, y;  // 0 or 1

  [[nodiscard]] bool is_linear(const AirlightSamples& samples) const {
    const auto value = [&](int column, int row) -> const glm::vec4& {
      return nodes.values[static_cast<std::size_t>(nodes_across * row + column)];
    };
    const auto is_straight = [&](const glm::vec4& a, const glm::vec4& b, const glm::vec4& c) {
      return samples.curvature_of(a, b, c) <= 1.0f;
    };
    return is_straight(value(0, y), value(1, y), value(2, y)) &&
           is_straight(value(0, y + 1), value(1, y + 1), value(2, y + 1)) &&
           is_straight(value(x, 0), value(x, 1), value(x, 2)) &&
           is_straight(value(x + 1, 0), value(x + 1, 1), value(x + 1, 2));
  }

  // At pixel (px, py) of the quarter, 0 or 1 each.
  template <class Value>
  [[nodiscard]] Value mix(const std::array<Value, nodes_across * nodes_across>& of, int px,
                          int py) const {
    const auto node_at = [&](int column, int row) {
      return of[static_cast<std::size_t>(nodes_across * row + column)];
    };
    const float fx = 0.5f * static_cast<float>(px);
    const float fy = 0.5f * static_cast<float>(py);
    const Value above = node_at(x, y) + fx * (node_at(x + 1, y) - node_at(x, y));
    const Value below = node_at(x, y + 1) + fx * (node_at(x + 1, y + 1) - node_at(x, y + 1));
    return above + fy * (below - above);
  }
};

}  // namespace

HalvedCells::HalvedCells(const AirlightSamples& samples)
    : samples_(samples),
      is_curved_(static_cast<std::size_t>(samples.film().width) *
                     static_cast<std::size_t>(samples.film().height),
                 0),
      is_requested_(samples.frame().depth.size(), 0) {}

void HalvedCells::add(const Missing& missing) {
  for (const glm::ivec2& pixel : missing.pixels) {
    is_requested_[index_of(samples_.frame(), pixel)] = 1;
  }
  for (const CurvedCell& cell : missing.cells) {
    is_curved_[samples_.index(cell.first.x / 4, cell.first.y / 4)] = 1;
  }
}

bool HalvedCells::is_curved(const glm::ivec2& first_pixel) const {
  return is_curved_[samples_.index(first_pixel.x / 4, first_pixel.y / 4)] != 0;
}

std::vector<glm::ivec2> HalvedCells::nodes(std::span<const CurvedCell> cells) const {
  std::vector<glm::ivec2> nodes;
  for (const CurvedCell& cell : cells) {
    const auto add = [&](const glm::ivec2& offset) {
      const glm::ivec2 node = cell.first + offset;
      if (is_requested_[index_of(samples_.frame(), node)] == 0) nodes.push_back(node);
    };
    add({2, 0});
    add({0, 2});
    add({2, 2});
    if (!is_curved(cell.first + glm::ivec2(4, 0))) add({4, 2});
    if (!is_curved(cell.first + glm::ivec2(0, 4))) add({2, 4});
  }
  return nodes;
}

std::vector<glm::ivec2> fill_halved_cells(const AirlightSamples& samples,
                                          std::span<const CurvedCell> cells, float tolerance,
                                          Frame& frame) {
  std::vector<glm::ivec2> remaining;
  for (const CurvedCell& cell : cells) {
    const Nodes at(frame, cell);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Quarter part{at, quarter % 2, quarter / 2};
      const bool is_linear = part.is_linear(samples);
      for (int k = 0; k < 4; ++k) {
        const glm::ivec2 place(2 * part.x + k % 2, 2 * part.y + k / 2);
        const bool is_node = k == 0;
        if (is_node || (cell.missing >> (4 * place.y + place.x) & 1) == 0) continue;
        const glm::ivec2 pixel = cell.first + place;
        const float distance = frame.depth[index_of(frame, pixel)];
        const bool lies_between =
            cell.is_open ? std::isinf(distance)
                         : std::abs(distance - part.mix(at.distances, k % 2, k / 2)) <= tolerance;
        if (is_linear && lies_between) {
          set_airlight(frame, index_of(frame, pixel), part.mix(at.values, k % 2, k / 2));
        } else {
          remaining.push_back(pixel);
        }
      }
    }
  }
  return remaining;
}

}  // namespace brume
