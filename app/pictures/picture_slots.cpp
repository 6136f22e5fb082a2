#include "app/pictures/picture_slots.h"

#include <algorithm>
#include <utility>

namespace brume {

QString PictureSlots::name(std::size_t slot) const {
  const Slot& found = slots_.at(slot);
  return found.name.isEmpty() && found.picture ? found.picture->name : found.name;
}

void PictureSlots::set_name(std::size_t slot, const QString& name) {
  if (!at(slot)) return;
  slots_[slot].name = name.simplified();
  Q_EMIT labelled(slot);
}

void PictureSlots::set_note(std::size_t slot, const QString& note) {
  if (!at(slot)) return;
  slots_[slot].note = note.simplified();
  Q_EMIT labelled(slot);
}

std::size_t PictureSlots::keep(std::shared_ptr<const Picture> picture) {
  auto slot = std::ranges::find(slots_, nullptr, &Slot::picture);
  if (slot == slots_.end()) slot = std::ranges::min_element(slots_, {}, &Slot::age);
  const auto place = static_cast<std::size_t>(slot - slots_.begin());
  set(place, std::move(picture));
  return place;
}

std::size_t PictureSlots::keep_of_job(int job, std::shared_ptr<const Picture> picture) {
  if (const auto slot = slot_of_job(job)) {
    slots_[*slot].picture = std::move(picture);
    slots_[*slot].age = ++newest_;
    Q_EMIT changed(*slot);
    limit_layers();
    return *slot;
  }
  const std::size_t slot = keep(std::move(picture));
  slots_[slot].job = job;
  return slot;
}

std::optional<std::size_t> PictureSlots::slot_of_job(int job) const {
  const auto found = std::ranges::find(slots_, job, &Slot::job);
  if (found == slots_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - slots_.begin());
}

void PictureSlots::set(std::size_t slot, std::shared_ptr<const Picture> picture) {
  slots_.at(slot) = {.picture = std::move(picture), .age = ++newest_};
  Q_EMIT changed(slot);
  limit_layers();
}

void PictureSlots::set_max_layer_bytes(std::size_t bytes) {
  max_layer_bytes_ = bytes;
  limit_layers();
}

void PictureSlots::limit_layers() {
  const auto bytes_of = [](const Slot& slot) {
    return slot.picture ? layer_bytes(*slot.picture) : 0;
  };
  std::size_t bytes = 0;
  for (const Slot& slot : slots_) bytes += bytes_of(slot);
  while (bytes > max_layer_bytes_) {
    const auto oldest = std::ranges::min_element(
        slots_, {}, [&](const Slot& slot) { return bytes_of(slot) > 0 ? slot.age : newest_ + 1; });
    bytes -= bytes_of(*oldest);
    oldest->picture = without_layers(*oldest->picture);
    Q_EMIT changed(static_cast<std::size_t>(oldest - slots_.begin()));
  }
}

}  // namespace brume
