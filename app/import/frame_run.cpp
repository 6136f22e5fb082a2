#include "app/import/frame_run.h"

#include <algorithm>
#include <utility>

#include "brume/error.h"
#include "core/io/gaussians/gaussian_file.h"

namespace brume {

FrameRun frames_around(const std::filesystem::path& file) {
  const auto files = FramePattern::around(file.string());
  if (!files) {
    throw InputError(file, "",
                     "is not a frame of a sequence; allowed: one of several files whose names "
                     "differ in a number");
  }
  const std::vector<int> numbers = files->frames();
  const auto found = std::find_if(numbers.begin(), numbers.end(), [&](int number) {
    return files->file_of(number) == file.string();
  });
  if (found == numbers.end()) throw InputError(file, "", "does not exist");
  auto first = found;
  while (first != numbers.begin() && *(first - 1) == *first - 1) --first;
  auto last = found;
  while (last + 1 != numbers.end() && *(last + 1) == *last + 1) ++last;
  return {*files, *first, *last};
}

MediumSequence write_sequence(const std::filesystem::path& names, const FrameRun& run,
                              std::vector<SequenceFrame> frames) {
  const auto files = FramePattern::parse(names.string());
  if (!files) throw InputError(names, "", "is not a valid sequence name");
  std::filesystem::create_directories(names.parent_path());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const std::string file = files->file_of(run.first + static_cast<int>(k));
    write_gaussians(file, frames[k].gaussians, frames[k].ids);
  }
  MediumSequence sequence;
  sequence.file = names;
  sequence.first = run.first;
  sequence.last = run.last;
  sequence.frames = sequence_frames(std::move(frames));
  return sequence;
}

}  // namespace brume
