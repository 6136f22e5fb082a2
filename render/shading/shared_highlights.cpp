#include "render/shading/shared_highlights.h"

#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace brume {

bool SharedHighlights::Pixel::is_like(std::int32_t other_surface, std::uint32_t other_copy,
                                      const glm::vec3& other_normal) const {
  if (surface < 0 || surface != other_surface || copy != other_copy) return false;
  // Half of alpha between normals is alpha between directions, half of a lobe's width.
  return glm::dot(normal, other_normal) > 1.0f - 0.125f * alpha * alpha;
}

void SharedHighlights::reset(const glm::ivec2& size, float pixel_angle) {
  size_ = size;
  pixel_angle_ = pixel_angle;
  pixels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), {});
  shared_.assign(pixels_.size(), {});
  if (!pixels_.empty()) return;
  pixels_.shrink_to_fit();
  shared_.shrink_to_fit();
}

void SharedHighlights::share(const CameraRays::PixelRectangle& within, const Job& job,
                             std::span<glm::vec3> radiance) {
  std::vector<std::uint8_t> is_alone(pixels_.size(), 0);
  job.parallel_for(static_cast<std::size_t>(within.y1 - within.y0), [&](std::size_t row) {
    const int y = within.y0 + static_cast<int>(row);
    for (int x = within.x0; x < within.x1; ++x) {
      const std::size_t pixel = index_of({x, y});
      if (pixels_[pixel].surface < 0) continue;
      const std::optional<Highlight> mean = mean_around({x, y});
      is_alone[pixel] = !mean;
      if (!mean) continue;
      shared_[pixel] = *mean;
      radiance[pixel] += mean->reflected(pixels_[pixel].f0);
    }
  });
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    if (is_alone[i] != 0) pixels_[i].surface = lonely;
  }
}

std::optional<Highlight> SharedHighlights::mean_around(const glm::ivec2& pixel) const {
  const Pixel& middle = pixels_[index_of(pixel)];
  // A lobe is about twice alpha wide: a block must not widen it much.
  const bool is_much_wider = middle.alpha > static_cast<float>(side) * pixel_angle_;
  const int reach = is_much_wider ? max_reach : max_reach / 2;
  const glm::ivec2 low = glm::max(pixel - reach, glm::ivec2(0));
  const glm::ivec2 high = glm::min(pixel + reach, size_ - 1);
  Highlight sum;
  float weights = 0.0f;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Pixel& other = pixels_[index_of({x, y})];
      if (!middle.is_like(other.surface, other.copy, other.normal)) continue;
      // Both ends of a row have the same rays: half of each.
      const float weight = (std::abs(x - pixel.x) == reach ? 0.5f : 1.0f) *
                           (std::abs(y - pixel.y) == reach ? 0.5f : 1.0f);
      sum.base += weight * other.own.base;
      sum.grazing += weight * other.own.grazing;
      weights += weight;
    }
  }
  constexpr float min_share = 0.4f;  // of a block, so that corners of a film have enough
  if (weights < min_share * static_cast<float>(4 * reach * reach) && low == pixel - reach &&
      high == pixel + reach) {
    return std::nullopt;
  }
  return Highlight{sum.base / weights, sum.grazing / weights};
}

const Highlight* SharedHighlights::find(const glm::ivec2& pixel, const SurfaceHit& hit,
                                        const glm::vec3& normal) const {
  const glm::ivec2 low = glm::max(pixel - 1, glm::ivec2(0));
  const glm::ivec2 high = glm::min(pixel + 1, size_ - 1);
  const Highlight* found = nullptr;
  int nearest = std::numeric_limits<int>::max();
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const int distance = std::abs(x - pixel.x) + std::abs(y - pixel.y);
      if (distance >= nearest) continue;
      if (!pixels_[index_of({x, y})].is_like(hit.surface, hit.copy, normal)) continue;
      nearest = distance;
      found = &shared_[index_of({x, y})];
    }
  }
  return found;
}

}  // namespace brume
