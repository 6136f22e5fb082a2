#include "app/import/add_imported.h"

#include <algorithm>

#include "app/commands/objects/edit_cameras.h"
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

namespace {

// Textures that a changed material has from its file are those of the file that is read again.
void follow_textures(Material& material, const ImportedScene& scene, const ImportedScene& again) {
  const Material* read_again = material_of_file(again, material.name);
  if (!read_again) return;
  const auto is_of_file = are_of_file(scene, material);
  const auto textures = textures_of(material.metallic_roughness);
  const auto textures_again = textures_of(read_again->metallic_roughness);
  for (std::size_t k = 0; k < textures.size(); ++k) {
    if (is_of_file[k]) *textures[k] = *textures_again[k];
  }
}

}  // namespace

std::vector<Gaussian> placed(std::vector<Gaussian> gaussians, const ImportPlacement& placement) {
  for (Gaussian& gaussian : gaussians) {
    gaussian.center = placement.position + placement.scale * gaussian.center;
    gaussian.radius *= placement.scale;
    gaussian.density /= placement.scale;
  }
  return gaussians;
}

bool has_new_camera(const Scene& scene) {
  return scene.cameras.empty() &&
         KeyedCamera{scene.camera, scene.camera_keys} == KeyedCamera{new_scene().camera, {}};
}

void add_cameras(Document& document, const ImportedScene& scene, const QString& text) {
  CameraList list{camera_in_use(document.scene()), document.scene().cameras};
  if (list.others.size() + scene.cameras.size() > limits::cameras) {
    Q_EMIT document.refused(
        Document::tr("The scene would have more than %1 cameras.").arg(limits::cameras));
    return;
  }
  const bool is_first = has_new_camera(document.scene());
  Scene names = document.scene();  // with those that are added
  if (is_first) names.camera_name.clear();
  for (const NamedCamera& camera : scene.cameras) {
    NamedCamera added = camera;
    added.name = allowed_camera_name(names, QString::fromStdString(camera.name));
    names.cameras.push_back(added);
    list.others.push_back(std::move(added));
  }
  if (is_first) {
    list.in_use = list.others.front();
    list.others.erase(list.others.begin());
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
    for (Material& material : surface.materials) follow_textures(material, scene, *again);
    surface.imported = again;
    surface.mesh = std::move(mesh);
  }
  set_scene_part(document, std::move(surfaces), Document::tr("Reload %1").arg(name));
  return {};
}

}  // namespace brume
