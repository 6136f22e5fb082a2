#include "app/files/picture_format.h"

#include <QStandardPaths>

#include "core/io/disk/file_bytes.h"
#include "render/output/frame_file.h"

namespace brume {

std::string picture_format(const std::filesystem::path& file) {
  return is_deep_file(file) ? ".deep.exr" : lower_case_extension(file);
}

std::filesystem::path with_picture_format(std::filesystem::path file, const std::string& format) {
  if (is_deep_file(file)) file.replace_extension();
  return file.replace_extension(format);
}

QString find_ffmpeg() {
  return QStandardPaths::findExecutable("ffmpeg");
}

}  // namespace brume
