#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "app/background_job.h"
#include "app/import/volume_fit.h"
#include "core/io/frame_pattern.h"

class QWidget;

namespace brume {

class Document;

// A run of frames: the files of a pattern, without a gap.
struct FrameRun {
  FramePattern files;
  int first = 0;
  int last = 0;
};

// What comes into the scene from files, each as one undo step when it has been read in the
// background: Gaussians (.csv, .ply, .vtp, .vtu), volumes (.vdb, fitted), meshes (.obj, .ply, .stl,
// .off), environments (.exr, .hdr); Gaussians and volumes as sequences too.
class SceneImport : public QObject {
  Q_OBJECT
 public:
  SceneImport(Document& document, BackgroundJob& job, QWidget* window);

  // Asks for a file, and of a volume how it becomes Gaussians.
  void ask();
  void ask_sequence();

  void import_file(const std::filesystem::path& file);  // asks about a volume too
  // The run of frames that a file is one of, from the frame that is shown on.
  void import_sequence(const std::filesystem::path& file);
  void import_volume(const std::filesystem::path& file, const VolumeFit& how);
  // Fits them, writes the Gaussians as PLY into a folder, which is made, and shows those.
  void import_volumes(const FrameRun& run, const VolumeFit& how,
                      const std::filesystem::path& folder);

  static bool can_import(const std::filesystem::path& file);  // by its extension

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void start(const std::filesystem::path& file, const BackgroundJob::Work& work);
  void add_sequence(MediumSequence sequence);
  [[nodiscard]] double start_time() const;

  Document& document_;
  BackgroundJob& job_;
  QWidget* window_;
};

// The frames around a file that are there without a gap. Throws InputError where it is no frame.
FrameRun frames_around(const std::filesystem::path& file);

}  // namespace brume
