#include "app/import/vtk_points.h"

#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <string>

#include "app/document/paths.h"
#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/disk/installed_files.h"
#include "core/io/gaussians/gaussian_ply.h"

namespace brume {
namespace {

// Points written as text take 20 times that, compressed ones more.
constexpr std::uintmax_t memory_per_byte = 64;
constexpr std::uintmax_t min_memory = std::uintmax_t{512} << 20;
constexpr std::uintmax_t bytes_per_second = 1'000'000;
constexpr std::uintmax_t min_seconds = 30;

constexpr int poll_time = 50;  // milliseconds

// Runs the program until it ends; false if it was stopped.
bool run(QProcess& reader, const std::stop_token& stop) {
  while (!reader.waitForFinished(poll_time) && reader.state() != QProcess::NotRunning) {
    if (!stop.stop_requested()) continue;
    reader.kill();
    reader.waitForFinished(-1);
    return false;
  }
  return true;
}

// The program's error message, without the file's name.
std::string said(QProcess& reader, const std::filesystem::path& file) {
  std::string text = reader.readAllStandardOutput().trimmed().toStdString();
  const std::string name = file.string() + ": ";
  if (text.starts_with(name)) text.erase(0, name.size());
  return text;
}

}  // namespace

std::vector<Gaussian> read_vtk_points(const std::filesystem::path& file,
                                      std::vector<GaussianNumber>* ids, std::size_t max_count,
                                      const std::stop_token& stop) {
  const std::uintmax_t size = regular_file_size(file);
  const std::uintmax_t memory =
      std::min<std::uintmax_t>(min_memory + memory_per_byte * size, limits::scene_bytes);
  const std::uintmax_t seconds = min_seconds + size / bytes_per_second;
  if (stop.stop_requested()) return {};
  const QTemporaryDir folder;
  const std::filesystem::path points = to_path(folder.filePath("points.ply"));
  QProcess reader;
  const auto number = [](std::uintmax_t value) { return QString::number(value); };
  QStringList arguments{to_qstring(file), to_qstring(points), number(max_count), number(memory),
                        number(seconds)};
  if (ids != nullptr) arguments << "ids";
  reader.setStandardErrorFile(QProcess::nullDevice());
  reader.start(to_qstring(helper_program("brume-vtk-points")), arguments);
  if (!reader.waitForStarted(-1)) {
    throw InputError(
        file, "",
        "the program brume-vtk-points cannot be run: " + reader.errorString().toStdString());
  }
  if (!run(reader, stop)) return {};
  if (reader.exitStatus() == QProcess::NormalExit && reader.exitCode() == 0) {
    return read_gaussians_ply(points, ids, max_count);
  }
  if (reader.exitStatus() == QProcess::NormalExit && reader.exitCode() == 2) {
    throw InputError(file, "", said(reader, file));
  }
  throw InputError(file, "",
                   "VTK cannot read it: it is damaged or exceeds the limit for its size, " +
                       std::to_string(memory >> 20) + " MiB of memory or " +
                       std::to_string(seconds) + " s");
}

}  // namespace brume
