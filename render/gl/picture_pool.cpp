#include "render/gl/picture_pool.h"

#include <algorithm>
#include <utility>

namespace brume::gl {
namespace {

// Idle pictures of other sizes: those of four views, or of a view whose resolution changes.
constexpr std::size_t max_idle = 4;

}  // namespace

PicturePool::~PicturePool() {
  for (const auto& picture : idle_) {
    picture->texture_.abandon();
    picture->drawn_.abandon();
  }
}

std::shared_ptr<DevicePicture> PicturePool::acquire(const glm::ivec2& size) {
  std::unique_ptr<DevicePicture> picture = reuse_idle(size);
  if (!picture) picture = std::make_unique<DevicePicture>();
  picture->drawn_.wait();
  picture->texture_.reserve(Texture::Format::rgba8, size);
  return {picture.release(), [pool = shared_from_this()](DevicePicture* back) {
            pool->put_back(std::unique_ptr<DevicePicture>(back));
          }};
}

// An unused texture of that size, or the oldest if there are too many; else null.
std::unique_ptr<DevicePicture> PicturePool::reuse_idle(const glm::ivec2& size) {
  const std::scoped_lock lock(mutex_);
  auto found = std::ranges::find_if(
      idle_, [&](const auto& picture) { return picture->texture_.size() == size; });
  if (found == idle_.end() && idle_.size() >= max_idle) found = idle_.begin();
  if (found == idle_.end()) return nullptr;
  std::unique_ptr<DevicePicture> picture = std::move(*found);
  idle_.erase(found);
  return picture;
}

void PicturePool::trim() {
  std::vector<std::unique_ptr<DevicePicture>> gone;
  const std::scoped_lock lock(mutex_);
  std::swap(gone, idle_);
}

void PicturePool::put_back(std::unique_ptr<DevicePicture> picture) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(picture));
}

}  // namespace brume::gl
