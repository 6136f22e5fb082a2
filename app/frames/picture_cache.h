#pragma once

#include <QObject>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "brume/camera.h"

namespace brume {

struct RenderedFrame;

// The pictures of an animation that were shown, by view and time, to be shown again without
// rendering. Whoever inserts them forgets them when anything but the time changes.
class PictureCache : public QObject {
  Q_OBJECT
 public:
  explicit PictureCache(std::size_t capacity = std::size_t{512} << 20) : capacity_(capacity) {}
  // Forgets all pictures if they are more [bytes].
  void set_capacity(std::size_t capacity);

  // Keeps the picture, without layers or scene. One at full quality is not replaced by another. A
  // full cache keeps what it has: in a loop, that is what comes next.
  void insert(const RenderedFrame& frame, bool full);
  struct Picture {
    std::shared_ptr<const RenderedFrame> frame;
    bool full = false;
  };
  // Null if there is none for this camera; valid until the cache changes.
  [[nodiscard]] const Picture* find(int view, double time, const Camera& camera) const;
  void forget(int view);

  struct Kept {
    double time;  // [s]
    bool full;    // at full quality
  };
  // By time.
  [[nodiscard]] std::vector<Kept> kept(int view) const;
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 Q_SIGNALS:
  void changed();

 private:
  std::size_t capacity_;
  std::size_t bytes_ = 0;
  std::map<int, std::map<double, Picture>> views_;
};

}  // namespace brume
