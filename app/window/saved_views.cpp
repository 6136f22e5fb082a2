#include "app/window/saved_views.h"

#include <QSettings>
#include <QVariantMap>
#include <algorithm>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/viewport/viewport.h"
#include "brume/error.h"
#include "core/io/scene/fields_json.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"

namespace brume {
namespace {

constexpr const char* saved_views_key = "saved_views";
constexpr qsizetype max_saved_views = 50;  // the oldest go

QString camera_text(const Camera& camera) {
  Json object = Json::object();
  write_fields(object, camera, CameraKeys{});
  return QString::fromStdString(object.dump());
}

std::optional<Camera> saved_camera(const QString& text) {
  try {
    const Json value = parse_json({}, text.toStdString());
    JsonContext context({}, nullptr);
    JsonObject object(context, value, {});
    Camera camera;
    read_fields(object, camera);
    return refusal(camera) ? std::nullopt : std::optional(camera);
  } catch (const InputError&) {  // an edited or damaged file of settings
    return std::nullopt;
  }
}

QString saved_view_name(const QVariant& entry) {
  return entry.toMap().value("file").toString();
}

}  // namespace

SavedViews::SavedViews(Document& document, SceneFiles& files, Viewport& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
  connect(&view.camera_controller(), &CameraController::moved, this, &SavedViews::note_view);
  connect(&view.frames(), &FrameScheduler::picture_changed, this, &SavedViews::note_view);
  on_change(document, Change::file, this, &SavedViews::note_view);
  // Reloading the same file comes back to the present view.
  connect(&files.loading(), &BackgroundJob::started, this, &SavedViews::store);
  connect(&files, &SceneFiles::opened, this, &SavedViews::restore_view);
}

SavedViews::~SavedViews() {
  store();
}

void SavedViews::note_view() {
  if (document_.file() != file_) {
    store();
    file_ = document_.file();
  }
  camera_ =
      view_.camera() == document_.scene().camera ? std::nullopt : std::optional(view_.camera());
  exposure_ = view_.frames().exposure();
}

void SavedViews::restore_view() {
  const QString name = to_qstring(document_.file());
  for (const QVariant& entry : QSettings().value(saved_views_key).toList()) {
    if (saved_view_name(entry) != name) continue;
    if (const auto camera = saved_camera(entry.toMap().value("camera").toString())) {
      view_.camera_controller().set_camera(*camera);
    }
    const double exposure = entry.toMap().value("exposure").toDouble();
    view_.frames().set_exposure(std::clamp(exposure, -max_exposure, max_exposure));
  }
}

void SavedViews::store() {
  if (file_.empty()) return;
  const QString name = to_qstring(file_);
  QSettings settings;
  QVariantList views = settings.value(saved_views_key).toList();
  views.removeIf([&](const QVariant& entry) { return saved_view_name(entry) == name; });
  if (camera_ || exposure_ != 0.0) {
    views.prepend(QVariantMap{{"file", name},
                              {"camera", camera_ ? camera_text(*camera_) : QString()},
                              {"exposure", exposure_}});
  }
  settings.setValue(saved_views_key, QVariantList(views.mid(0, max_saved_views)));
}

}  // namespace brume
