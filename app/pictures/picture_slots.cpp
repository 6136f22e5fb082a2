#include "app/pictures/picture_slots.h"

#include <algorithm>

namespace brume {

std::size_t PictureSlots::keep(std::shared_ptr<const Picture> picture) {
  auto slot = std::ranges::find(pictures_, nullptr) - pictures_.begin();
  if (slot == count) slot = std::ranges::min_element(ages_) - ages_.begin();
  set(static_cast<std::size_t>(slot), std::move(picture));
  return static_cast<std::size_t>(slot);
}

std::size_t PictureSlots::keep_of_job(int job, std::shared_ptr<const Picture> picture) {
  if (const auto slot = slot_of_job(job)) {
    set(*slot, std::move(picture));
    jobs_[*slot] = job;
    return *slot;
  }
  const std::size_t slot = keep(std::move(picture));
  jobs_[slot] = job;
  return slot;
}

std::optional<std::size_t> PictureSlots::slot_of_job(int job) const {
  const auto found = std::ranges::find(jobs_, job);
  if (found == jobs_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - jobs_.begin());
}

void PictureSlots::set(std::size_t slot, std::shared_ptr<const Picture> picture) {
  pictures_.at(slot) = std::move(picture);
  ages_[slot] = ++newest_;
  jobs_[slot] = 0;
  Q_EMIT changed(slot);
}

}  // namespace brume
