#include "core/io/scene/cameras_and_output_json.h"

#include <algorithm>
#include <string>

#include "brume/limits.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/fields_json.h"
#include "core/io/scene/scene_names.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/cameras.h"
#include "core/scene/fields/camera_fields.h"

namespace brume {
namespace {

NamedCamera read_camera(JsonContext& context, JsonObject& object,
                        std::optional<std::string> default_name, UnknownKeys& unknown_keys) {
  NamedCamera camera;
  camera.name = object.name(std::move(default_name));
  read_fields(object, camera.camera);
  if (const auto refused = refusal(camera.camera)) object.fail(refused->member, refused->message);
  read_rest(context, object, camera.id, unknown_keys,
            [&](auto&& visit) { visit_keyed(camera.camera, camera.keys, visit); });
  return camera;
}

void add_values(Json& object, const NamedCamera& camera, const UnknownKeys& unknown_keys) {
  write_fields(object, camera.camera, camera.keys);
  add_rest(object, camera.id, unknown_keys,
           [&](auto&& visit) { visit_keyed(camera.camera, camera.keys, visit); });
}

}  // namespace

void read_cameras(JsonContext& context, JsonObject& root, Scene& scene, UnknownKeys& unknown_keys) {
  if (auto in_use = root.find_object("camera")) {
    NamedCamera camera = read_camera(context, *in_use, default_camera_name, unknown_keys);
    scene.camera_name = std::move(camera.name);
    scene.camera = camera.camera;
    scene.camera_keys = std::move(camera.keys);
    scene.camera_id = camera.id;
  }
  const Json::array_t& others = root.array("cameras", limits::cameras);
  const JsonPath path = root.path_of("cameras");
  for (std::size_t i = 0; i < others.size(); ++i) {
    JsonObject object(context, others[i], path.element(i));
    NamedCamera camera = read_camera(context, object, {}, unknown_keys);
    if (camera.name == scene.camera_name ||
        std::ranges::find(scene.cameras, camera.name, &NamedCamera::name) != scene.cameras.end()) {
      object.fail("name", "found " + quoted_text(camera.name) +
                              " again; allowed: a name that no camera before it has");
    }
    scene.cameras.push_back(std::move(camera));
  }
}

Json camera_to_json(const Scene& scene, const UnknownKeys& unknown_keys) {
  Json object = Json::object();
  if (scene.camera_name != default_camera_name) object["name"] = scene.camera_name;
  add_values(object, camera_in_use(scene), unknown_keys);
  return object;
}

Json camera_to_json(const NamedCamera& camera, const UnknownKeys& unknown_keys) {
  Json object{{"name", camera.name}};
  add_values(object, camera, unknown_keys);
  return object;
}

namespace {

std::string allowed_layers() {
  std::string names;
  for (const LayerName& layer : layer_names) names += quoted_text(layer.name) + ", ";
  return names + "each once";
}

OutputLayers read_layers(JsonContext& context, JsonObject& object) {
  if (object.find("layers") == nullptr) return {};
  OutputLayers layers{false, false, false};
  const Json::array_t& names = object.array("layers", layer_names.size());
  const JsonPath path = object.path_of("layers");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto* found =
        std::ranges::find_if(layer_names, [&](const LayerName& it) { return names[i] == it.name; });
    if (found == layer_names.end() || layers.*found->layer) {
      context.fail(path.element(i),
                   "found " + quoted_json(names[i]) + "; allowed: " + allowed_layers());
    }
    layers.*found->layer = true;
  }
  return layers;
}

}  // namespace

Output read_output(JsonContext& context, JsonObject& object, const SceneReferences& references,
                   UnknownKeys& unknown_keys) {
  Output output;
  if (object.find("file") != nullptr) {
    const JsonPath place = object.path_of("file");
    output.file = references.resolve_output(context, place, object.text("file", {}));
    const std::string extension = lower_case_extension(output.file);
    if (extension != ".png" && extension != ".exr" && extension != ".mp4") {
      context.fail(place,
                   "found the extension " + quoted_text(extension) + "; allowed: .png, .exr, .mp4");
    }
  }
  if (object.find("paths") != nullptr) {
    output.paths = static_cast<int>(object.integer("paths", 1, limits::paths, 1));
  }
  output.denoise =
      static_cast<Denoising>(object.choice("denoise", scene_names::denoisings, std::size_t{0}));
  if (object.find("samples") != nullptr) {
    output.samples = static_cast<int>(object.integer("samples", 1, limits::samples, 1));
  }
  if (object.find("shutter") != nullptr) {
    const glm::dvec2 shutter = object.pair("shutter", domain::shutter, {});
    if (!(shutter.x < shutter.y)) {
      object.fail("shutter",
                  "found an end that is not after the begin; allowed: [open, close] "
                  "with open < close");
    }
    output.shutter = {shutter.x, shutter.y};
  }
  if (object.find("exposure") != nullptr) {
    output.exposure = object.number("exposure", domain::stops, {});
  }
  output.layers = read_layers(context, object);
  unknown_keys.add("output", object.unknown_keys());
  return output;
}

Json output_to_json(const Output& output, const UnknownKeys& unknown_keys,
                    const std::filesystem::path& directory) {
  Json object = Json::object();
  if (!output.file.empty()) object["file"] = SceneReferences::text_for(output.file, directory);
  if (output.paths) object["paths"] = *output.paths;
  if (output.denoise != Denoising::none) {
    object["denoise"] = scene_names::denoisings[static_cast<std::size_t>(output.denoise)];
  }
  if (output.samples) object["samples"] = *output.samples;
  if (output.shutter) object["shutter"] = Json{output.shutter->open, output.shutter->close};
  if (output.exposure) object["exposure"] = *output.exposure;
  if (output.layers != OutputLayers{}) {
    Json& names = object["layers"] = Json::array();
    for (const auto& [name, layer] : layer_names) {
      if (output.layers.*layer) names.push_back(name);
    }
  }
  add_unknown_keys(object, unknown_keys.of("output"));
  return object;
}

}  // namespace brume
