#include "core/io/scene/light_json.h"

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

}  // namespace brume
