#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "brume/frame.h"
#include "brume/output.h"
#include "core/io/image/image_file.h"
#include "render/display/to_display.h"
#include "render/settings.h"

namespace brume {

// Metadata of a frame's file. Empty texts are left out.
struct FrameInfo {
  std::string scene{};  // file name
  std::string airlight{};
  std::string backend{};
  DisplayLook look{};                             // of a PNG; an EXR is linear
  int bits = 8;                                   // of each value of a PNG: 8, dithered, or 16
  std::optional<RelativeNoise> noise{};           // of a path-traced frame
  OutputLayers layers{};                          // of an EXR
  std::string fingerprint{};                      // of all that it was made from
  std::map<std::string, std::string> settings{};  // settings_metadata()
  std::optional<int> frame{};                     // its number in a sequence
  std::optional<ErrorEstimate> error{};
};

// The metadata of settings: brume:samples, and brume:slices or brume:seed of methods that have
// them.
std::map<std::string, std::string> settings_metadata(const Settings& settings);

// Whether the name of a frame's file asks for a deep image: *.deep.exr, in any case.
bool is_deep_file(const std::filesystem::path& file);

// The fingerprint of a complete file; nullopt if there is none.
std::optional<std::string> fingerprint_of(const std::filesystem::path& file);

// The metadata of the file of a frame at a time [s], as below.
std::map<std::string, std::string> frame_metadata(const FrameInfo& info, double time);

// How a frame's file says it was seen.
ExrView exr_view(const Camera& camera, const Film& film, double frames_per_second);

// Throws InputError unless the extension is .exr or .png, in any case.
void check_frame_extension(const std::filesystem::path& file);

// Writes a frame to .exr (all layers) or .png (exposure and view transform applied), with `info`
// and the version as metadata under the prefix "brume:", since OpenEXR reserves names such as
// "version". An EXR has its ExrView, too. Throws InputError.
// `more`: channels and metadata that an EXR gets besides.
void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info,
                 const ImageLayers& more = {});

}  // namespace brume
