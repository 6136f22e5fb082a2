#include "render/shading/shared_highlights.h"

#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace brume {
namespace {

// Normals that differ by more mirror other parts of the scene: 8 degrees.
constexpr float min_normal_cosine = 0.99f;

}  // namespace

int SharedHighlights::reach_of(float alpha, float pixel_angle) {
  // A lobe is about twice alpha wide: a block must not widen it much.
  return 2.0f * alpha > 2.0f * static_cast<float>(side) * pixel_angle ? max_reach : max_reach / 2;
}

void SharedHighlights::reset(const glm::ivec2& size) {
  size_ = size;
  pixels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), {});
  shared_.assign(pixels_.size(), glm::vec3(0.0f));
}

void SharedHighlights::set(const glm::ivec2& pixel, const SurfaceHit& hit, const glm::vec3& normal,
                           int reach, const glm::vec3& light) {
  pixels_[index_of(pixel)] = {hit.surface, hit.copy, reach, normal, light};
}

void SharedHighlights::share(const CameraRays::PixelRectangle& within, const Job& job) {
  job.parallel_for(static_cast<std::size_t>(within.y1 - within.y0), [&](std::size_t row) {
    const int y = within.y0 + static_cast<int>(row);
    for (int x = within.x0; x < within.x1; ++x) {
      if (pixels_[index_of({x, y})].surface >= 0) shared_[index_of({x, y})] = mean_around({x, y});
    }
  });
}

glm::vec3 SharedHighlights::mean_around(const glm::ivec2& pixel) const {
  const Pixel& middle = pixels_[index_of(pixel)];
  const int reach = middle.reach;
  const glm::ivec2 low = glm::max(pixel - reach, glm::ivec2(0));
  const glm::ivec2 high = glm::min(pixel + reach, size_ - 1);
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Pixel& other = pixels_[index_of({x, y})];
      if (other.surface != middle.surface || other.copy != middle.copy) continue;
      if (glm::dot(other.normal, middle.normal) < min_normal_cosine) continue;
      // Both ends of a row have the same rays: half of each.
      const float weight = (std::abs(x - pixel.x) == reach ? 0.5f : 1.0f) *
                           (std::abs(y - pixel.y) == reach ? 0.5f : 1.0f);
      sum += weight * other.light;
      weights += weight;
    }
  }
  return sum / weights;
}

const glm::vec3* SharedHighlights::near(const glm::ivec2& pixel, const SurfaceHit& hit) const {
  const glm::ivec2 low = glm::max(pixel - 1, glm::ivec2(0));
  const glm::ivec2 high = glm::min(pixel + 1, size_ - 1);
  const glm::vec3* found = nullptr;
  int nearest = std::numeric_limits<int>::max();
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Pixel& other = pixels_[index_of({x, y})];
      const int distance = std::abs(x - pixel.x) + std::abs(y - pixel.y);
      if (other.surface != hit.surface || other.copy != hit.copy || distance >= nearest) continue;
      nearest = distance;
      found = &shared_[index_of({x, y})];
    }
  }
  return found;
}

}  // namespace brume
