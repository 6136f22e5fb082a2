#pragma once

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

namespace brume {

// The last results of a function, by its arguments. Thread-safe.
template <class Key, class Value>
class Remembered {
 public:
  // That of `key`, or what `compute` returns.
  Value get(const Key& key, auto&& compute) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = std::ranges::find(entries_, key, &std::pair<Key, Value>::first);
      if (found != entries_.end()) return found->second;
    }
    Value value = compute();
    const std::lock_guard lock(mutex_);
    entries_.emplace_front(key, value);
    if (entries_.size() > max_entries) entries_.pop_back();
    return value;
  }

 private:
  static constexpr std::size_t max_entries = 64;
  std::mutex mutex_;
  std::deque<std::pair<Key, Value>> entries_;
};

}  // namespace brume
