#include "core/io/scene/light_json.h"

#include <tuple>

#include "core/io/scene/fields_json.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/light_rules.h"

namespace brume {
namespace {

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const LightKindInfo& info : light_kinds) names.emplace_back(info.name);
  return names;
}

void read_profile(JsonContext& context, JsonObject& object, SceneReferences& references,
                  SceneBudget& budget, LightProfile& profile) {
  if (object.find("profile") == nullptr) return;
  const JsonPath path = object.path_of("profile");
  profile.file = references.resolve(context, path, object.text("profile", {}));
  profile.content = references.profile(context, path, profile.file);
  budget.reserve(path, *profile.content);
}

void read_light_texture(JsonContext& context, JsonObject& object, SceneReferences& references,
                        SceneBudget& budget, UnknownKeys& unknown_keys, Light& light) {
  auto* spot = light.as<light::Spot>();
  auto entry = spot ? object.find_object("texture") : std::nullopt;
  if (!entry) return;
  const JsonPath path = entry->path_of("file");
  std::tie(spot->texture.file, spot->texture.content) =
      references.texture(context, path, entry->text("file", {}), true);
  if (spot->texture.content) budget.reserve(path, *spot->texture.content);
  unknown_keys.add(light.id, "texture", entry->unknown_keys());
}

}  // namespace

Json light_to_json(const Light& light, const FileText& text_of) {
  Json json{{"type", kind_info(light).name}};
  if (const LightProfile* profile = profile_of(light)) json["profile"] = text_of(profile->file);
  if (const LightTexture* texture = texture_of(light)) {
    json["texture"] = Json{{"file", text_of(texture->file)}};
  }
  write_fields(json, light, light.keys);
  return json;
}

Light read_light(JsonContext& context, JsonObject& object, SceneReferences& references,
                 SceneBudget& budget, UnknownKeys& unknown_keys) {
  Light light{.kind = light_kind(object.choice("type", kind_names(), {}))};
  if (LightProfile* profile = profile_member(light)) {
    read_profile(context, object, references, budget, *profile);
  }
  read_light_texture(context, object, references, budget, unknown_keys, light);
  read_fields(object, light);
  light.name = object.name("");
  read_rest(context, object, light.id, unknown_keys,
            [&](auto&& visit) { visit_keyed(light, visit); });
  if (const auto refused = refusal(light)) object.fail(refused->member, refused->message);
  return light;
}

}  // namespace brume
