#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "brume/frame.h"
#include "core/io/image/image_file.h"
#include "render/display/to_display.h"

namespace brume {

// The contents of a frame's header that its frame does not know. Empty texts are left out.
struct FrameInfo {
  std::string scene{};         // file name
  DisplayLook look{};          // of a PNG; an EXR is linear
  int bits = 8;                // of each value of a PNG: 8, dithered, or 16
  std::string fingerprint{};   // of all that it was made from
  std::optional<int> frame{};  // its number in a sequence
};

// Whether the name of a frame's file asks for a deep image: *.deep.exr, in any case.
bool is_deep_file(const std::filesystem::path& file);

// The fingerprint of a complete file; nullopt if there is none.
std::optional<std::string> fingerprint_of(const std::filesystem::path& file);

// The metadata of the file of a frame, as below: what made it (RequestOption::is_in_header), and
// how far it is off.
std::map<std::string, std::string> frame_metadata(const Frame& frame, const FrameInfo& info);

// How a frame's file says it was seen.
ExrView exr_view(const Camera& camera, const Film& film, double frames_per_second);

// Throws InputError unless the extension is .exr or .png, in any case.
void check_frame_extension(const std::filesystem::path& file);

// Writes a frame to .exr (with the layers of its request) or .png (exposure and view transform
// applied), with `info` and the version as metadata under the prefix "brume:", since OpenEXR
// reserves names such as "version". An EXR has its ExrView, too. Throws InputError.
void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameInfo& info);

}  // namespace brume
