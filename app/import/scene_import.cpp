#include "app/import/scene_import.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

#include "app/commands/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/file_dialogs.h"
#include "app/import/add_imported.h"
#include "app/import/folder_dialog.h"
#include "app/import/scene_dialog.h"
#include "app/import/splat_dialog.h"
#include "app/import/volume_dialog.h"
#include "app/import/vtk_points.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/gaussians/sequence_file.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/mesh/mesh_file.h"
#include "core/io/ply.h"
#include "core/medium/splat.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::string_view, 2> tables{".csv", ".ply"};
constexpr std::array<std::string_view, 2> vtk_files{".vtp", ".vtu"};
constexpr std::array<std::string_view, 3> meshes{".obj", ".stl", ".off"};
constexpr std::array<std::string_view, 3> scenes{".gltf", ".glb", ".fbx"};
constexpr std::array<std::string_view, 2> environments{".exr", ".hdr"};

bool is_one_of(const fs::path& file, const auto& extensions) {
  const std::string extension = lower_case_extension(file);
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

// A PLY or glTF may be either.
bool is_of_splats(const fs::path& file) {
  constexpr std::array<std::string_view, 3> possible{".ply", ".gltf", ".glb"};
  try {
    return is_one_of(file, possible) && has_splats(file);
  } catch (const InputError&) {
    return false;  // who reads it says what is wrong
  }
}

bool is_volume(const fs::path& file) {
  return lower_case_extension(file) == ".vdb";
}

// With materials of its own; an OBJ may be either.
bool is_scene(const fs::path& file) {
  return (is_one_of(file, scenes) && !is_of_splats(file)) ||
         (lower_case_extension(file) == ".obj" && obj_has_materials(file));
}

// A PLY may be either.
bool is_mesh(const fs::path& file) {
  if (lower_case_extension(file) != ".ply") return is_one_of(file, meshes);
  const std::string bytes = read_bytes(file);
  const PlyFile::Element* faces = PlyFile(file, bytes).element("face");
  return faces != nullptr && faces->count > 0;
}

std::vector<Gaussian> read_any_gaussians(const fs::path& file, const std::stop_token& stop) {
  return is_one_of(file, vtk_files) ? read_vtk_points(file, nullptr, limits::gaussians, stop)
                                    : read_gaussians(file);
}

// The sequence that all these files belong to, at least two; nullopt otherwise.
std::optional<FrameRun> run_of(const std::vector<fs::path>& files) {
  std::optional<FramePattern> pattern;
  for (const fs::path& file : files) {
    if (!is_volume(file) && !is_one_of(file, tables) && !is_one_of(file, vtk_files)) return {};
    const auto around = FramePattern::around(file.string());
    if (!around || (pattern && pattern->text() != around->text())) return {};
    pattern = around;
  }
  return frames_around(files.front());
}

Surface read_surface(const fs::path& file) {
  Surface surface;
  surface.mesh_file = file;
  surface.mesh = read_mesh(file);
  return surface;
}

}  // namespace

SceneImport::SceneImport(Document& document, BackgroundJob& job, QWidget* window)
    : QObject(window), document_(document), job_(job), window_(window) {}

bool SceneImport::can_import(const fs::path& file) {
  return is_volume(file) || is_one_of(file, tables) || is_one_of(file, vtk_files) ||
         is_one_of(file, meshes) || is_one_of(file, scenes) || is_one_of(file, environments);
}

void SceneImport::ask() {
  const fs::path file = ask_for_file(
      window_, FileKind::import, tr("Import"),
      tr("All supported files (*.vdb *.csv *.ply *.vtp *.vtu *.gltf *.glb *.fbx *.obj *.stl *.off "
         "*.exr *.hdr);;Scenes (*.gltf *.glb *.fbx *.obj);;Volumes (*.vdb);;Gaussians (*.csv *.ply "
         "*.vtp *.vtu);;Meshes (*.obj *.ply *.stl *.off);;"
         "Environments (*.exr *.hdr);;All files (*)"),
      document_.folder());
  if (!file.empty()) import_file(file);
}

void SceneImport::ask_sequence() {
  const fs::path file =
      ask_for_file(window_, FileKind::import, tr("Import a sequence: choose any frame"),
                   tr("Frames (*.vdb *.csv *.ply *.vtp *.vtu);;All files (*)"), document_.folder());
  if (!file.empty()) import_sequence(file);
}

void SceneImport::start(const fs::path& file, const BackgroundJob::Work& work) {
  if (!job_.start(work, tr("Importing %1").arg(to_qstring(file.filename())))) {
    Q_EMIT failed(tr("Another import or export is still running."));
  }
}

void SceneImport::import_file(const fs::path& given) {
  const fs::path file = fs::absolute(given);
  if (is_volume(file)) {
    auto* dialog = new VolumeDialog(file, std::nullopt, window_);
    connect(dialog, &VolumeDialog::requested, this,
            [this, file](const VolumeFit& how) { import_volume(file, how); });
    dialog->show();
    return;
  }
  start(file, [this, file](const Job& job) -> BackgroundJob::Apply {
    if (is_of_splats(file)) return [this, file] { ask_about_splats(file); };
    return read(file, job.stop);
  });
}

void SceneImport::ask_about_splats(const fs::path& file) {
  auto* dialog = new SplatDialog(file, window_);
  connect(dialog, &SplatDialog::requested, this, [this, file](OpacityAlong along, bool y_down) {
    start(file, [this, file, along, y_down](const Job&) -> BackgroundJob::Apply {
      std::vector<Gaussian> gaussians = read_gaussians(file, nullptr, limits::gaussians, along);
      if (y_down) std::ranges::for_each(gaussians, turn_half);
      return [this, gaussians = std::move(gaussians)] {
        add_gaussians(document_, gaussians, tr("Import"));
      };
    });
  });
  dialog->show();
}

BackgroundJob::Apply SceneImport::read(const fs::path& file, const std::stop_token& stop) {
  if (is_one_of(file, environments)) {
    return [this, file, map = read_radiance_map(file)] {
      Environment environment = document_.scene().environment.value_or(Environment{});
      environment.file = file;
      environment.map = map;
      set_scene_part(document_, std::optional(std::move(environment)),
                     tr("Import environment %1").arg(to_qstring(file.filename())));
    };
  }
  if (is_scene(file)) return read_scene(file, stop, true);
  if (is_mesh(file)) {
    return [this, surface = read_surface(file)] {
      add_surfaces({surface}, tr("Import %1").arg(to_qstring(surface.mesh_file.filename())));
    };
  }
  return [this, gaussians = read_any_gaussians(file, stop)] {
    add_gaussians(document_, gaussians, tr("Import"));
  };
}

// Where it has cameras or lights, `asks` whether they are wanted; else all are.
BackgroundJob::Apply SceneImport::read_scene(const fs::path& file, const std::stop_token& stop,
                                             bool asks) {
  std::vector<std::string> warnings;
  const std::shared_ptr<const ImportedScene> scene = read_imported_scene(file, warnings, stop);
  if (!scene) return {};
  if (scene->parts.empty() && scene->cameras.empty() && scene->lights.empty()) {
    throw InputError(file, "", "found neither meshes nor cameras nor lights");
  }
  QStringList lines;
  for (const std::string& warning : warnings) lines << QString::fromStdString(warning);
  return [this, scene, asks, text = lines.join('\n')] {
    if (!text.isEmpty()) Q_EMIT warned(text);
    if (!asks || (scene->cameras.empty() && scene->lights.empty())) {
      add_scene(scene, true, true);
      return;
    }
    auto* dialog = new SceneDialog(*scene, window_);
    connect(dialog, &SceneDialog::requested, this,
            [this, scene](bool cameras, bool lights) { add_scene(scene, cameras, lights); });
    dialog->show();
  };
}

void SceneImport::add_scene(const std::shared_ptr<const ImportedScene>& scene, bool cameras,
                            bool lights) {
  const QString text = tr("Import %1").arg(to_qstring(scene->files.front().filename()));
  const Scene& before = document_.scene();
  const bool is_new = before.lights == new_scene().lights && !before.environment;
  document_.undo_stack().beginMacro(text);
  if (!scene->parts.empty()) add_surfaces({surface_of(scene)}, text);
  if (cameras && !scene->cameras.empty()) add_cameras(document_, *scene, text);
  if (lights && !scene->lights.empty()) add_lights(document_, *scene, is_new, text);
  document_.undo_stack().endMacro();
}

BackgroundJob::Apply SceneImport::read(const FrameRun& run) {
  MediumSequence sequence;
  sequence.file = run.files.text();
  sequence.first = run.first;
  sequence.last = run.last;
  sequence.frames = open_sequence(run.files, run.first, run.last);
  return [this, sequence] { add_sequence(sequence); };
}

void SceneImport::import_files(const std::vector<fs::path>& files) {
  std::vector<fs::path> possible;
  QStringList others;
  for (const fs::path& file : files) {
    std::error_code error;
    if (can_import(file) && !fs::is_directory(file, error)) {
      possible.push_back(fs::absolute(file));
    } else {
      others << to_qstring(file.has_filename() ? file.filename() : file.parent_path().filename());
    }
  }
  if (!others.empty()) {
    Q_EMIT failed(tr("%1: cannot be imported; allowed: volumes (.vdb), Gaussians (.csv, .ply, "
                     ".vtp, .vtu), scenes (.gltf, .glb, .fbx, .obj), meshes (.obj, .ply, .stl, "
                     ".off), environments (.exr, .hdr), and one scene (.brume) by itself")
                      .arg(others.join(", ")));
  }
  if (possible.size() == 1) import_file(possible.front());
  if (possible.size() < 2) return;
  try {
    const std::optional<FrameRun> run = run_of(possible);
    if (run && lower_case_extension(possible.front()) != ".ply") {
      import_sequence(possible.front());
    } else {
      import_each(possible, run);
    }
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

// `run`: what the files are, unless they turn out to be meshes.
void SceneImport::import_each(const std::vector<fs::path>& files,
                              const std::optional<FrameRun>& run) {
  std::vector<fs::path> read_at_once;
  for (const fs::path& file : files) {
    if (is_volume(file)) {
      import_file(file);
    } else {
      read_at_once.push_back(file);
    }
  }
  if (read_at_once.empty()) return;
  start(read_at_once.front(),
        [this, files = read_at_once, run](const Job& job) -> BackgroundJob::Apply {
          if (run && !is_mesh(files.front())) return read(*run);
          std::vector<BackgroundJob::Apply> takes;
          std::vector<Surface> surfaces;  // added together, after what else may light them
          for (const fs::path& file : files) {
            if (job.stop.stop_requested()) return {};
            if (is_scene(file)) {
              takes.push_back(read_scene(file, job.stop, false));
            } else if (is_mesh(file)) {
              surfaces.push_back(read_surface(file));
            } else {
              takes.push_back(read(file, job.stop));
            }
            job.progress(static_cast<double>(takes.size() + surfaces.size()) /
                         static_cast<double>(files.size()));
          }
          return [this, takes, surfaces, text = tr("Import %1 files").arg(files.size())] {
            document_.undo_stack().beginMacro(text);
            for (const BackgroundJob::Apply& take : takes) {
              if (take) take();
            }
            if (!surfaces.empty()) add_surfaces(surfaces, text);
            document_.undo_stack().endMacro();
          };
        });
}

void SceneImport::import_volume(const fs::path& file, const VolumeFit& how) {
  start(file, [this, file, how](const Job& job) -> BackgroundJob::Apply {
    const auto gaussians = fit_volume(file, how, job);
    if (!gaussians) return {};
    return [this, gaussians] { add_gaussians(document_, *gaussians, tr("Import")); };
  });
}

void SceneImport::add_surfaces(const std::vector<Surface>& added, const QString& text) {
  document_.undo_stack().beginMacro(text);
  Surfaces surfaces = document_.scene().surfaces;
  surfaces.insert(surfaces.end(), added.begin(), added.end());
  set_scene_part(document_, std::move(surfaces), text);
  Q_EMIT surfaces_added();
  document_.undo_stack().endMacro();
}

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
    if (is_one_of(file, vtk_files)) {
      auto* dialog = new FolderDialog(file, run, window_);
      connect(dialog, &FolderDialog::requested, this,
              [this, run](const QString& folder) { import_vtk_files(run, to_path(folder)); });
      dialog->show();
      return;
    }
    start(file, [this, run](const Job&) { return read(run); });
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

void SceneImport::start_sequence(const FrameRun& run, const fs::path& folder, MakeFrames make) {
  fs::path names = fs::absolute(folder) / fs::path(run.files.text()).filename();
  names.replace_extension(".ply");
  start(run.files.file_of(run.first),
        [this, run, names, make = std::move(make)](const Job& job) -> BackgroundJob::Apply {
          std::vector<SequenceFrame> frames = make(job);
          const auto count = static_cast<std::size_t>(run.last - run.first) + 1;
          if (frames.size() != count || job.stop.stop_requested()) return {};
          // Only now, so that nothing is there of what was cancelled.
          const auto to = FramePattern::parse(names.string());
          if (!to) throw InputError(names, "", "is not a valid sequence name");
          fs::create_directories(names.parent_path());
          for (std::size_t k = 0; k < frames.size(); ++k) {
            const std::string file = to->file_of(run.first + static_cast<int>(k));
            write_gaussians(file, frames[k].gaussians, frames[k].ids);
          }
          MediumSequence sequence;
          sequence.file = names;
          sequence.first = run.first;
          sequence.last = run.last;
          sequence.frames = sequence_frames(std::move(frames));
          return [this, sequence] { add_sequence(sequence); };
        });
}

void SceneImport::import_volumes(const FrameRun& run, const VolumeFit& how,
                                 const fs::path& folder) {
  start_sequence(run, folder, [run, how](const Job& job) {
    std::vector<fs::path> files;
    for (int frame = run.first; frame <= run.last; ++frame)
      files.push_back(run.files.file_of(frame));
    return fit_volumes(files, how, job);
  });
}

void SceneImport::import_vtk_files(const FrameRun& run, const fs::path& folder) {
  start_sequence(run, folder, [run](const Job& job) {
    const auto read = [&](const fs::path& file, std::vector<GaussianNumber>* ids,
                          std::size_t max_count) {
      return read_vtk_points(file, ids, max_count, job.stop);
    };
    return read_sequence(run.files, run.first, run.last, read);
  });
}

}  // namespace brume
