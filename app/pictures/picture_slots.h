#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "app/pictures/picture.h"

namespace brume {

// The pictures of a session that can be compared, with names and notes. Their layers have limited
// memory: beyond it the oldest go.
class PictureSlots : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  static constexpr std::size_t count = 8;
  [[nodiscard]] const std::shared_ptr<const Picture>& at(std::size_t slot) const {
    return slots_.at(slot).picture;
  }
  // The given name, else that of its picture; empty: there is none.
  [[nodiscard]] QString name(std::size_t slot) const;
  [[nodiscard]] const QString& note(std::size_t slot) const { return slots_.at(slot).note; }
  void set_name(std::size_t slot, const QString& name);  // empty: that of its picture
  void set_note(std::size_t slot, const QString& note);

  // Into the first empty slot, or where the oldest is; which one.
  std::size_t keep(std::shared_ptr<const Picture> picture);
  // The same for pictures of one job, which follow each other in one slot and keep its name.
  std::size_t keep_of_job(int job, std::shared_ptr<const Picture> picture);
  // Where the last picture of a job is; nullopt: no more.
  [[nodiscard]] std::optional<std::size_t> slot_of_job(int job) const;
  void set(std::size_t slot, std::shared_ptr<const Picture> picture);  // null: empties it
  void set_max_layer_bytes(std::size_t bytes);

 Q_SIGNALS:
  void changed(std::size_t slot);
  void labelled(std::size_t slot);  // its name or note is another

 private:
  struct Slot {
    std::shared_ptr<const Picture> picture{};
    QString name{};
    QString note{};
    std::uint64_t age = 0;
    int job = 0;  // 0: of none
  };

  void limit_layers();

  std::array<Slot, count> slots_;
  std::size_t max_layer_bytes_ = std::size_t{1} << 30;
  std::uint64_t newest_ = 0;
};

}  // namespace brume
