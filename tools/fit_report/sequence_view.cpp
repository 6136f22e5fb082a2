#include "tools/fit_report/sequence_view.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/renderer.h"
#include "tools/fit_report/grid_picture.h"

namespace brume {

SequenceView::SequenceView(const DensityGrid& first, const Film& film) : film_(film) {
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high = -low;
  for (const DensityGrid::Block& block : first.blocks) {
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 corner =
          block.corner + DensityGrid::side * glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
      const glm::dvec3 p = first.to_world(glm::dvec3(corner));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const glm::dvec3 center = 0.5 * (low + high);
  const double size = glm::length(high - low);
  camera_.target = center;
  camera_.eye = center + size * glm::dvec3(1.3, 0.4, 0.9);
  camera_.up = {0.0, 0.0, 1.0};
  light_.position = center + size * glm::dvec3(-0.7, 1.0, 0.8);
  light_.intensity = glm::dvec3(size * size);
}

std::vector<float> SequenceView::render(const DensityGrid& grid) const {
  return grid_picture(grid, camera_, film_, light_);
}

std::vector<float> SequenceView::render(std::span<const Gaussian> gaussians) const {
  Scene scene;
  for (const Gaussian& g : gaussians) scene.medium.append(g);
  scene.lights.push_back(light_);
  Settings settings;
  settings.airlight = AirlightMethod::sliced;
  const Frame frame = *Renderer().render(scene, camera_, film_, sliced_settings(settings, 64));
  std::vector<float> red;
  for (std::size_t i = 0; i < frame.airlight.size(); i += 3) red.push_back(frame.airlight[i]);
  return red;
}

double squares_between(std::span<const float> a, std::span<const float> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return sum;
}

}  // namespace brume
