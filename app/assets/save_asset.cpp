#include "app/assets/save_asset.h"

#include <set>

#include "app/commands/objects/edit_objects.h"
#include "app/document/document.h"
#include "app/tools/brushes/brush_library.h"
#include "app/tools/brushes/fog_brush_tool.h"
#include "app/tools/tool_box.h"
#include "brume/error.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/group_effects.h"

namespace brume {
namespace {

const FogBrushTool* brush_of(const ToolBox& tools) {
  return dynamic_cast<const FogBrushTool*>(&tools.tool());
}

// The group that all selected Gaussians are in; nullptr: there is none.
const Group* chosen_group(const Document& document, const Scene& scene) {
  std::set<GroupId> groups;
  for (const GaussianId id : document.selection()) {
    groups.insert(scene.medium.group(*scene.medium.index_of(id)));
  }
  return groups.size() == 1 ? find_group(scene.groups, *groups.begin()) : nullptr;
}

template <class T>
void change(T& value, Keys<T>& keys, const T& factor, const T& offset) {
  value = factor * value + offset;
  for (Key<T>& key : keys) {
    key.value = factor * key.value + offset;
    for (std::optional<T>* slope : {&key.in, &key.out}) {
      if (*slope) **slope *= factor;
    }
  }
}

// A group without a parent, which changes its Gaussians as the group and its parent do.
Group without_parent(Group group, const Scene& scene) {
  if (const Group* parent = find_group(scene.groups, group.parent)) {
    GroupKeys& keys = group.keys;
    change(group.density_factor, keys.density_factor, parent->density_factor, 0.0);
    change(group.density_offset, keys.density_offset, parent->density_factor,
           parent->density_offset);
    change(group.radius_factor, keys.radius_factor, parent->radius_factor, 0.0);
    change(group.radius_offset, keys.radius_offset, parent->radius_factor, parent->radius_offset);
    change(group.albedo_factor, keys.albedo_factor, parent->albedo_factor, glm::dvec3(0.0));
    change(group.albedo_offset, keys.albedo_offset, parent->albedo_factor, parent->albedo_offset);
  }
  group.parent = 0;
  return group;
}

Scene chosen_fog(const Document& document, const Scene& scene) {
  Scene chosen;
  const Group* group = chosen_group(document, scene);
  if (group) chosen.groups = {without_parent(*group, scene)};
  for (const GaussianId id : document.selection()) {
    Gaussian gaussian = scene.medium.gaussian(*scene.medium.index_of(id));
    if (!group) gaussian.group = 0;
    chosen.medium.append(gaussian);
  }
  chosen.optics = scene.optics;
  return chosen;
}

Scene chosen_scene(const Document& document, AssetKind kind) {
  const Scene scene = document.document_to_save().scene;
  Scene chosen;
  if (kind == AssetKind::fog) return chosen_fog(document, scene);
  if (kind == AssetKind::light) chosen.lights = {scene.lights.at(document.object()->index)};
  if (kind == AssetKind::surface) chosen.surfaces = {scene.surfaces.at(document.object()->index)};
  if (kind == AssetKind::camera) {
    chosen.camera = scene.camera;
    chosen.camera_keys = scene.camera_keys;
    chosen.camera_name = scene.camera_name;
    chosen.film = scene.film;
  }
  return chosen;
}

}  // namespace

std::optional<QString> chosen_name(const Document& document, const ToolBox& tools, AssetKind kind) {
  const Scene& scene = document.scene();
  const auto object_name = [&](ObjectRef::Kind wanted) -> std::optional<QString> {
    const auto& object = document.object();
    if (!object || object->kind != wanted) return std::nullopt;
    return object_title(scene, *object);
  };
  switch (kind) {
    case AssetKind::fog: {
      if (document.selection().empty()) return std::nullopt;
      const Group* group = chosen_group(document, scene);
      return group ? QString::fromStdString(group->name) : Document::tr("Fog");
    }
    case AssetKind::light:
      return object_name(ObjectRef::Kind::light);
    case AssetKind::surface:
      return object_name(ObjectRef::Kind::surface);
    case AssetKind::camera:
      return QString::fromStdString(scene.camera_name);
    case AssetKind::brush:
      if (!brush_of(tools)) return std::nullopt;
      return tools.entries()[tools.active()].title;
    case AssetKind::scene:
      break;
  }
  return std::nullopt;
}

void save_asset(const Document& document, const ToolBox& tools, AssetKind kind,
                const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);  // else writing says why
  if (kind != AssetKind::brush) return save_document({chosen_scene(document, kind), {}}, file);
  BrushPreset preset = brush_of(tools)->preset();
  preset.name = asset_name(file);
  BrushLibrary(file).replace(preset);
}

void use_brush(ToolBox& tools, const std::filesystem::path& file) {
  const std::vector<BrushPreset> presets = BrushLibrary(file).read();
  if (presets.empty()) throw InputError(file, "brushes", "there is none");
  tools.activate(presets.front().sprays ? "airbrush" : "paintbrush");
  dynamic_cast<FogBrushTool&>(tools.tool()).apply_preset(presets.front());
}

}  // namespace brume
