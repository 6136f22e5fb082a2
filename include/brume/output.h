#pragma once

#include <array>
#include <filesystem>
#include <optional>

namespace brume {

// The layers of an EXR beside the picture; resources/manual/layers.md has their channels.
struct OutputLayers {
  bool airlight = true;
  bool transmittance = true;
  bool depth = true;  // Z
  // Airlight and surfaces under one source of light at a time; any of these three makes the picture
  // their sum.
  bool lights = false;
  bool environment = false;
  bool emission = false;
  // Light scattered once at most, and more often.
  bool direct = false;
  bool multiple = false;
  bool reflection = false;  // what smooth surfaces mirror
  bool optical_depth = false;
  // These are about the surface that is seen first:
  bool planar_depth = false;  // along the camera's axis
  bool normal = false;
  bool albedo = false;
  bool position = false;
  bool motion = false;
  bool objects = false;    // Cryptomatte
  bool materials = false;  // Cryptomatte

  bool operator==(const OutputLayers&) const = default;
};

// Denoised frames of `path` begin with the picture that is solved for, and keep of what paths add
// to it only what stands out from their noise: they have a fraction of the noise, and a bias
// towards that picture that more paths remove. Their error can be measured.
enum class Denoising { none, solved };

// When the shutter is open, from a frame's time on, in frames; open < close. Half a frame is the
// usual "180 degrees".
struct Shutter {
  double open = 0.0;
  double close = 0.5;

  bool operator==(const Shutter&) const = default;
};

// The names of layers in files and on the command line.
struct LayerName {
  const char* name;
  bool OutputLayers::*layer;
};
inline constexpr std::array layer_names{LayerName{"airlight", &OutputLayers::airlight},
                                        LayerName{"transmittance", &OutputLayers::transmittance},
                                        LayerName{"Z", &OutputLayers::depth},
                                        LayerName{"lights", &OutputLayers::lights},
                                        LayerName{"environment", &OutputLayers::environment},
                                        LayerName{"emission", &OutputLayers::emission},
                                        LayerName{"direct", &OutputLayers::direct},
                                        LayerName{"multiple", &OutputLayers::multiple},
                                        LayerName{"reflection", &OutputLayers::reflection},
                                        LayerName{"optical_depth", &OutputLayers::optical_depth},
                                        LayerName{"depth.planar", &OutputLayers::planar_depth},
                                        LayerName{"normal", &OutputLayers::normal},
                                        LayerName{"albedo", &OutputLayers::albedo},
                                        LayerName{"position", &OutputLayers::position},
                                        LayerName{"motion", &OutputLayers::motion},
                                        LayerName{"objects", &OutputLayers::objects},
                                        LayerName{"materials", &OutputLayers::materials}};

// How the pictures of a scene are made, other than its film and camera. Frames are the same without
// it.
struct Output {
  // .png or .exr, numbered for an animation, or .mp4; absolute; empty: not chosen yet.
  std::filesystem::path file;
  std::optional<int> paths;  // traced per pixel, 1 to limits::paths; absent: as views render
  // Paths of whole pictures without layers of light.
  Denoising denoise = Denoising::none;
  // Per pixel of those that need them, 1 to limits::samples; absent: chosen.
  std::optional<int> samples;
  std::optional<Shutter> shutter;  // absent: no motion blur
  std::optional<double> exposure;  // of .png and .mp4 [stops]; absent: the view's
  OutputLayers layers;

  bool operator==(const Output&) const = default;
};

}  // namespace brume
