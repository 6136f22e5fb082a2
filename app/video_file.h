#pragma once

#include <QProcess>
#include <QString>
#include <filesystem>
#include <span>
#include <stop_token>

#include "core/scene/camera.h"

namespace brume {

// The program ffmpeg where it is on the PATH, else empty.
QString find_ffmpeg();

// An MP4 that ffmpeg makes of pictures. For one thread.
class VideoFile {
 public:
  // Throws InputError, as do all: `shown` is the name that errors tell, `file` is written.
  VideoFile(const std::filesystem::path& shown, const std::filesystem::path& file, const Film& film,
            double frames_per_second);
  ~VideoFile();  // without finish(): ends ffmpeg
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  // sRGB, 3 bytes per pixel, rows from the top.
  void add(std::span<const std::uint8_t> picture, const std::stop_token& stop);
  void finish();

 private:
  [[noreturn]] void fail();

  std::filesystem::path shown_;
  QProcess process_;
};

}  // namespace brume
