#include "app/window/saved_views.h"

#include <QSettings>
#include <QVariantMap>
#include <array>
#include <cmath>

#include "app/document/document.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/view/view.h"

namespace brume {
namespace {

constexpr const char* saved_views_key = "saved_views";
constexpr qsizetype max_saved_views = 50;  // the oldest go

QVariantList camera_numbers(const Camera& camera) {
  QVariantList numbers;
  for (const glm::dvec3& v : {camera.eye, camera.target, camera.up}) numbers << v.x << v.y << v.z;
  return numbers << camera.vertical_fov;
}

std::optional<Camera> saved_camera(const QVariantList& numbers) {
  if (numbers.size() != 10) return std::nullopt;
  std::array<double, 10> v{};
  for (std::size_t k = 0; k < v.size(); ++k) {
    v[k] = numbers[static_cast<qsizetype>(k)].toDouble();
    if (!std::isfinite(v[k])) return std::nullopt;
  }
  const Camera camera{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9]};
  const bool is_valid =
      v[9] > 0.0 && v[9] < 180.0 && camera.eye != camera.target && camera.up != glm::dvec3(0.0);
  return is_valid ? std::optional(camera) : std::nullopt;
}

QString saved_view_name(const QVariant& entry) {
  return entry.toMap().value("file").toString();
}

}  // namespace

SavedViews::SavedViews(Document& document, SceneFiles& files, View& view, QObject* parent)
    : QObject(parent), document_(document), view_(view) {
  connect(&view.camera_controller(), &CameraController::moved, this, &SavedViews::note_view);
  connect(&document, &Document::file_changed, this, &SavedViews::note_view);
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
}

void SavedViews::restore_view() {
  const QString name = to_qstring(document_.file());
  for (const QVariant& entry : QSettings().value(saved_views_key).toList()) {
    if (saved_view_name(entry) != name) continue;
    if (const auto camera = saved_camera(entry.toMap().value("camera").toList())) {
      view_.camera_controller().set_camera(*camera);
    }
  }
}

void SavedViews::store() {
  if (file_.empty()) return;
  const QString name = to_qstring(file_);
  QSettings settings;
  QVariantList views = settings.value(saved_views_key).toList();
  views.removeIf([&](const QVariant& entry) { return saved_view_name(entry) == name; });
  if (camera_) {
    views.prepend(QVariantMap{{"file", name}, {"camera", camera_numbers(*camera_)}});
  }
  settings.setValue(saved_views_key, QVariantList(views.mid(0, max_saved_views)));
}

}  // namespace brume
