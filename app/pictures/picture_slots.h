#pragma once

#include <QObject>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/pictures/picture.h"

namespace brume {

// The pictures of a session that can be compared.
class PictureSlots : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  static constexpr std::size_t count = 8;
  [[nodiscard]] const std::shared_ptr<const Picture>& at(std::size_t slot) const {
    return pictures_.at(slot);
  }
  // Into the first empty slot, or where the oldest is; which one.
  std::size_t keep(std::shared_ptr<const Picture> picture);
  // The same for pictures of one job, which follow each other in one slot.
  std::size_t keep_of_job(int job, std::shared_ptr<const Picture> picture);
  // Where the last picture of a job is; nullopt: no more.
  [[nodiscard]] std::optional<std::size_t> slot_of_job(int job) const;
  void set(std::size_t slot, std::shared_ptr<const Picture> picture);  // null: empties it

 Q_SIGNALS:
  void changed(std::size_t slot);

 private:
  std::array<std::shared_ptr<const Picture>, count> pictures_;
  std::array<std::uint64_t, count> ages_{};
  std::array<int, count> jobs_{};  // 0: of none
  std::uint64_t newest_ = 0;
};

}  // namespace brume
