#include "core/io/gaussians/sequence_file.h"

#include <algorithm>
#include <exception>
#include <numeric>
#include <system_error>
#include <utility>

#include "brume/error.h"

namespace brume {
namespace {

SequenceFrame read_frame(const std::string& file, const FrameReader& read, std::size_t max_count,
                         std::vector<std::string>* warnings = nullptr) {
  SequenceFrame frame;
  std::vector<GaussianNumber> ids;
  std::vector<Gaussian> gaussians = read(file, &ids, max_count, warnings);
  if (ids.empty()) {
    frame.ids.resize(gaussians.size());
    std::iota(frame.ids.begin(), frame.ids.end(), GaussianNumber{0});
    frame.gaussians = std::move(gaussians);
    return frame;
  }
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  for (const std::size_t i : order) {
    if (!frame.ids.empty() && frame.ids.back() == ids[i]) {
      throw InputError(file, "",
                       "found the id " + std::to_string(ids[i]) + " twice; allowed: once");
    }
    frame.ids.push_back(ids[i]);
    frame.gaussians.push_back(gaussians[i]);
  }
  return frame;
}

}  // namespace

std::vector<SequenceFrame> read_sequence(const FramePattern& files, int first, int last,
                                         const FrameReader& read, std::size_t max_count,
                                         std::vector<std::string>* warnings) {
  std::vector<SequenceFrame> frames;
  std::size_t total = 0;
  for (int number = first; number <= last; ++number) {
    frames.push_back(read_frame(files.file_of(number), read, max_count - total, warnings));
    total += frames.back().gaussians.size();
  }
  return frames;
}

std::shared_ptr<const SequenceFrames> open_sequence(const FramePattern& files, int first, int last,
                                                    const FrameReader& read, std::size_t max_count,
                                                    std::vector<std::string>* warnings,
                                                    std::size_t max_in_memory) {
  std::vector<std::size_t> counts;
  std::error_code error;
  for (int number = first; number <= last; ++number) {
    const std::filesystem::path file = files.file_of(number);
    const bool exists = std::filesystem::exists(file, error);
    if (!exists) read(file, nullptr, max_count, warnings);  // whose judgement it is
    counts.push_back(exists ? max_gaussian_count(file) : 0);
  }
  if (std::reduce(counts.begin(), counts.end()) <= max_in_memory) {
    return sequence_frames(read_sequence(files, first, last, read, max_count, warnings));
  }
  const auto read_one = [files, first, read, max_count](std::size_t index) {
    return read_frame(files.file_of(first + static_cast<int>(index)), read, max_count);
  };
  read_frame(files.file_of(first), read, max_count, warnings);  // what is wrong with all of them
  return std::make_shared<SequenceReader>(std::move(counts), read_one, 2 * max_in_memory);
}

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
