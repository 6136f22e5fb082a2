#pragma once

#include <span>
#include <vector>

#include "brume/camera.h"
#include "brume/density_grid.h"
#include "brume/gaussian.h"
#include "brume/scene.h"

namespace brume {

// A view of a sequence that shows its entire first frame, lit from the side.
class SequenceView {
 public:
  SequenceView(const DensityGrid& first, const Film& film);

  // Pictures: radiance, red only, rows from the top.
  [[nodiscard]] std::vector<float> render(const DensityGrid& grid) const;
  [[nodiscard]] std::vector<float> render(std::span<const Gaussian> gaussians) const;

 private:
  Camera camera_;
  Film film_;
  Light light_;
};

// The sum of the squares of a - b, which are equally long.
double squares_between(std::span<const float> a, std::span<const float> b);

}  // namespace brume
