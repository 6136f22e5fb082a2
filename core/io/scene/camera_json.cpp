#include "core/io/scene/camera_json.h"

#include <algorithm>

#include "brume/limits.h"
#include "core/io/scene/fields_json.h"
#include "core/io/text_scanner.h"
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
  unknown_keys.add(camera.id, "keys",
                   read_keys_member(context, object, unknown_keys, [&](auto&& visit) {
                     visit_keyed(camera.camera, camera.keys, visit);
                   }));
  unknown_keys.add(camera.id, "", object.unknown_keys());
  return camera;
}

void add_values(Json& object, const NamedCamera& camera, const UnknownKeys& unknown_keys) {
  write_fields(object, camera.camera, camera.keys);
  add_keys(object, unknown_keys, unknown_keys.of(camera.id, "keys"),
           [&](auto&& visit) { visit_keyed(camera.camera, camera.keys, visit); });
  add_unknown_keys(object, unknown_keys.of(camera.id, ""));
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

}  // namespace brume
