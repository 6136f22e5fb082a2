#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "render/gl/resources.h"

namespace brume::gl {

// What a display shows of a frame, left on the device: RGBA bytes, rows from the bottom. Whoever
// gets one need not wait for it. Any context that shares objects with the one that made it may draw
// it, as long as somebody holds it.
class DevicePicture {
 public:
  [[nodiscard]] const Texture& texture() const { return texture_; }
  // After each drawing with it, in the context that drew: nothing is written to it before that is
  // done.
  void drawn() { drawn_.set(); }

 private:
  friend class PicturePool;
  Texture texture_;
  Fence drawn_;
};

// Textures for pictures. They come back when nobody holds them any more, in whatever thread, and
// are written anew: as many are there as are in use at a time.
class PicturePool : public std::enable_shared_from_this<PicturePool> {
 public:
  static std::shared_ptr<PicturePool> create() {
    return std::shared_ptr<PicturePool>(new PicturePool);
  }
  // Without trim() before, contexts are taken to be gone, and what is left with them.
  ~PicturePool();
  PicturePool(const PicturePool&) = delete;
  PicturePool& operator=(const PicturePool&) = delete;

  // One to write to. Throws OutOfMemory. This and trim() need a context to be current; it may be
  // another one each time, if only all share their objects.
  std::shared_ptr<DevicePicture> take(const glm::ivec2& size);
  // Deletes what is not in use.
  void trim();

 private:
  PicturePool() = default;
  std::unique_ptr<DevicePicture> take_idle(const glm::ivec2& size);
  void put_back(std::unique_ptr<DevicePicture> picture);

  std::mutex mutex_;
  std::vector<std::unique_ptr<DevicePicture>> idle_;  // the last one back is the last one here
};

}  // namespace brume::gl
