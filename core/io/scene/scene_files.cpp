#include "core/io/scene/scene_files.h"

#include <algorithm>
#include <type_traits>

#include "core/io/frame_pattern.h"

namespace brume {

std::vector<std::filesystem::path> files_of(const SceneDocument& document) {
  std::vector<std::filesystem::path> files;
  visit_files(document.scene, [&files](const auto& reference) {
    if constexpr (std::is_same_v<decltype(reference), const MediumSequence&>) {
      const auto frames = FramePattern::parse(reference.file.string());
      for (int frame = reference.first; frames && frame <= reference.last; ++frame) {
        files.emplace_back(frames->file_of(frame));
      }
    } else if constexpr (std::is_same_v<decltype(reference), const Surface&>) {
      files.insert(files.end(), reference.imported->files.begin(), reference.imported->files.end());
    } else {
      files.push_back(reference);
    }
  });
  if (const auto& loaded = document.extras.medium_file) files.push_back(loaded->file);
  return files;
}

std::vector<std::filesystem::path> files_outside(const SceneDocument& document,
                                                 const std::filesystem::path& folder) {
  const auto absolute = [](const std::filesystem::path& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  std::vector<std::filesystem::path> result;
  for (const std::filesystem::path& file : files_of(document)) {
    const std::filesystem::path relative = absolute(file).lexically_relative(absolute(folder));
    const bool is_within = !relative.empty() && *relative.begin() != "..";
    if (!is_within && std::ranges::count(result, file) == 0) result.push_back(file);
  }
  return result;
}

}  // namespace brume
