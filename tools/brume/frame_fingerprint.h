#pragma once

#include <string>

#include "core/io/scene/scene_document.h"

namespace brume {

// The sources of a scene's frames, as short texts: version, scene, the bytes of all files that
// it refers to, options. Frames of equal fingerprints are equal; other times, options or contents
// give others. A file's name and age do not matter.
class FrameFingerprint {
 public:
  // `options`: whatever of the command line makes a difference. Reads all files.
  FrameFingerprint(const SceneDocument& document, const std::string& options);

  [[nodiscard]] std::string of(int frame) const;

 private:
  std::uint64_t all_frames_;
};

}  // namespace brume
