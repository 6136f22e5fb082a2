#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/commands/gaussians/operation_numbers.h"
#include "app/import/dialogs/splat_dialog.h"
#include "app/import/frame_run.h"
#include "app/import/import_kind.h"
#include "app/import/import_spot.h"
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

  // Also asks for a volume's fit options. `spot`: where Gaussians, meshes and assets are put;
  // nullopt: where the file has them.
  void import_file(const std::filesystem::path& file, const std::optional<ImportSpot>& spot = {});
  // The same of a file of the asset library, where scenes are what they add to this one.
  void import_asset(const std::filesystem::path& file, const std::optional<ImportSpot>& spot);
  // Imports dropped files: frames of one sequence as such, others individually as one undo step.
  // Reports unsupported ones.
  void import_files(const std::vector<std::filesystem::path>& files);
  // Imports the sequence that a file belongs to, starting at the current frame.
  void import_sequence(const std::filesystem::path& file);
  void import_volume(const std::filesystem::path& file, const VolumeFit& how);
  // These write Gaussians as PLY to a new folder and import that sequence, so scenes can be read
  // without VTK, and whatever was chosen for splats. Volumes are fitted.
  void import_volumes(const FrameRun& run, const VolumeFit& how,
                      const std::filesystem::path& folder);
  void import_vtk_files(const FrameRun& run, const std::filesystem::path& folder);
  void import_splats(const FrameRun& run, const SplatOptions& options,
                     const std::filesystem::path& folder);

  // Adds surfaces as one undo step; the first of them is selected.
  void add_surfaces(const std::vector<Surface>& added, const QString& text,
                    bool is_at_spot = false);

 Q_SIGNALS:
  void failed(const QString& message);
  void warned(const QString& message);
  // Within the undo step of the import: surfaces from that one on, whether they were put where the
  // user chose, and that the scene's camera is one of the file.
  void surfaces_added(std::size_t first, bool is_at_spot);
  void camera_used();

 private:
  // False, and failed(): another job is running.
  bool start(const std::filesystem::path& file, const BackgroundJob::Work& work);
  struct File {
    std::filesystem::path path;
    ImportKind kind;
    std::optional<ImportSpot> spot{};
  };
  // Whether there are splats of which to ask what they become; throws if they cannot be read.
  static bool needs_answer(const File& file);
  // Asks what the splats of `what`, or of a sequence, become.
  void ask_about_splats(const QString& what,
                        const std::function<void(const SplatOptions&)>& import_them);
  void ask_about_splats(const FrameRun& run);
  // In the background: reads a file other than a volume, or files as one undo step, or a sequence.
  // Where a scene has cameras or lights, `asks` whether they are wanted; else all are.
  BackgroundJob::Apply read(const File& file, const SplatOptions& options,
                            const std::stop_token& stop, bool asks);
  BackgroundJob::Apply read(const std::vector<File>& files, const SplatOptions& options,
                            const Job& job);
  BackgroundJob::Apply read(const FrameRun& run);
  // A glTF may have splats, too.
  BackgroundJob::Apply add_splats(const File& file, const SplatOptions& options);
  BackgroundJob::Apply read_scene(const File& file, const SplatOptions& options,
                                  const std::stop_token& stop, bool asks);
  struct ReadScene {
    std::shared_ptr<const ImportedScene> scene;
    std::vector<Gaussian> gaussians;
    std::optional<ImportSpot> spot;
  };
  void add_scene(const ReadScene& found, bool cameras, bool lights);
  // Adds something that can be placed otherwise as the last operation.
  using AddPlaced = std::function<void(const QString& text, const ImportPlacement& placement)>;
  void add_placed(const QString& text, const MeshBox& box, const std::optional<ImportSpot>& spot,
                  const AddPlaced& add);
  void add_placed(const std::vector<Gaussian>& gaussians, const std::optional<ImportSpot>& spot);
  void import_each(const std::vector<std::filesystem::path>& files,
                   const std::optional<FrameRun>& run);
  void add_sequence(MediumSequence sequence);
  // In the background: writes the frames of `make`, numbered as in `run`, to a folder. Nothing is
  // written if it returns fewer.
  using MakeFrames =
      std::function<std::vector<SequenceFrame>(const Job& job, std::vector<std::string>& warnings)>;
  void start_sequence(const FrameRun& run, const std::filesystem::path& folder, MakeFrames make);

  Document& document_;
  BackgroundJob& job_;
  QWidget* window_;
};

}  // namespace brume
