#pragma once

#include <cstdint>
#include <glm/ext/vector_int2.hpp>
#include <span>
#include <vector>

#include "render/cpu/upsampling.h"

namespace brume {

// The curved cells of a film, and pixels that are evaluated anyway. Written by all tiles at once,
// each where its pixels are.
class HalvedCells {
 public:
  explicit HalvedCells(const AirlightSamples& samples);

  void add(const Missing& missing);

  // After all tiles have added theirs: the nodes of cells that are to be evaluated, which are every
  // second pixel. Cells share them, also with those of other tiles.
  [[nodiscard]] std::vector<glm::ivec2> nodes(std::span<const CurvedCell> cells) const;

 private:
  [[nodiscard]] bool is_curved(const glm::ivec2& first_pixel) const;

  const AirlightSamples& samples_;
  std::vector<std::uint8_t> is_curved_;     // per sample: the cell right of and below it
  std::vector<std::uint8_t> is_requested_;  // per pixel
};

// Fills what can be interpolated of curved cells, when their nodes have been evaluated. tolerance:
// of the distance of surfaces [u]. Returns the pixels that remain.
std::vector<glm::ivec2> fill_halved_cells(const AirlightSamples& samples,
                                          std::span<const CurvedCell> cells, float tolerance,
                                          Frame& frame);

}  // namespace brume
