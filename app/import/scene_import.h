#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/background_job.h"
#include "app/import/volume_fit.h"
#include "core/io/frame_pattern.h"
#include "core/scene/medium_sequence.h"

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
  // What was dropped at once: frames of one sequence as that, other files one by one as one undo
  // step. Says so where some cannot be imported.
  void import_files(const std::vector<std::filesystem::path>& files);
  // The run of frames that a file is one of, from the frame that is shown on.
  void import_sequence(const std::filesystem::path& file);
  void import_volume(const std::filesystem::path& file, const VolumeFit& how);
  // These write the Gaussians as PLY into a folder, which is made, and show those: what a scene
  // plays is read without VTK. Volumes are fitted.
  void import_volumes(const FrameRun& run, const VolumeFit& how,
                      const std::filesystem::path& folder);
  void import_vtk_files(const FrameRun& run, const std::filesystem::path& folder);

  static bool can_import(const std::filesystem::path& file);  // by its extension

 Q_SIGNALS:
  void failed(const QString& message);

 private:
  void start(const std::filesystem::path& file, const BackgroundJob::Work& work);
  // In the background: what a file that is no volume, or a run of frames, adds to the scene.
  BackgroundJob::Take read(const std::filesystem::path& file, const std::stop_token& stop);
  BackgroundJob::Take read(const FrameRun& run);
  void import_each(const std::vector<std::filesystem::path>& files,
                   const std::optional<FrameRun>& run);
  void add_sequence(MediumSequence sequence);
  // In the background: writes the frames that `make` gives, of the numbers of `run`, into a folder.
  // None are written where it gives fewer.
  using MakeFrames = std::function<std::vector<SequenceFrame>(const Job& job)>;
  void start_sequence(const FrameRun& run, const std::filesystem::path& folder, MakeFrames make);
  [[nodiscard]] double start_time() const;

  Document& document_;
  BackgroundJob& job_;
  QWidget* window_;
};

// The frames around a file that are there without a gap. Throws InputError where it is no frame.
FrameRun frames_around(const std::filesystem::path& file);

}  // namespace brume
