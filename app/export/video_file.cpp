#include "app/export/video_file.h"

#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/files/picture_format.h"
#include "brume/error.h"
#include "core/io/mp4_arguments.h"

namespace brume {
namespace {

constexpr int patience = 200;  // milliseconds until a stop token is looked at again

}  // namespace

VideoFile::VideoFile(const std::filesystem::path& shown, const std::filesystem::path& file,
                     const Film& film, double frames_per_second)
    : shown_(shown) {
  const QString size = QString("%1x%2").arg(film.width).arg(film.height);
  // Without the protocol, ffmpeg would parse a name such as "http:/x" as a URL.
  const QString target = "file:" + to_qstring(std::filesystem::absolute(file));
  process_.setStandardOutputFile(QProcess::nullDevice());
  QStringList arguments{
      "-hide_banner", "-loglevel", "error",         "-y",
      "-f",           "rawvideo",  "-pixel_format", "rgb24",
      "-video_size",  size,        "-framerate",    exact_number_text(frames_per_second),
      "-i",           "pipe:0"};
  for (const char* argument : mp4_arguments) arguments << argument;
  arguments.append({"-f", "mp4", target});
  process_.start(find_ffmpeg(), arguments);
  if (!process_.waitForStarted()) fail();
}

VideoFile::~VideoFile() {
  if (process_.state() == QProcess::NotRunning) return;
  process_.kill();
  process_.waitForFinished();
}

void VideoFile::add(std::span<const std::uint8_t> picture, const std::stop_token& stop) {
  process_.write(reinterpret_cast<const char*>(picture.data()),
                 static_cast<qint64>(picture.size()));
  while (process_.bytesToWrite() > 0 && !stop.stop_requested()) {
    process_.waitForBytesWritten(patience);
    if (process_.state() == QProcess::NotRunning) fail();
  }
}

void VideoFile::finish(const std::stop_token& stop) {
  process_.closeWriteChannel();
  while (process_.state() != QProcess::NotRunning) {
    if (stop.stop_requested()) return;
    process_.waitForFinished(patience);
  }
  if (process_.exitStatus() != QProcess::NormalExit || process_.exitCode() != 0) fail();
}

void VideoFile::fail() {
  const QString said = QString::fromLocal8Bit(process_.readAllStandardError()).trimmed();
  const QString why = said.isEmpty() ? process_.errorString() : said.section('\n', -1);
  throw InputError(shown_, "", "cannot be written by ffmpeg: " + why.toStdString());
}

}  // namespace brume
