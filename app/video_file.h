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
  ~VideoFile();  // kills ffmpeg if it still runs
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  // sRGB, 3 bytes per pixel, rows from the top. Both return early when stopped: the file is then
  // not complete.
  void add(std::span<const std::uint8_t> picture, const std::stop_token& stop);
  void finish(const std::stop_token& stop);  // waits until ffmpeg has written the file

 private:
  [[noreturn]] void fail();

  std::filesystem::path shown_;
  QProcess process_;
};

}  // namespace brume
