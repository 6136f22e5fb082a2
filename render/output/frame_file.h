#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/scene/output.h"
#include "render/frame.h"

namespace brume {

// Metadata of a frame's file. Empty texts are left out.
struct FrameInfo {
  std::string scene;  // file name
  std::string airlight;
  std::string backend;
  double exposure = 0.0;                 // [stops], of a PNG; an EXR is linear
  std::optional<RelativeNoise> noise{};  // of a path-traced frame
  OutputLayers layers{};                 // of an EXR
};

// Throws InputError unless the extension is .exr or .png, in any case.
void check_frame_extension(const std::filesystem::path& file);

// Writes a frame to .exr (all layers) or .png (exposure and view transform applied), with `info`
// and the version as metadata under the prefix "brume:", since OpenEXR reserves names such as
// "version". Throws InputError.
void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info);

}  // namespace brume
