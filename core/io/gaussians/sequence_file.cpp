#include "core/io/gaussians/sequence_file.h"

#include <algorithm>
#include <numeric>
#include <system_error>
#include <utility>

#include "brume/error.h"
#include "core/io/gaussians/sequence_reader.h"

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

}  // namespace brume
