#include "app/import/add_asset.h"

#include <glm/common.hpp>
#include <optional>
#include <utility>

#include "app/commands/gaussian_budget.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/objects/edit_cameras.h"
#include "app/commands/objects/edit_objects.h"
#include "app/commands/scene_part_command.h"
#include "app/document/document.h"
#include "app/import/add_imported.h"
#include "brume/limits.h"
#include "core/scene/cameras.h"
#include "core/scene/copies.h"

namespace brume {
namespace {

Movement movement_of(const ImportPlacement& placement) {
  return {
      .shift = placement.position, .stretch = glm::dvec3(placement.scale), .size = placement.scale};
}

void move_keys(Keys<glm::dvec3>& keys, const Movement& movement) {
  for (Key<glm::dvec3>& key : keys) {
    key.value = movement.point(key.value);
    for (std::optional<glm::dvec3>* slope : {&key.in, &key.out}) {
      if (*slope) **slope *= movement.size;
    }
  }
}

Light placed(const Light& light, const Movement& movement) {
  Light result = std::get<Light>(moved(light, movement));
  move_keys(result.keys.position, movement);
  return result;
}

Surface placed(const Surface& surface, const Movement& movement) {
  Surface result = std::get<Surface>(moved(surface, movement));
  move_keys(result.keys.translate, movement);
  for (Key<double>& key : result.keys.scale) key.value *= movement.size;
  return result;
}

std::vector<Gaussian> gaussians_of(const Scene& asset) {
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < asset.medium.size(); ++i) {
    gaussians.push_back(asset.medium.gaussian(i));
    gaussians.back().group = 0;
  }
  return gaussians;
}

// The new group has the values of the asset's, where that has one.
void add_as_group(Document& document, const Scene& asset, const QString& name,
                  const ImportPlacement& placement, const QString& text) {
  add_gaussians(document, placed(gaussians_of(asset), placement), text);
  group_selection(document, name);
  if (asset.groups.size() != 1 || !document.active_group()) return;
  change_group(document, document.active_group()->id, text, no_merge, [&](Group& group) {
    Group changed = asset.groups.front();
    changed.id = group.id;
    changed.object_id = group.object_id;
    changed.name = group.name;
    changed.parent = group.parent;
    group = std::move(changed);
  });
}

template <class T>
void append(Document& document, const std::vector<T>& added, std::vector<T> all,
            ObjectRef::Kind kind, const Movement& movement, const QString& text) {
  if (added.empty()) return;
  const std::size_t first = all.size();
  for (const T& object : added) {
    all.push_back(placed(object, movement));
    all.back().id = 0;  // of its own file
  }
  set_scene_part(document, std::move(all), text);
  document.set_object(ObjectRef{kind, first});
}

void add_camera_of(Document& document, const Scene& asset, const QString& name,
                   const Movement& movement, const QString& text) {
  const Scene& scene = document.scene();
  NamedCamera camera = camera_in_use(asset);
  camera.name = allowed_camera_name(scene, name);
  camera.id = 0;
  for (glm::dvec3* point : {&camera.camera.eye, &camera.camera.target}) {
    *point = movement.point(*point);
  }
  move_keys(camera.keys.eye, movement);
  move_keys(camera.keys.target, movement);
  CameraList list{camera_in_use(scene), scene.cameras};
  list.others.push_back(std::exchange(list.in_use, std::move(camera)));
  set_scene_part(document, std::move(list), text);
}

// Says why it cannot be added; empty: it can.
QString problem_of(const Document& document, const Scene& asset) {
  const Scene& scene = document.scene();
  const auto count_problem = [](const QString& problem, std::size_t count, std::size_t max_count) {
    return count > max_count ? problem.arg(max_count) : QString();
  };
  const QString problems =
      count_problem(Document::tr("The scene would have more than %1 lights."),
                    scene.lights.size() + asset.lights.size(), limits::lights) +
      count_problem(Document::tr("The scene would have more than %1 surfaces."),
                    scene.surfaces.size() + asset.surfaces.size(), limits::surfaces) +
      count_problem(Document::tr("The scene would have more than %1 groups."),
                    scene.groups.size() + (asset.medium.size() > 0 ? 1 : 0), limits::groups);
  if (!problems.isEmpty() || !is_camera_alone(asset)) return problems;
  return count_problem(Document::tr("The scene would have more than %1 cameras."),
                       scene.cameras.size() + 1, limits::cameras);
}

}  // namespace

bool is_camera_alone(const Scene& asset) {
  return asset.medium.size() == 0 && asset.lights.empty() && asset.surfaces.empty();
}

MeshBox box_of_asset(const Scene& asset) {
  std::optional<MeshBox> all;
  const auto add = [&all](const glm::dvec3& low, const glm::dvec3& high) {
    all = all ? MeshBox{glm::min(all->low, low), glm::max(all->high, high)} : MeshBox{low, high};
  };
  for (const Surface& surface : asset.surfaces) {
    const MeshBox box = world_box(surface);
    add(box.low, box.high);
  }
  for (std::size_t i = 0; i < asset.medium.size(); ++i) {
    const Gaussian gaussian = asset.medium.gaussian(i);
    add(gaussian.center - gaussian.radius, gaussian.center + gaussian.radius);
  }
  if (!all) {
    for (const Light& light : asset.lights) add(light.position, light.position);
  }
  if (!all) add(asset.camera.target, asset.camera.target);
  return *all;
}

void add_asset(Document& document, const Scene& asset, const QString& name,
               const ImportPlacement& placement, const QString& text) {
  if (const QString problem = problem_of(document, asset); !problem.isEmpty()) {
    Q_EMIT document.refused(problem);
    return;
  }
  if (!has_room(document, asset.medium.size(), 0)) return;
  const Movement movement = movement_of(placement);
  document.undo_stack().beginMacro(text);
  if (asset.medium.size() > 0) add_as_group(document, asset, name, placement, text);
  append(document, asset.lights, document.scene().lights, ObjectRef::Kind::light, movement, text);
  append(document, asset.surfaces, document.scene().surfaces, ObjectRef::Kind::surface, movement,
         text);
  if (is_camera_alone(asset)) add_camera_of(document, asset, name, movement, text);
  document.undo_stack().endMacro();
}

}  // namespace brume
