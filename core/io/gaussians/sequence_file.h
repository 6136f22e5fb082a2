#pragma once

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "brume/limits.h"
#include "brume/medium_sequence.h"
#include "core/io/frame_pattern.h"
#include "core/io/gaussians/gaussian_file.h"

namespace brume {

// Reads one frame's Gaussians and their ids, if present; throws beyond `max_count`. `warnings` may
// be null.
using FrameReader = std::function<std::vector<Gaussian>(
    const std::filesystem::path& file, std::vector<GaussianNumber>* ids, std::size_t max_count,
    std::vector<std::string>* warnings)>;

// read_gaussians() of any splats as opaque as stored along their mean radius.
inline std::vector<Gaussian> read_gaussian_frame(const std::filesystem::path& file,
                                                 std::vector<GaussianNumber>* ids,
                                                 std::size_t max_count,
                                                 std::vector<std::string>* warnings) {
  return read_gaussians(file, ids, max_count, {}, warnings);
}

// Reads one file of Gaussians per frame, with ids from the column `id`; without it the line number
// identifies a Gaussian. Throws InputError naming file and place, also for duplicate ids and for
// more than `max_count` in all. Warnings of `read` are appended to `warnings`.
std::vector<SequenceFrame> read_sequence(const FramePattern& files, int first, int last,
                                         const FrameReader& read = read_gaussian_frame,
                                         std::size_t max_count = limits::gaussians,
                                         std::vector<std::string>* warnings = nullptr);

// The frames of such files: read at once where they have at most `max_in_memory` Gaussians in all,
// else when they are asked for. `max_count` is then for any moment, and there are only warnings of
// the first frame.
std::shared_ptr<const SequenceFrames> open_sequence(const FramePattern& files, int first, int last,
                                                    const FrameReader& read = read_gaussian_frame,
                                                    std::size_t max_count = limits::gaussians,
                                                    std::vector<std::string>* warnings = nullptr,
                                                    std::size_t max_in_memory = 2'000'000);

// Frames of a sequence that are read when they are asked for. A thread reads those after the last
// one ahead; as many are kept as fit into a budget.
class SequenceReader final : public SequenceFrames {
 public:
  // Reads a frame; from any thread. Throws InputError.
  using Read = std::function<SequenceFrame(std::size_t index)>;
  // `counts`: Gaussians of each frame. `max_kept`: of all frames that are kept.
  SequenceReader(std::vector<std::size_t> counts, Read read, std::size_t max_kept = 4'000'000);
  ~SequenceReader() override;

  [[nodiscard]] std::size_t size() const override { return counts_.size(); }
  [[nodiscard]] std::shared_ptr<const SequenceFrame> frame(std::size_t index) const override;
  [[nodiscard]] std::size_t max_gaussians() const override { return max_gaussians_; }
  [[nodiscard]] bool are_in_memory() const override { return false; }

  // Frames that are there without waiting.
  [[nodiscard]] std::vector<std::size_t> kept() const;

 private:
  using Frame = std::shared_ptr<const SequenceFrame>;

  void read_ahead(const std::stop_token& stop) const;
  // Reads a frame, which is in `being_read_` until then, with the mutex open.
  Frame read(std::size_t index, std::unique_lock<std::mutex>& lock) const;
  // The next frame to read: those from the last one asked for on that fit; nullopt: all are there.
  [[nodiscard]] std::optional<std::size_t> next_ahead() const;
  void keep(std::size_t index, Frame frame) const;

  std::vector<std::size_t> counts_;
  Read read_;
  std::size_t max_kept_;
  std::size_t max_gaussians_ = 0;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  mutable std::map<std::size_t, Frame> frames_;  // null: could not be read ahead
  mutable std::set<std::size_t> being_read_;     // by any thread
  mutable std::optional<std::size_t> last_;      // asked for
  mutable std::jthread thread_;                  // the last: it uses all of these
};

}  // namespace brume
