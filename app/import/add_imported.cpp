#include "app/import/add_imported.h"

#include <algorithm>

#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/document/paths.h"
#include "brume/limits.h"
#include "core/scene/cameras.h"

namespace brume {

Surface surface_of(const std::shared_ptr<const ImportedScene>& scene) {
  Surface surface;
  surface.mesh_file = scene->files.front();
  surface.imported = scene;
  surface.mesh = joined_mesh(chosen_parts(*scene, {}));
  return surface;
}

void add_cameras(Document& document, const ImportedScene& scene, const QString& text) {
  CameraList list{camera_in_use(document.scene()), document.scene().cameras};
  if (list.others.size() + scene.cameras.size() > limits::cameras) {
    Q_EMIT document.refused(
        Document::tr("The scene would have more than %1 cameras.").arg(limits::cameras));
    return;
  }
  Scene names = document.scene();  // with those that are added
  for (const NamedCamera& camera : scene.cameras) {
    NamedCamera added = camera;
    added.name = free_camera_name(names, camera.name);
    names.cameras.push_back(added);
    list.others.push_back(std::move(added));
  }
  set_scene_part(document, std::move(list), text);
}

void add_lights(Document& document, const ImportedScene& scene, bool replace, const QString& text) {
  Lights lights = replace ? Lights() : document.scene().lights;
  if (lights.size() + scene.lights.size() > limits::lights) {
    Q_EMIT document.refused(
        Document::tr("The scene would have more than %1 lights.").arg(limits::lights));
    return;
  }
  lights.insert(lights.end(), scene.lights.begin(), scene.lights.end());
  set_scene_part(document, std::move(lights), text);
}

QString replace_imported(Document& document, const ImportedScene& scene,
                         const std::shared_ptr<const ImportedScene>& again) {
  const QString name = to_qstring(scene.files.front().filename());
  Surfaces surfaces = document.scene().surfaces;
  for (Surface& surface : surfaces) {
    if (surface.imported.get() != &scene) continue;
    auto mesh = joined_mesh(chosen_parts(*again, surface.nodes));
    if (!mesh) {
      return Document::tr("%1 has changed, and has no meshes any more that a surface shows.")
          .arg(name);
    }
    surface.imported = again;
    surface.mesh = std::move(mesh);
  }
  set_scene_part(document, std::move(surfaces), Document::tr("Reload %1").arg(name));
  return {};
}

}  // namespace brume
