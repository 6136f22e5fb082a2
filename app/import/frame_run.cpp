#include "app/import/frame_run.h"

#include <algorithm>
#include <vector>

#include "brume/error.h"

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

}  // namespace brume
