// Sequences of frames, imported as files of Gaussians.

#include <exception>

#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/text/words.h"
#include "app/import/dialogs/folder_dialog.h"
#include "app/import/dialogs/volume_dialog.h"
#include "app/import/import_kind.h"
#include "app/import/scene_import.h"
#include "app/import/vtk_points.h"
#include "brume/error.h"
#include "core/io/gaussians/sequence_file.h"

namespace brume {
namespace fs = std::filesystem;

void SceneImport::add_sequence(MediumSequence sequence) {
  sequence.start = document_.time();
  Sequences sequences = document_.scene().sequences;
  const QString name = to_qstring(sequence.file.filename());
  sequences.push_back(std::move(sequence));
  set_scene_part(document_, std::move(sequences), tr("Import sequence %1").arg(name));
}

void SceneImport::import_sequence(const fs::path& given) {
  const fs::path file = fs::absolute(given);
  try {
    const FrameRun run = frames_around(file);
    if (is_volume(file)) {
      auto* dialog = new VolumeDialog(file, run, window_);
      connect(dialog, &VolumeDialog::requested, this, [this, run, dialog](const VolumeFit& how) {
        import_volumes(run, how, dialog->folder());
      });
      dialog->show();
      return;
    }
    if (is_vtk_file(file)) {
      auto* dialog = new FolderDialog(file, run, window_);
      connect(dialog, &FolderDialog::requested, this,
              [this, run](const QString& folder) { import_vtk_files(run, to_path(folder)); });
      dialog->show();
      return;
    }
    start(file, [this, run, file](const Job&) -> BackgroundJob::Apply {
      if (import_kind_of(file) != ImportKind::splats) return read(run);
      return [this, run] { ask_about_splats(run); };
    });
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

void SceneImport::start_sequence(const FrameRun& run, const fs::path& folder, MakeFrames make) {
  fs::path names = fs::absolute(folder) / fs::path(run.files.text()).filename();
  names.replace_extension(".ply");
  start(run.files.file_of(run.first),
        [this, run, names, make = std::move(make)](const Job& job) -> BackgroundJob::Apply {
          std::error_code error;
          if (fs::weakly_canonical(run.files.text(), error) == fs::weakly_canonical(names, error)) {
            throw InputError(names.parent_path(), "",
                             "has the files that are imported; allowed: another folder");
          }
          std::vector<std::string> warnings;
          std::vector<SequenceFrame> frames = make(job, warnings);
          const auto count = static_cast<std::size_t>(run.last - run.first) + 1;
          if (frames.size() != count || job.stop.stop_requested()) return {};
          // Only now, so that nothing is there of what was cancelled.
          return [this, sequence = write_sequence(names, run, std::move(frames)),
                  text = lines_of(warnings)] {
            if (!text.isEmpty()) Q_EMIT warned(text);
            add_sequence(sequence);
          };
        });
}

void SceneImport::import_volumes(const FrameRun& run, const VolumeFit& how,
                                 const fs::path& folder) {
  start_sequence(run, folder, [run, how](const Job& job, std::vector<std::string>&) {
    std::vector<fs::path> files;
    for (int frame = run.first; frame <= run.last; ++frame)
      files.push_back(run.files.file_of(frame));
    return fit_volumes(files, how, job);
  });
}

void SceneImport::import_vtk_files(const FrameRun& run, const fs::path& folder) {
  start_sequence(run, folder, [run](const Job& job, std::vector<std::string>&) {
    const auto read = [&](const fs::path& file, std::vector<GaussianNumber>* ids,
                          std::size_t max_count, std::vector<std::string>*) {
      return read_vtk_points(file, ids, max_count, job.stop);
    };
    return read_sequence(run.files, run.first, run.last, read);
  });
}

}  // namespace brume
