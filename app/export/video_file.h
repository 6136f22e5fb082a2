#pragma once

#include <QProcess>
#include <filesystem>
#include <span>
#include <stop_token>

#include "brume/camera.h"

namespace brume {

// An MP4 file written by ffmpeg. Not thread-safe.
class VideoFile {
 public:
  // All throw InputError. `shown`: name in errors; `file`: path written.
  VideoFile(const std::filesystem::path& shown, const std::filesystem::path& file, const Film& film,
            double frames_per_second);
  ~VideoFile();  // kills a running ffmpeg
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  // Adds a frame: sRGB, 3 bytes per pixel, rows from the top. Both return early when stopped,
  // leaving an incomplete file.
  void add(std::span<const std::uint8_t> picture, const std::stop_token& stop);
  void finish(const std::stop_token& stop);  // waits until ffmpeg has written the file

 private:
  [[noreturn]] void fail();

  std::filesystem::path shown_;
  QProcess process_;
};

}  // namespace brume
