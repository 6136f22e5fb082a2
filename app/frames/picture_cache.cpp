#include "app/frames/picture_cache.h"

#include <utility>

#include "app/frames/frame_service.h"

namespace brume {
namespace {

std::size_t bytes_of(const RenderedFrame& frame) {
  constexpr std::size_t bytes_on_device = 4;  // per pixel
  const auto pixels = static_cast<std::size_t>(frame.frame.film.width) *
                      static_cast<std::size_t>(frame.frame.film.height);
  return frame.on_device ? bytes_on_device * pixels
                         : static_cast<std::size_t>(frame.picture.sizeInBytes());
}

}  // namespace

void PictureCache::set_capacity(std::size_t capacity) {
  capacity_ = capacity;
  if (bytes_ <= capacity_) return;
  views_.clear();
  bytes_ = 0;
  Q_EMIT changed();
}

void PictureCache::insert(const RenderedFrame& frame, bool full) {
  auto& pictures = views_[frame.request.view];
  const auto old = pictures.find(frame.request.time);
  std::size_t freed = 0;
  if (old != pictures.end()) {
    const RenderedFrame& before = *old->second.frame;
    const bool is_better =
        std::pair(full, -frame.divisor) >= std::pair(old->second.full, -before.divisor);
    if (before.request.camera == frame.request.camera && !is_better) return;
    freed = bytes_of(before);
  }
  const std::size_t needed = bytes_of(frame);
  if (bytes_ - freed + needed > capacity_) return;
  auto kept = std::make_shared<RenderedFrame>();
  kept->request = frame.request;
  kept->request.scene.reset();
  kept->frame.film = frame.frame.film;
  kept->frame.statistics = frame.frame.statistics;
  kept->frame.statistics.pixel_pairs = {};
  kept->picture = frame.picture;
  kept->on_device = frame.on_device;
  kept->divisor = frame.divisor;
  kept->milliseconds = frame.milliseconds;
  pictures.insert_or_assign(frame.request.time, Picture{std::move(kept), full});
  bytes_ = bytes_ - freed + needed;
  Q_EMIT changed();
}

const PictureCache::Picture* PictureCache::find(int view, double time, const Camera& camera) const {
  const auto pictures = views_.find(view);
  if (pictures == views_.end()) return nullptr;
  const auto found = pictures->second.find(time);
  if (found == pictures->second.end()) return nullptr;
  return found->second.frame->request.camera == camera ? &found->second : nullptr;
}

void PictureCache::forget(int view) {
  const auto pictures = views_.find(view);
  if (pictures == views_.end() || pictures->second.empty()) return;
  for (const auto& [time, picture] : pictures->second) bytes_ -= bytes_of(*picture.frame);
  views_.erase(pictures);
  Q_EMIT changed();
}

std::vector<PictureCache::Kept> PictureCache::kept(int view) const {
  std::vector<Kept> result;
  const auto pictures = views_.find(view);
  if (pictures == views_.end()) return result;
  for (const auto& [time, picture] : pictures->second) result.push_back({time, picture.full});
  return result;
}

}  // namespace brume
