#include "app/commands/objects/edit_cameras.h"

#include <algorithm>
#include <utility>

#include "app/commands/allowed_name.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/limits.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"

namespace brume {
namespace {

CameraList camera_list(const Document& document) {
  const Scene& scene = document.scene();
  return {camera_in_use(scene), scene.cameras};
}

NamedCamera* find(CameraList& list, const std::string& name) {
  if (list.in_use.name == name) return &list.in_use;
  const auto found = std::ranges::find(list.others, name, &NamedCamera::name);
  return found == list.others.end() ? nullptr : &*found;
}

// `camera` has a name of its own. False, with a message, if there are as many as allowed.
bool add(Document& document, NamedCamera camera, const QString& text) {
  CameraList list = camera_list(document);
  if (list.others.size() >= limits::cameras) {
    Q_EMIT document.refused(Document::tr("A scene has %1 cameras at most.").arg(limits::cameras));
    return false;
  }
  list.others.push_back(std::exchange(list.in_use, std::move(camera)));
  set_scene_part(document, std::move(list), text);
  return true;
}

// Files may have the name, with a number as well.
std::string short_name(const QString& name) {
  return allowed_name(name, 10).toStdString();
}

}  // namespace

QStringList camera_names(const Scene& scene) {
  QStringList names{QString::fromStdString(scene.camera_name)};
  for (const NamedCamera& camera : scene.cameras) names << QString::fromStdString(camera.name);
  return names;
}

// An edit renames one camera, in its place, or none.
QString camera_name_after(const QStringList& names_before, const QStringList& names_after,
                          const QString& name) {
  if (names_after.contains(name)) return name;
  const qsizetype place = names_before.indexOf(name);
  const bool is_renamed = place >= 0 && names_before.size() == names_after.size() &&
                          !names_before.contains(names_after[place]);
  return is_renamed ? names_after[place] : QString();
}

const Camera* find_camera(const Scene& scene, const QString& name) {
  if (name.toStdString() == scene.camera_name) return &scene.camera;
  const auto found = std::ranges::find(scene.cameras, name.toStdString(), &NamedCamera::name);
  return found == scene.cameras.end() ? nullptr : &found->camera;
}

std::string allowed_camera_name(const Scene& scene, const QString& wanted) {
  const std::string name = short_name(wanted);
  return free_camera_name(scene, name.empty() ? default_camera_name : name);
}

bool add_camera(Document& document, const Camera& camera) {
  const std::string name = free_camera_name(document.scene(), default_camera_name);
  return add(document, {name, camera, {}},
             undo_text("Add camera %1").arg(QString::fromStdString(name)));
}

bool duplicate_camera(Document& document, const QString& name) {
  CameraList list = camera_list(document);
  const NamedCamera* camera = find(list, name.toStdString());
  if (!camera) return false;
  NamedCamera copy = *camera;
  copy.name = allowed_camera_name(document.scene(), name);
  return add(document, std::move(copy), undo_text("Duplicate camera %1").arg(name));
}

void use_camera(Document& document, const QString& name) {
  CameraList list = camera_list(document);
  NamedCamera* camera = find(list, name.toStdString());
  if (!camera || camera == &list.in_use) return;
  std::swap(*camera, list.in_use);
  set_scene_part(document, std::move(list), undo_text("Use camera %1").arg(name));
}

void rename_camera(Document& document, const QString& name, const QString& new_name) {
  const std::string wanted = short_name(new_name);
  CameraList list = camera_list(document);
  NamedCamera* camera = find(list, name.toStdString());
  if (!camera || new_name == name || wanted.empty() || wanted == camera->name) {
    document.announce(Change::part);  // fields show what is, not what was wanted
    return;
  }
  camera->name = free_camera_name(document.scene(), wanted);
  const QString text =
      undo_text("Rename camera %1 to %2").arg(name, QString::fromStdString(camera->name));
  set_scene_part(document, std::move(list), text);
}

void delete_camera(Document& document, const QString& name) {
  CameraList list = camera_list(document);
  NamedCamera* camera = find(list, name.toStdString());
  if (!camera) return;
  if (list.others.empty()) {
    Q_EMIT document.refused(Document::tr("A scene keeps one camera."));
    return;
  }
  if (camera == &list.in_use) {
    list.in_use = std::move(list.others.front());
    list.others.erase(list.others.begin());
  } else {
    list.others.erase(list.others.begin() + (camera - list.others.data()));
  }
  set_scene_part(document, std::move(list), undo_text("Delete camera %1").arg(name));
}

KeyedCamera keyed_camera(const Document& document, const Camera& camera) {
  KeyedCamera part{camera, document.scene().camera_keys};
  clear_keys_of_absent(part.camera, part.keys);
  return part;
}

void set_camera(Document& document, const QString& name, const Camera& camera, const QString& what,
                MergeId gesture) {
  const QString text = undo_text("Set %1").arg(what);
  if (name.toStdString() == document.scene().camera_name) {
    return set_scene_part(document, keyed_camera(document, camera), text, gesture);
  }
  Cameras cameras = document.scene().cameras;
  const auto found = std::ranges::find(cameras, name.toStdString(), &NamedCamera::name);
  if (found == cameras.end()) return;
  found->camera = camera;
  clear_keys_of_absent(found->camera, found->keys);
  set_scene_part(document, std::move(cameras), text, gesture);
}

void move_camera(Document& document, const Camera& camera, MergeId gesture) {
  set_scene_part(document, keyed_camera(document, camera), undo_text("Move camera"), gesture);
}

}  // namespace brume
