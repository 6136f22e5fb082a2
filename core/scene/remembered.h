#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>

namespace brume {

// Which object is shared, without keeping it.
template <class T>
class Identity {
 public:
  Identity(const std::shared_ptr<const T>& object) : object_(object) {}  // NOLINT: as it is
  bool operator==(const Identity& other) const {
    return !object_.owner_before(other.object_) && !other.object_.owner_before(object_);
  }

 private:
  std::weak_ptr<const T> object_;
};

// The last results of a function, by its arguments. Thread-safe.
template <class Key, class Value>
class Remembered {
 public:
  // That of `key`, or what `compute` returns. The results that were used least lately are forgotten
  // where all of them together take more memory than this, by `bytes_of` a result, or are more than
  // there are surfaces in a scene.
  static constexpr std::size_t max_bytes = std::size_t{256} << 20;

  Value get(const Key& key, auto&& compute, auto&& bytes_of) {
    const auto known = [&] {
      const auto found = std::ranges::find(entries_, key, &Entry::key);
      if (found != entries_.end()) std::rotate(entries_.begin(), found, found + 1);
      return found != entries_.end();
    };
    {
      const std::lock_guard lock(mutex_);
      if (known()) return entries_.front().value;
    }
    Value value = compute();
    const std::lock_guard lock(mutex_);
    if (known()) return entries_.front().value;
    entries_.push_front({key, value, bytes_of(value)});
    bytes_ += entries_.front().bytes;
    while (entries_.size() > 1 && (bytes_ > max_bytes || entries_.size() > max_entries)) {
      bytes_ -= entries_.back().bytes;
      entries_.pop_back();
    }
    return value;
  }

 private:
  struct Entry {
    Key key;
    Value value;
    std::size_t bytes;
  };
  static constexpr std::size_t max_entries = 4096;
  std::mutex mutex_;
  std::deque<Entry> entries_;  // the last used one first
  std::size_t bytes_ = 0;
};

}  // namespace brume
