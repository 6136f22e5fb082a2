#include "core/io/scene/light_json.h"

#include <glm/vec3.hpp>
#include <utility>

#include "core/number_domain.h"
#include "core/scene/animation/animation.h"

namespace brume {
namespace {

Json area_to_json(const Light& light) {
  const AreaLight& area = *light.area;
  Json json{{"position", to_json(light.position)}, {"radiance", to_json(light.intensity)}};
  if (area.shape != AreaLight::Shape::sphere) json["direction"] = to_json(area.direction);
  if (area.shape == AreaLight::Shape::rectangle) {
    json["type"] = "rectangle";
    json["up"] = to_json(area.up);
    json["width"] = area.width;
    json["height"] = area.height;
  } else {
    json["type"] = area.shape == AreaLight::Shape::disk ? "disk" : "sphere";
    json["radius"] = area.radius;
  }
  json["two_sided"] = area.two_sided;
  return json;
}

// Values with keyframes count for nothing: they are those of the moment at which a scene was
// saved.
void check_direction(const JsonObject& object, const Light& light, const glm::dvec3& direction) {
  if (light.keys.direction.empty() && direction == glm::dvec3(0.0)) {
    object.fail("direction", "found a vector of length 0; allowed: any other");
  }
}

void check_cone(const JsonObject& object, const Light& light) {
  const SpotCone& cone = *light.spot;
  check_direction(object, light, cone.direction);
  const bool is_keyed = !light.keys.inner_angle.empty() || !light.keys.outer_angle.empty();
  if (!is_keyed && !(cone.outer_angle > 0.0)) {
    object.fail("outer_angle", "found 0; allowed: above 0 degrees");
  }
  if (!is_keyed && !(cone.inner_angle <= cone.outer_angle)) {
    object.fail("inner_angle", "found " + quoted_text(cone.inner_angle) +
                                   "; allowed: at most outer_angle, which is " +
                                   quoted_text(cone.outer_angle));
  }
}

void read_profile(JsonContext& context, JsonObject& object, SceneReferences& references,
                  SceneBudget& budget, Light& light) {
  if (object.find("profile") == nullptr) return;
  const JsonPath path = object.path_of("profile");
  LightProfile profile;
  profile.file = references.resolve(context, path, object.text("profile", {}));
  profile.content = references.profile(context, path, profile.file);
  budget.reserve(path, *profile.content);
  profile.rotation = object.number("profile_rotation", domain::degrees, profile.rotation);
  light.profile = std::move(profile);
}

Directional read_directional(JsonObject& object) {
  Directional light;
  light.direction = object.vector("direction", domain::coordinate, {});
  light.angular_diameter =
      object.number("angular_diameter", domain::angular_diameter, light.angular_diameter);
  return light;
}

AreaLight read_area(JsonObject& object, AreaLight::Shape shape) {
  AreaLight area;
  area.shape = shape;
  if (shape != AreaLight::Shape::sphere) {
    area.direction = object.vector("direction", domain::coordinate, {});
  }
  if (shape == AreaLight::Shape::rectangle) {
    area.up = object.vector("up", domain::coordinate, area.up);
    area.width = object.number("width", domain::length, {});
    area.height = object.number("height", domain::length, {});
  } else {
    area.radius = object.number("radius", domain::length, {});
  }
  area.two_sided = object.boolean("two_sided", area.two_sided);
  return area;
}

SpotCone read_cone(JsonObject& object) {
  SpotCone cone;
  cone.direction = object.vector("direction", domain::coordinate, {});
  cone.inner_angle = object.number("inner_angle", domain::cone_angle, cone.inner_angle);
  cone.outer_angle = object.number("outer_angle", domain::cone_angle, cone.outer_angle);
  return cone;
}

}  // namespace

Json light_to_json(const Light& light, const std::string& profile) {
  if (const auto& directional = light.directional) {
    return {{"type", "directional"},
            {"direction", to_json(directional->direction)},
            {"irradiance", to_json(light.intensity)},
            {"angular_diameter", directional->angular_diameter}};
  }
  if (light.area) return area_to_json(light);
  Json json{{"type", light.spot ? "spot" : "point"},
            {"position", to_json(light.position)},
            {"intensity", to_json(light.intensity)}};
  if (light.spot) {
    json["direction"] = to_json(light.spot->direction);
    json["inner_angle"] = light.spot->inner_angle;
    json["outer_angle"] = light.spot->outer_angle;
  }
  if (light.profile.content) {
    json["profile"] = profile;
    json["profile_rotation"] = light.profile.rotation;
  }
  return json;
}

Light read_light(JsonContext& context, const Json& value, const JsonPath& path,
                 SceneReferences& references, SceneBudget& budget, UnknownKeys& unknown_keys) {
  JsonObject object(context, value, path);
  const std::size_t type =
      object.choice("type", {"point", "spot", "directional", "rectangle", "disk", "sphere"}, {});
  Light light;
  if (type == 2) {
    light.intensity = object.vector("irradiance", domain::intensity, {});
    light.directional = read_directional(object);
  } else {
    light.position = object.vector("position", domain::coordinate, {});
    if (type >= 3) {
      light.intensity = object.vector("radiance", domain::intensity, {});
      light.area = read_area(object, static_cast<AreaLight::Shape>(type - 3));
    } else {
      light.intensity = object.vector("intensity", domain::intensity, light.intensity);
    }
  }
  if (type == 1) light.spot = read_cone(object);
  if (type <= 1) read_profile(context, object, references, budget, light);
  light.name = object.name("");
  light.on = object.boolean("on", light.on);
  light.locked = object.boolean("locked", light.locked);
  unknown_keys.add(light.id, "keys",
                   read_keys_member(context, object, unknown_keys,
                                    [&](auto&& visit) { visit_keyed_light(light, visit); }));
  if (light.spot) check_cone(object, light);
  if (light.directional) check_direction(object, light, light.directional->direction);
  if (light.area) check_direction(object, light, light.area->direction);
  unknown_keys.add(light.id, "", object.unknown_keys());
  return light;
}

}  // namespace brume
