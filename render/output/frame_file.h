#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "brume/frame.h"
#include "brume/output.h"
#include "core/io/image/image_file.h"
#include "render/display/to_display.h"

namespace brume {

// Metadata of a frame's file. Empty texts are left out.
struct FrameInfo {
  std::string scene{};  // file name
  std::string airlight{};
  std::string backend{};
  DisplayLook look{};                    // of a PNG; an EXR is linear
  int bits = 8;                          // of each value of a PNG: 8, dithered, or 16
  std::optional<RelativeNoise> noise{};  // of a path-traced frame
  OutputLayers layers{};                 // of an EXR
  std::string fingerprint{};             // of all that it was made from
};

// Whether the name of a frame's file asks for a deep image: *.deep.exr, in any case.
bool is_deep_file(const std::filesystem::path& file);

// The fingerprint of a complete file; nullopt if there is none.
std::optional<std::string> fingerprint_of(const std::filesystem::path& file);

// The metadata of a file, as below.
std::map<std::string, std::string> frame_metadata(const FrameInfo& info);

// Throws InputError unless the extension is .exr or .png, in any case.
void check_frame_extension(const std::filesystem::path& file);

// Writes a frame to .exr (all layers) or .png (exposure and view transform applied), with `info`
// and the version as metadata under the prefix "brume:", since OpenEXR reserves names such as
// "version". Throws InputError.
// `more`: channels and metadata that an EXR gets besides.
void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info,
                 const ImageLayers& more = {});

}  // namespace brume
