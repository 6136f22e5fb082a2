#include "app/assets/save_asset.h"

#include <set>

#include "app/commands/edit_objects.h"
#include "app/document/document.h"
#include "app/tools/brush_library.h"
#include "app/tools/fog_brush_tool.h"
#include "app/tools/tool_box.h"
#include "brume/error.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/group_effects.h"

namespace brume {
namespace {

const FogBrushTool* brush_of(const ToolBox& tools) {
  return dynamic_cast<const FogBrushTool*>(&tools.tool());
}

// With the group that all of them are in, if there is one.
std::optional<ChosenAsset> chosen_fog(const Document& document, const Scene& scene) {
  if (document.selection().empty()) return std::nullopt;
  std::set<GroupId> groups;
  for (const GaussianId id : document.selection()) {
    groups.insert(scene.medium.group(*scene.medium.index_of(id)));
  }
  const Group* group = groups.size() == 1 ? find_group(scene.groups, *groups.begin()) : nullptr;
  ChosenAsset chosen{group ? QString::fromStdString(group->name) : Document::tr("Fog"), {}};
  if (group) {
    chosen.scene.groups = {*group};
    chosen.scene.groups.front().parent = 0;
  }
  for (const GaussianId id : document.selection()) {
    Gaussian gaussian = scene.medium.gaussian(*scene.medium.index_of(id));
    if (!group) gaussian.group = 0;
    chosen.scene.medium.append(gaussian);
  }
  chosen.scene.optics = scene.optics;
  return chosen;
}

std::optional<ChosenAsset> chosen_object(const Document& document, const Scene& scene,
                                         ObjectRef::Kind kind) {
  const auto& object = document.object();
  if (!object || object->kind != kind) return std::nullopt;
  ChosenAsset chosen{object_title(scene, *object), {}};
  if (kind == ObjectRef::Kind::light) {
    chosen.scene.lights = {scene.lights.at(object->index)};
  } else {
    chosen.scene.surfaces = {scene.surfaces.at(object->index)};
  }
  return chosen;
}

}  // namespace

std::optional<ChosenAsset> chosen_asset(const Document& document, const ToolBox& tools,
                                        AssetKind kind) {
  const Scene scene = document.document_to_save().scene;
  switch (kind) {
    case AssetKind::fog:
      return chosen_fog(document, scene);
    case AssetKind::light:
      return chosen_object(document, scene, ObjectRef::Kind::light);
    case AssetKind::surface:
      return chosen_object(document, scene, ObjectRef::Kind::surface);
    case AssetKind::camera: {
      ChosenAsset chosen{QString::fromStdString(scene.camera_name), {}};
      chosen.scene.camera = scene.camera;
      chosen.scene.camera_keys = scene.camera_keys;
      chosen.scene.camera_name = scene.camera_name;
      chosen.scene.film = scene.film;
      return chosen;
    }
    case AssetKind::brush:
      if (!brush_of(tools)) return std::nullopt;
      return ChosenAsset{tools.entries()[tools.active()].title, {}};
    case AssetKind::scene:
      break;
  }
  return std::nullopt;
}

void save_asset(const ChosenAsset& asset, const ToolBox& tools, AssetKind kind,
                const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);  // else writing says why
  if (kind != AssetKind::brush) return save_document({asset.scene, {}}, file);
  BrushPreset preset = brush_of(tools)->preset();
  preset.name = asset_name(file);
  const BrushLibrary library(file);
  for (const BrushPreset& previous : library.read()) library.remove(previous);
  library.add(preset);
}

void use_brush(ToolBox& tools, const std::filesystem::path& file) {
  const std::vector<BrushPreset> presets = BrushLibrary(file).read();
  if (presets.empty()) throw InputError(file, "brushes", "there is none");
  tools.activate(presets.front().sprays ? "airbrush" : "paintbrush");
  dynamic_cast<FogBrushTool&>(tools.tool()).apply_preset(presets.front());
}

}  // namespace brume
