#include "core/io/gaussians/sequence_file.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "brume/error.h"

namespace brume {
namespace {

SequenceFrame read_frame(const std::string& file, const FrameReader& read, std::size_t max_count) {
  SequenceFrame frame;
  std::vector<GaussianNumber> ids;
  std::vector<Gaussian> gaussians = read(file, &ids, max_count);
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
                                         const FrameReader& read, std::size_t max_count) {
  std::vector<SequenceFrame> frames;
  std::size_t total = 0;
  for (int number = first; number <= last; ++number) {
    frames.push_back(read_frame(files.file_of(number), read, max_count - total));
    total += frames.back().gaussians.size();
  }
  return frames;
}

}  // namespace brume
