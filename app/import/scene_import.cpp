#include "app/import/scene_import.h"

#include <algorithm>
#include <exception>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/document/text/words.h"
#include "app/files/file_dialogs.h"
#include "app/import/add_asset.h"
#include "app/import/add_imported.h"
#include "app/import/asset_kind.h"
#include "app/import/dialogs/scene_dialog.h"
#include "app/import/dialogs/volume_dialog.h"
#include "app/import/import_kind.h"
#include "app/import/vtk_points.h"
#include "brume/error.h"
#include "brume/files.h"
#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/gaussians/sequence_file.h"
#include "core/io/image/radiance_map_file.h"
#include "core/io/import/imported_scene_file.h"
#include "core/io/ply.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_file.h"
#include "core/medium/splat.h"

namespace brume {
namespace fs = std::filesystem;
namespace {

std::vector<Gaussian> read_splats(const fs::path& file, const SplatOptions& options,
                                  std::vector<std::string>* warnings,
                                  std::vector<GaussianNumber>* ids = nullptr,
                                  std::size_t max_count = limits::gaussians) {
  std::vector<Gaussian> gaussians = read_gaussians(file, ids, max_count, options.input, warnings);
  if (options.up == SplatUp::minus_y) std::ranges::for_each(gaussians, turn_half);
  if (options.up == SplatUp::z) std::ranges::for_each(gaussians, turn_z_up);
  return gaussians;
}

std::vector<Gaussian> read_any_gaussians(const fs::path& file, const std::stop_token& stop) {
  return is_vtk_file(file) ? read_vtk_points(file, nullptr, limits::gaussians, stop)
                           : read_gaussians(file);
}

Surface placed(Surface surface, const ImportPlacement& placement) {
  surface.scale *= placement.scale;
  surface.translate = placement.position + placement.scale * surface.translate;
  return surface;
}

// The sequence that all these files belong to, at least two; nullopt otherwise.
std::optional<FrameRun> run_of(const std::vector<fs::path>& files) {
  std::optional<FramePattern> pattern;
  for (const fs::path& file : files) {
    if (!may_be_frame(file)) return {};
    const auto around = FramePattern::around(file.string());
    if (!around || (pattern && pattern->text() != around->text())) return {};
    pattern = around;
  }
  return frames_around(files.front());
}

}  // namespace

SceneImport::SceneImport(Document& document, BackgroundJob& job, QWidget* window)
    : QObject(window), document_(document), job_(job), window_(window) {}

bool SceneImport::needs_answer(const File& file) {
  return file.kind == ImportKind::splats && max_gaussian_count(file.path) > 0;
}

void SceneImport::ask() {
  const fs::path file = ask_for_file(
      window_, FileKind::import, tr("Import"),
      tr("All supported files (*.vdb *.csv *.ply *.vtp *.vtu *.gltf *.glb *.fbx *.obj *.stl *.off "
         "*.exr *.hdr);;Scenes (*.gltf *.glb *.fbx *.obj);;Volumes (*.vdb);;Gaussians (*.csv *.ply "
         "*.vtp *.vtu *.gltf *.glb);;Meshes (*.obj *.ply *.stl *.off);;"
         "Environments (*.exr *.hdr);;All files (*)"),
      document_.folder());
  if (!file.empty()) import_file(file);
}

void SceneImport::ask_sequence() {
  const fs::path file =
      ask_for_file(window_, FileKind::import, tr("Import a Sequence: Choose Any Frame"),
                   tr("Frames (*.vdb *.csv *.ply *.vtp *.vtu);;All files (*)"), document_.folder());
  if (!file.empty()) import_sequence(file);
}

bool SceneImport::start(const fs::path& file, const BackgroundJob::Work& work) {
  if (job_.start(work, tr("Importing %1").arg(to_qstring(file.filename())))) return true;
  Q_EMIT failed(tr("Another import or export is still running."));
  return false;
}

void SceneImport::import_file(const fs::path& given, const std::optional<ImportSpot>& spot) {
  const fs::path path = fs::absolute(given);
  if (is_volume(path)) {
    auto* dialog = new VolumeDialog(path, std::nullopt, window_);
    connect(dialog, &VolumeDialog::requested, this,
            [this, path](const VolumeFit& how) { import_volume(path, how); });
    dialog->show();
    return;
  }
  start(path, [this, path, spot](const Job& job) -> BackgroundJob::Apply {
    const File file{path, import_kind_of(path), spot};
    if (!needs_answer(file)) return read(file, {}, job.stop, true);
    return [this, file] {
      ask_about_splats(to_qstring(file.path.filename()), [this, file](const SplatOptions& options) {
        start(file.path, [this, file, options](const Job& answered) {
          return read(file, options, answered.stop, true);
        });
      });
    };
  });
}

void SceneImport::import_asset(const fs::path& file, const std::optional<ImportSpot>& spot) {
  if (lower_case_extension(file) != ".brume") return import_file(file, spot);
  start(file, [this, file, spot](const Job&) -> BackgroundJob::Apply {
    std::vector<std::string> warnings;
    const auto asset = std::make_shared<const Scene>(load_document(file, &warnings).scene);
    return [this, asset, spot, name = asset_name(file), text = lines_of(warnings)] {
      if (!text.isEmpty()) Q_EMIT warned(text);
      add_placed(tr("Add %1").arg(name), box_of_asset(*asset), spot,
                 [this, asset, name](const QString& step, const ImportPlacement& placement) {
                   add_asset(document_, *asset, name, placement, step);
                 });
    };
  });
}

void SceneImport::ask_about_splats(const QString& what,
                                   const std::function<void(const SplatOptions&)>& import_them) {
  auto* dialog = new SplatDialog(what, std::nullopt, window_);
  connect(dialog, &SplatDialog::requested, this, import_them);
  dialog->show();
}

void SceneImport::ask_about_splats(const FrameRun& run) {
  auto* dialog = new SplatDialog(to_qstring(fs::path(run.files.text()).filename()), run, window_);
  connect(dialog, &SplatDialog::requested, this, [this, run, dialog](const SplatOptions& options) {
    import_splats(run, options, dialog->folder());
  });
  dialog->show();
}

BackgroundJob::Apply SceneImport::read(const File& file, const SplatOptions& options,
                                       const std::stop_token& stop, bool asks) {
  const fs::path& path = file.path;
  switch (file.kind) {
    case ImportKind::environment: {
      std::vector<std::string> warnings;
      const auto map = read_radiance_map(path, &warnings);
      return [this, path, map, text = lines_of(warnings)] {
        if (!text.isEmpty()) Q_EMIT warned(text);
        Environment environment = document_.scene().environment.value_or(Environment{});
        environment.file = path;
        environment.map = map;
        environment.sky.reset();
        set_scene_part(document_, std::optional(std::move(environment)),
                       tr("Import environment %1").arg(to_qstring(path.filename())));
      };
    }
    case ImportKind::scene:
      return read_scene(file, options, stop, asks);
    case ImportKind::mesh: {
      std::vector<std::string> warnings;
      const Surface surface = load_surface(path, &warnings);
      return [this, surface, spot = file.spot, text = lines_of(warnings)] {
        if (!text.isEmpty()) Q_EMIT warned(text);
        add_placed(tr("Import %1").arg(to_qstring(surface.mesh_file.filename())),
                   world_box(surface), spot,
                   [this, surface, is_at_spot = spot.has_value()](
                       const QString& name, const ImportPlacement& placement) {
                     add_surfaces({placed(surface, placement)}, name, is_at_spot);
                   });
      };
    }
    case ImportKind::splats:
      if (is_scene_file(path)) return read_scene(file, options, stop, asks);
      return add_splats(file, options);
    case ImportKind::gaussians:
      break;
  }
  return [this, spot = file.spot, gaussians = read_any_gaussians(path, stop)] {
    add_placed(gaussians, spot);
  };
}

BackgroundJob::Apply SceneImport::add_splats(const File& file, const SplatOptions& options) {
  std::vector<std::string> warnings;
  std::vector<Gaussian> gaussians = read_splats(file.path, options, &warnings);
  return [this, spot = file.spot, gaussians = std::move(gaussians), text = lines_of(warnings)] {
    if (!text.isEmpty()) Q_EMIT warned(text);
    add_placed(gaussians, spot);
  };
}

BackgroundJob::Apply SceneImport::read_scene(const File& file, const SplatOptions& options,
                                             const std::stop_token& stop, bool asks) {
  const bool has_splats = file.kind == ImportKind::splats;
  std::vector<std::string> warnings;
  std::vector<Gaussian> gaussians;
  if (has_splats) gaussians = read_splats(file.path, options, &warnings);
  const std::shared_ptr<const ImportedScene> scene = read_imported_scene(file.path, warnings, stop);
  if (!scene) return {};
  const bool is_empty = scene->parts.empty() && scene->cameras.empty() && scene->lights.empty();
  if (is_empty && gaussians.empty()) {
    throw InputError(
        file.path, "",
        has_splats ? "its medium is empty" : "found neither meshes nor cameras nor lights");
  }
  return [this, scene, gaussians, asks, is_empty, spot = file.spot, text = lines_of(warnings)] {
    if (!text.isEmpty()) Q_EMIT warned(text);
    if (is_empty) return add_placed(gaussians, spot);
    if (!asks || (scene->cameras.empty() && scene->lights.empty())) {
      add_scene({scene, gaussians, spot}, true, true);
      return;
    }
    auto* dialog = new SceneDialog(*scene, window_);
    connect(dialog, &SceneDialog::requested, this,
            [this, scene, gaussians, spot](bool cameras, bool lights) {
              add_scene({scene, gaussians, spot}, cameras, lights);
            });
    dialog->show();
  };
}

void SceneImport::add_scene(const ReadScene& found, bool cameras, bool lights) {
  const QString text = tr("Import %1").arg(to_qstring(found.scene->files.front().filename()));
  const auto add = [this, found, cameras, lights](const QString& name,
                                                  const ImportPlacement& placement) {
    const auto& [scene, gaussians, spot] = found;
    const Scene& before = document_.scene();
    const bool is_new = before.lights == new_scene().lights && !before.environment;
    const bool has_cameras = cameras && !scene->cameras.empty();
    const bool uses_camera = has_cameras && has_new_camera(before);
    document_.undo_stack().beginMacro(name);
    if (!gaussians.empty()) add_gaussians(document_, gaussians, tr("Import"));
    if (has_cameras) add_cameras(document_, *scene, name);
    if (uses_camera) Q_EMIT camera_used();
    if (!scene->parts.empty()) {
      add_surfaces({placed(surface_of(scene), placement)}, name, spot.has_value());
    }
    if (lights && !scene->lights.empty()) add_lights(document_, *scene, is_new, name);
    document_.undo_stack().endMacro();
  };
  // All else of the file stays where the file has it.
  const ImportedScene& scene = *found.scene;
  const bool is_mesh = found.gaussians.empty() && !scene.parts.empty() &&
                       !(cameras && !scene.cameras.empty()) && !(lights && !scene.lights.empty());
  is_mesh ? add_placed(text, world_box(surface_of(found.scene)), found.spot, add) : add(text, {});
}

void SceneImport::add_placed(const std::vector<Gaussian>& gaussians,
                             const std::optional<ImportSpot>& spot) {
  Scene all;
  for (const Gaussian& gaussian : gaussians) all.medium.append(gaussian);
  add_placed(tr("Import"), box_of_asset(all), spot,
             [this, gaussians](const QString& name, const ImportPlacement& placement) {
               add_gaussians(document_, placed(gaussians, placement), name);
             });
}

void SceneImport::add_placed(const QString& text, const MeshBox& box,
                             const std::optional<ImportSpot>& spot, const AddPlaced& add) {
  ImportPlacement start;
  if (spot) start.position = spot->shift_of(box);
  document_.last_operation().perform({text, start, [text, add](const std::any& placement) {
                                        add(text, std::any_cast<ImportPlacement>(placement));
                                      }});
}

BackgroundJob::Apply SceneImport::read(const FrameRun& run) {
  MediumSequence sequence;
  sequence.file = run.files.text();
  sequence.first = run.first;
  sequence.last = run.last;
  std::vector<std::string> warnings;
  sequence.frames = open_sequence(run.files, run.first, run.last, read_gaussian_frame,
                                  limits::gaussians, &warnings);
  return [this, sequence, text = lines_of(warnings)] {
    if (!text.isEmpty()) Q_EMIT warned(text);
    add_sequence(sequence);
  };
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
        [this, paths = read_at_once, run](const Job& job) -> BackgroundJob::Apply {
          std::vector<File> found;
          for (const fs::path& path : paths) found.push_back({path, import_kind_of(path)});
          if (run && found.front().kind == ImportKind::splats) {
            return [this, run = *run] { ask_about_splats(run); };
          }
          if (run && found.front().kind != ImportKind::mesh) return read(*run);
          // Once for all of them.
          if (std::ranges::none_of(found, needs_answer)) return read(found, {}, job);
          return [this, found] {
            ask_about_splats(tr("%n file(s)", nullptr, static_cast<int>(found.size())),
                             [this, found](const SplatOptions& options) {
                               start(found.front().path,
                                     [this, found, options](const Job& answered) {
                                       return read(found, options, answered);
                                     });
                             });
          };
        });
}

BackgroundJob::Apply SceneImport::read(const std::vector<File>& files, const SplatOptions& options,
                                       const Job& job) {
  std::vector<BackgroundJob::Apply> takes;
  std::vector<Surface> surfaces;  // added together, after what else may light them
  std::vector<std::string> warnings;
  for (const File& file : files) {
    if (job.stop.stop_requested()) return {};
    if (file.kind == ImportKind::mesh) {
      surfaces.push_back(load_surface(file.path, &warnings));
    } else {
      takes.push_back(read(file, options, job.stop, false));
    }
    job.progress(static_cast<double>(takes.size() + surfaces.size()) /
                 static_cast<double>(files.size()));
  }
  return [this, takes, surfaces, lines = lines_of(warnings),
          text = tr("Import %n file(s)", nullptr, static_cast<int>(files.size()))] {
    if (!lines.isEmpty()) Q_EMIT warned(lines);
    document_.undo_stack().beginMacro(text);
    for (const BackgroundJob::Apply& take : takes) {
      if (take) take();
    }
    if (!surfaces.empty()) add_surfaces(surfaces, text);
    document_.undo_stack().endMacro();
  };
}

void SceneImport::import_volume(const fs::path& file, const VolumeFit& how) {
  const auto preview = std::make_shared<VolumePreview>();
  const bool is_started = start(file, [=, this](const Job& job) -> BackgroundJob::Apply {
    const QString text = lines_of(volume_warnings(file));
    VolumeFit quick = how;
    quick.is_preview = true;
    const auto first = fit_volume(file, quick, {job.stop, {}});
    if (!first) return {};
    job_.deliver(job, [this, preview, first] {
      preview->gaussians = *first;
      show_preview(document_, preview);
      if (preview->ids.empty()) job_.cancel();
    });
    const auto gaussians = fit_volume(file, how, job);
    if (!gaussians) return {};
    return [=, this] {
      QStringList notes;
      if (!text.isEmpty()) notes << text;
      if (!refine_preview(document_, *preview, *gaussians)) {
        notes << tr("The preview of %1 has been changed, so it stays: the fit does not replace it.")
                     .arg(to_qstring(file.filename()));
      }
      if (!notes.isEmpty()) Q_EMIT warned(notes.join('\n'));
    };
  });
  if (!is_started) return;
  auto* fit = new QObject(this);  // until it ends
  connect(&job_, &BackgroundJob::ended, fit, &QObject::deleteLater);
  follow_preview(document_, preview, fit, [this] { job_.cancel(); });
}

void SceneImport::add_surfaces(const std::vector<Surface>& added, const QString& text,
                               bool is_at_spot) {
  document_.undo_stack().beginMacro(text);
  Surfaces surfaces = document_.scene().surfaces;
  const std::size_t first = surfaces.size();
  surfaces.insert(surfaces.end(), added.begin(), added.end());
  set_scene_part(document_, std::move(surfaces), text);
  if (document_.scene().surfaces.size() > first) {
    document_.set_object(ObjectRef{ObjectRef::Kind::surface, first});
    Q_EMIT surfaces_added(first, is_at_spot);
  }
  document_.undo_stack().endMacro();
}

void SceneImport::import_splats(const FrameRun& run, const SplatOptions& options,
                                const fs::path& folder) {
  start_sequence(run, folder, [run, options](const Job&, std::vector<std::string>& all) {
    const auto read = [&](const fs::path& file, std::vector<GaussianNumber>* ids,
                          std::size_t max_count, std::vector<std::string>* warnings) {
      return read_splats(file, options, warnings, ids, max_count);
    };
    return read_sequence(run.files, run.first, run.last, read, limits::gaussians, &all);
  });
}

}  // namespace brume
