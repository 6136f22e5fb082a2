#include "app/window/file_jobs.h"

#include <QCoreApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QMimeData>
#include <exception>
#include <glm/geometric.hpp>

#include "app/assets/asset_files.h"
#include "app/assets/save_asset.h"
#include "app/commands/gaussians/simplify_gaussians.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/gaussian_attribute.h"
#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/document/time/timeline.h"
#include "app/export/medium_dialog.h"
#include "app/files/file_dialogs.h"
#include "app/files/scene_files.h"
#include "app/import/add_imported.h"
#include "app/import/imported_reload.h"
#include "app/import/scene_import.h"
#include "app/view/camera/bounds.h"
#include "app/view/paint_point.h"
#include "app/viewport/view_grid.h"
#include "app/window/dialogs/simplify_dialog.h"
#include "app/window/import_size.h"
#include "app/window/pages/message_bar.h"
#include "core/authoring/simplify.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/gather.h"
#include "core/io/scene/scene_files.h"

namespace brume {
namespace {

bool is_scene(const std::filesystem::path& file) {
  return lower_case_extension(file) == ".brume";
}

// Does nothing once anything else than the light of File > New may light the scene. Otherwise that
// light moves outside the scene's contents, brighter by the square of the distance, and the camera
// frames them unless it is no longer the one of File > New or the view has moved. Without this,
// most meshes hold that light and that camera inside. Steps of the caller's macro.
// `framed`: the view where this last left it; undo does not move views. Returns whether it framed
// them.
bool light_new_scene(Document& document, View& view, Camera& framed) {
  const Scene& scene = document.scene();
  if (scene.environment || scene.lights != new_scene().lights) return false;
  const auto sphere = bounding_sphere(scene);
  if (!sphere) return false;
  const bool frames =
      has_new_camera(scene) && (view.camera() == scene.camera || view.camera() == framed);
  if (frames) {
    view.camera_controller().frame_all();
    framed = view.camera();
    set_scene_part(document, KeyedCamera{framed, {}}, {});
  }
  const Light light = light_outside(sphere->center, sphere->radius, view.camera().eye);
  set_scene_part(document, Lights{light}, {});
  return frames;
}

Viewport* viewport_at(QWidget& window, const QPoint& position) {
  QWidget* widget = window.childAt(position);
  while (widget && !qobject_cast<Viewport*>(widget)) widget = widget->parentWidget();
  return qobject_cast<Viewport*>(widget);
}

QString simplify_text(const char* source) {
  return QCoreApplication::translate("Simplify", source);
}

// Background work that simplifies Gaussians chosen from the document, and hands the result to
// `done`. `show_status` is called with how many Gaussians became how many, and the error. Nothing
// is merged if the fog is edited meanwhile.
BackgroundJob::Work simplifying(Document& document, const std::shared_ptr<const Medium>& chosen,
                                const SimplifyLimits& limits,
                                const std::function<void(const QString&)>& show_status,
                                const std::function<void(const Simplified&)>& done) {
  const Revision revision = document.medium().revision();
  return [=, &document](const Job& job) -> BackgroundJob::Apply {
    const auto found = simplify(*chosen, limits, job.stop, job.progress);
    if (!found) return {};
    return [=, &document, found = *found] {
      if (document.medium().revision() != revision) {
        show_status(simplify_text("The fog has changed meanwhile; nothing is simplified"));
      } else if (found.merged.empty()) {
        show_status(simplify_text("No Gaussians can be merged within this error"));
      } else {
        done(found);
        show_status(simplify_text("%1 became %2, with an error of %3%")
                        .arg(gaussians_text(chosen->size()))
                        .arg(found.kept.size() + found.merged.size())
                        .arg(number_text(100.0 * found.error)));
      }
    };
  };
}

}  // namespace

FileJobs::FileJobs(const Workspace& work, QWidget* window)
    : QObject(window),
      work_(work),
      window_(window),
      import_(new SceneImport(work.document, job_, window)),
      reload_(new ImportedReload(work.document, window)) {
  MessageBar* messages = &work_.messages;
  connect(&job_, &BackgroundJob::cancelled, this, [this] { work_.show_status(tr("Cancelled")); });
  connect(&job_, &BackgroundJob::failed, messages, &MessageBar::show_error);
  connect(&adjusting_, &BackgroundJob::failed, messages, &MessageBar::show_error);
  // The result for an operation is of no use to another one.
  connect(&work_.document.last_operation(), &LastOperation::changed, &adjusting_,
          &BackgroundJob::cancel);
  connect(import_, &SceneImport::failed, messages, &MessageBar::show_error);
  connect(import_, &SceneImport::warned, messages, &MessageBar::show_note);
  connect(reload_, &ImportedReload::failed, messages, &MessageBar::show_error);
  connect(reload_, &ImportedReload::warned, messages, &MessageBar::show_note);
  connect(import_, &SceneImport::camera_used, this,
          [this] { work_.views.perspective().camera_controller().look_through_scene_camera(); });
  auto* size = new ImportSize(work_, this);
  connect(import_, &SceneImport::surfaces_added, this,
          [this, size, framed = Camera{}](std::size_t first, bool is_at_spot) mutable {
            const bool is_framed =
                light_new_scene(work_.document, work_.views.perspective(), framed);
            const bool is_new = !work_.document.scene().surfaces[first].primitive &&
                                !work_.document.last_operation().is_adjusting();
            // The view stays if the user chose the place.
            if (is_new) size->show(first, is_framed || is_at_spot);
          });
}

void FileJobs::start(const QString& title, const BackgroundJob::Work& job) {
  if (!job_.start(job, title)) {
    work_.show_status(tr("Another import or export is still running."));
  }
}

void FileJobs::export_medium() {
  auto* dialog = new MediumDialog(work_.document, work_.timeline,
                                  work_.views.perspective().frames().exposure(), window_);
  connect(dialog, &MediumDialog::requested, this, [this](const MediumExport& what) {
    const QString name = to_qstring(what.file.filename());
    start(tr("Exporting %1").arg(name), brume::export_medium(what));
  });
  dialog->show();
}

void FileJobs::gather() {
  QFileDialog dialog(window_, tr("Gather into a New Folder"),
                     last_folder(FileKind::gather, work_.document.folder()));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setLabelText(QFileDialog::FileName, tr("Folder"));
  if (dialog.exec() != QDialog::Accepted) return;
  const std::filesystem::path folder = to_path(dialog.selectedFiles().value(0));
  remember_folder(FileKind::gather, folder);
  gather_to(folder);
}

void FileJobs::gather_to(const std::filesystem::path& folder) {
  const Document& document = work_.document;
  const std::string name =
      document.file().empty() ? std::string("scene") : document.file().stem().string();
  start(tr("Gathering"), [this, folder, name, scene_folder = to_path(document.folder()),
                          scene = document.document_to_save()](const Job& job) {
    gather_scene(scene, folder, name, job.stop);
    QString text = tr("Gathered in %1").arg(to_qstring(folder));
    if (const auto others = static_cast<int>(files_outside(scene, scene_folder).size())) {
      text += tr(", with %n file(s) from outside the scene's folder", nullptr, others);
    }
    return [this, text] { work_.show_status(text); };
  });
}

void FileJobs::simplify() {
  auto* dialog = new SimplifyDialog(work_.document, window_);
  connect(dialog, &SimplifyDialog::requested, this, [this](const SimplifyNumbers& numbers) {
    const std::vector<GaussianId> ids = to_simplify(work_.document);
    const auto chosen =
        std::make_shared<const Medium>(chosen_gaussians(work_.document.medium(), ids));
    LastOperation& last = work_.document.last_operation();
    const auto apply = [this, ids](const Simplified& found) {
      apply_simplified(work_.document, ids, found);
    };
    const LastOperation::Operation operation{
        tr("Simplify"), numbers,
        [this, chosen, apply, &last](const std::any& wanted) {
          adjusting_.start(simplifying(
              work_.document, chosen, limits_of(std::any_cast<SimplifyNumbers>(wanted)),
              work_.show_status,
              [apply, &last](const Simplified& found) { last.complete([&] { apply(found); }); }));
        },
        true};
    start(tr("Simplifying"),
          simplifying(work_.document, chosen, limits_of(numbers), work_.show_status,
                      [apply, operation, &last](const Simplified& found) {
                        last.record(operation, [&] { apply(found); });
                      }));
  });
  dialog->show();
}

// Lights hang a little before what is under the mouse; everything else stands on it.
void FileJobs::add_asset(const std::filesystem::path& file, View& view, QPointF position) {
  try {
    const std::optional<AssetKind> kind = asset_kind(file);
    if (kind == AssetKind::brush) return use_brush(work_.tools, file);
    const double room = kind == AssetKind::light ? 0.05 * view.distance() : 0.0;
    ImportSpot spot{view.camera().target};
    if (const auto point = paint_point(view, {}, position, room)) {
      spot.point = point->position;
      const bool is_seen_from_front = glm::dot(point->normal, view.rays().forward()) < 0.0;
      if (point->on_surface) spot.normal = is_seen_from_front ? point->normal : -point->normal;
    }
    import_->import_asset(file, spot);
  } catch (const std::exception& error) {
    work_.messages.show_error(QString::fromUtf8(error.what()));
  }
}

void FileJobs::drop(QDropEvent& event) {
  if (event.mimeData()->hasFormat(asset_mime)) {
    const QPointF position = event.position();
    Viewport* view = viewport_at(*window_, position.toPoint());
    if (!view) return;
    add_asset(to_path(QString::fromUtf8(event.mimeData()->data(asset_mime))), *view,
              view->mapFrom(window_, position));
    return event.acceptProposedAction();
  }
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event.mimeData()->urls()) {
    if (url.isLocalFile()) {
      files.push_back(to_path(url.toLocalFile()));
    } else {
      work_.messages.show_error(
          tr("%1 is no file of this computer. Download it, and drop the file.")
              .arg(url.toDisplayString()));
    }
  }
  if (files.empty()) return;
  if (files.size() == 1 && is_scene(files.front())) {
    work_.files.open_file(files.front());
  } else {
    import_->import_files(files);
  }
  event.acceptProposedAction();
}

void FileJobs::check_imported() {
  reload_->check();
}

}  // namespace brume
