#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "render/gl/resources.h"

namespace brume::gl {

// A displayed picture on the device: RGBA bytes, rows from the bottom. Valid for any context that
// shares objects with its creator while it is held.
class DevicePicture {
 public:
  [[nodiscard]] const Texture& texture() const { return texture_; }
  // Call after each draw, in the drawing context: the texture is not overwritten before the draw
  // has finished.
  void drawn() { drawn_.set(); }

 private:
  friend class PicturePool;
  Texture texture_;
  Fence drawn_;
};

// A pool of picture textures, returned automatically when released, from any thread; so there are
// as many as are in use at a time.
class PicturePool : public std::enable_shared_from_this<PicturePool> {
 public:
  static std::shared_ptr<PicturePool> create() {
    return std::shared_ptr<PicturePool>(new PicturePool);
  }
  // Without trim() before, contexts are assumed to be destroyed, and remaining objects with them.
  ~PicturePool();
  PicturePool(const PicturePool&) = delete;
  PicturePool& operator=(const PicturePool&) = delete;

  // A picture to write to. Throws OutOfMemory. This and trim() need a current context; it may
  // differ between calls if all share objects.
  std::shared_ptr<DevicePicture> acquire(const glm::ivec2& size);
  // Deletes unused textures.
  void trim();

 private:
  PicturePool() = default;
  std::unique_ptr<DevicePicture> reuse_idle(const glm::ivec2& size);
  void put_back(std::unique_ptr<DevicePicture> picture);

  std::mutex mutex_;
  std::vector<std::unique_ptr<DevicePicture>> idle_;  // most recently returned last
};

}  // namespace brume::gl
