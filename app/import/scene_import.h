#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/import/frame_run.h"
#include "app/import/volume_fit.h"
#include "app/jobs/background_job.h"
#include "brume/medium_sequence.h"
#include "brume/scene.h"

class QWidget;

namespace brume {

class Document;

// Imports files in the background, each as one undo step: Gaussians (.csv, .ply, .vtp, .vtu),
// splats (.ply, .gltf, .glb), volumes (.vdb, fitted), scenes (.gltf, .glb, .fbx, .obj with
// materials), meshes (.obj, .ply, .stl, .off), environments (.exr, .hdr); Gaussians and volumes
// also as sequences.
class SceneImport : public QObject {
  Q_OBJECT
 public:
  SceneImport(Document& document, BackgroundJob& job, QWidget* window);

  // Asks for a file, for a volume's fit options, and what of a scene is wanted.
  void ask();
  void ask_sequence();

  void import_file(const std::filesystem::path& file);  // also asks for a volume's fit options
  // Imports dropped files: frames of one sequence as such, others individually as one undo step.
  // Reports unsupported ones.
  void import_files(const std::vector<std::filesystem::path>& files);
  // Imports the sequence that a file belongs to, starting at the current frame.
  void import_sequence(const std::filesystem::path& file);
  void import_volume(const std::filesystem::path& file, const VolumeFit& how);
  // These write Gaussians as PLY to a new folder and import that sequence, so scenes can be read
  // without VTK. Volumes are fitted.
  void import_volumes(const FrameRun& run, const VolumeFit& how,
                      const std::filesystem::path& folder);
  void import_vtk_files(const FrameRun& run, const std::filesystem::path& folder);

  // Adds surfaces as one undo step; the first ones of a new scene are framed and lit.
  void add_surfaces(const std::vector<Surface>& added, const QString& text);

  static bool can_import(const std::filesystem::path& file);  // by its extension

 Q_SIGNALS:
  void failed(const QString& message);
  void warned(const QString& message);
  void surfaces_added();  // within the undo step of the import

 private:
  void start(const std::filesystem::path& file, const BackgroundJob::Work& work);
  // In the background: reads a file other than a volume, or a sequence.
  BackgroundJob::Apply read(const std::filesystem::path& file, const std::stop_token& stop);
  BackgroundJob::Apply read(const FrameRun& run);
  BackgroundJob::Apply read_scene(const std::filesystem::path& file, const std::stop_token& stop,
                                  bool asks);
  void ask_about_splats(const std::filesystem::path& file);
  void add_scene(const std::shared_ptr<const ImportedScene>& scene, bool cameras, bool lights);
  void import_each(const std::vector<std::filesystem::path>& files,
                   const std::optional<FrameRun>& run);
  void add_sequence(MediumSequence sequence);
  // In the background: writes the frames of `make`, numbered as in `run`, to a folder. Nothing is
  // written if it returns fewer.
  using MakeFrames = std::function<std::vector<SequenceFrame>(const Job& job)>;
  void start_sequence(const FrameRun& run, const std::filesystem::path& folder, MakeFrames make);

  Document& document_;
  BackgroundJob& job_;
  QWidget* window_;
};

}  // namespace brume
