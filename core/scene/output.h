#pragma once

#include <filesystem>
#include <optional>

namespace brume {

// The layers of an EXR beside the picture.
struct OutputLayers {
  bool airlight = true;
  bool transmittance = true;
  bool depth = true;  // Z

  bool operator==(const OutputLayers&) const = default;
};

// How the pictures of a scene are made, other than its film and camera. Frames are the same without
// it.
struct Output {
  // .png or .exr, numbered for an animation, or .mp4; absolute; empty: not chosen yet.
  std::filesystem::path file;
  std::optional<int> paths;        // traced per pixel, 1 to limits::paths; absent: as views render
  std::optional<double> exposure;  // of .png and .mp4 [stops]; absent: the view's
  OutputLayers layers;

  bool operator==(const Output&) const = default;
};

}  // namespace brume
