#pragma once

#include <QString>
#include <filesystem>
#include <string>

namespace brume {

// The extension that says how a picture is written: ".deep.exr", or the last one, in lower case.
std::string picture_format(const std::filesystem::path& file);
// The file of another format.
std::filesystem::path with_picture_format(std::filesystem::path file, const std::string& format);

// Path of ffmpeg on the PATH, which writes .mp4, or empty.
QString find_ffmpeg();

}  // namespace brume
