#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace brume {

// A vector whose copies share their elements until one of them is written to: a copy costs nothing,
// and adding to the end of one costs what is added, because the others do not look beyond their own
// size. Different copies may be used by different threads.
template <class T>
requires std::is_trivially_copyable_v<T>
class SharedColumn {
 public:
  SharedColumn() = default;
  SharedColumn(const SharedColumn&) = default;
  SharedColumn& operator=(const SharedColumn&) = default;
  SharedColumn(SharedColumn&& other) noexcept
      : buffer_(std::move(other.buffer_)), size_(std::exchange(other.size_, 0)) {}
  SharedColumn& operator=(SharedColumn&& other) noexcept {
    buffer_ = std::move(other.buffer_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }
  ~SharedColumn() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::span<const T> all() const { return {data(), size_}; }
  [[nodiscard]] const T& operator[](std::size_t index) const { return data()[index]; }

  // Whether two are the same elements, and not only equal ones.
  [[nodiscard]] bool is_shared_with(const SharedColumn& other) const {
    return size_ == other.size_ && (size_ == 0 || buffer_ == other.buffer_);
  }
  bool operator==(const SharedColumn& other) const {
    return is_shared_with(other) || std::ranges::equal(all(), other.all());
  }

  // To write to; valid until another member is called.
  [[nodiscard]] std::span<T> write() {
    if (size_ > 0 && !is_own()) reallocate(size_);
    return {data(), size_};
  }
  // Writes an element if it differs.
  void set(std::size_t index, const T& value) {
    if (!((*this)[index] == value)) write()[index] = value;
  }
  void push_back(const T& value) {
    const T added = value;  // it may be one of ours
    grow(size_ + 1);
    data()[size_ - 1] = added;
  }
  // New elements are `value`.
  void resize(std::size_t size, const T& value = {}) {
    const std::size_t old = size_;
    if (size <= old) {
      size_ = size;
      return;
    }
    grow(size);
    std::fill(data() + old, data() + size, value);
  }
  void reserve(std::size_t count) {
    if (count > capacity()) reallocate(count);
  }

 private:
  struct Buffer {
    explicit Buffer(std::size_t count)
        : elements(std::make_unique_for_overwrite<T[]>(count)), capacity(count) {}
    std::unique_ptr<T[]> elements;
    std::size_t capacity;
    // Elements that a column has, or once had.
    std::atomic<std::size_t> used = 0;
  };

  [[nodiscard]] T* data() const { return buffer_ ? buffer_->elements.get() : nullptr; }
  [[nodiscard]] std::size_t capacity() const { return buffer_ ? buffer_->capacity : 0; }
  [[nodiscard]] bool is_own() const {
    if (buffer_.use_count() != 1) return false;
    // Reads by others, before they let go of it, have happened before our writes.
    std::atomic_thread_fence(std::memory_order_acquire);
    return true;
  }
  void reallocate(std::size_t capacity) {
    auto buffer = std::make_shared<Buffer>(capacity);
    std::copy_n(data(), size_, buffer->elements.get());
    buffer->used = size_;
    buffer_ = std::move(buffer);
  }
  // Makes room for `size` > size_ elements, which are the column's afterwards.
  void grow(std::size_t size) {
    if (size > capacity()) {
      reallocate(std::max(size, size_ + size_ / 2));
    } else {
      // The first to add to columns that share their elements has the place behind them.
      std::size_t end = size_;
      const bool is_free = buffer_->used.compare_exchange_strong(end, size);
      if (!is_free && !is_own()) reallocate(std::max(size, size_ + size_ / 2));
    }
    buffer_->used = size;
    size_ = size;
  }

  std::shared_ptr<Buffer> buffer_;
  std::size_t size_ = 0;
};

}  // namespace brume
