#include "core/io/gaussians/sequence_reader.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace brume {

SequenceReader::SequenceReader(std::vector<std::size_t> counts, Read read, std::size_t max_kept)
    : counts_(std::move(counts)), read_(std::move(read)), max_kept_(max_kept) {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    max_gaussians_ = std::max(max_gaussians_, counts_[i] + (i > 0 ? counts_[i - 1] : 0));
  }
  thread_ = std::jthread([this](const std::stop_token& stop) { read_ahead(stop); });
}

SequenceReader::~SequenceReader() = default;

std::shared_ptr<const SequenceFrame> SequenceReader::frame(std::size_t index) const {
  std::unique_lock lock(mutex_);
  last_ = index;
  changed_.notify_all();
  changed_.wait(lock, [&] { return !being_read_.contains(index); });
  if (const auto known = frames_.find(index); known != frames_.end() && known->second) {
    return known->second;
  }
  Frame frame = read(index, lock);
  keep(index, frame);
  return frame;
}

SequenceReader::Frame SequenceReader::read(std::size_t index,
                                           std::unique_lock<std::mutex>& lock) const {
  being_read_.insert(index);
  lock.unlock();
  const auto end = [&] {
    lock.lock();
    being_read_.erase(index);
    changed_.notify_all();
  };
  try {
    auto frame = std::make_shared<const SequenceFrame>(read_(index));
    end();
    return frame;
  } catch (...) {
    end();
    throw;
  }
}

std::vector<std::size_t> SequenceReader::kept() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::size_t> indices;
  for (const auto& [index, frame] : frames_) {
    if (frame) indices.push_back(index);
  }
  return indices;
}

void SequenceReader::read_ahead(const std::stop_token& stop) const {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const auto next = next_ahead();
    if (!next) {
      changed_.wait(lock, stop, [&] { return next_ahead().has_value(); });
      continue;
    }
    Frame frame;
    try {
      frame = read(*next, lock);
    } catch (const std::exception&) {
      // Said when it is asked for.
    }
    keep(*next, std::move(frame));
  }
}

std::optional<std::size_t> SequenceReader::next_ahead() const {
  if (!last_) return std::nullopt;
  // Half of the budget, so that what has been shown is not all dropped.
  std::size_t count = 0;
  for (std::size_t i = *last_; i < counts_.size(); ++i) {
    count += counts_[i];
    if (count > max_kept_ / 2 && i > *last_ + 1) return std::nullopt;
    if (!frames_.contains(i) && !being_read_.contains(i)) return i;
  }
  return std::nullopt;
}

// Drops the frames that are asked for last when they come in order, round and round.
void SequenceReader::keep(std::size_t index, Frame frame) const {
  frames_[index] = std::move(frame);
  const auto ahead = [&](std::size_t i) {
    const std::size_t first = last_.value_or(0);
    return i >= first ? i - first : counts_.size() - first + i;
  };
  std::size_t kept = 0;
  for (const auto& [i, known] : frames_) kept += counts_[i];
  while (kept > max_kept_ && frames_.size() > 2) {
    const auto last = std::ranges::max_element(
        frames_, {}, [&](const auto& entry) { return ahead(entry.first); });
    kept -= counts_[last->first];
    frames_.erase(last);
  }
}

}  // namespace brume
