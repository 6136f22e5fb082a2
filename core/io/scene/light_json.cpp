#include "core/io/scene/light_json.h"

namespace brume {

Json light_to_json(const Light& light) {
  if (const auto& directional = light.directional) {
    return {{"type", "directional"},
            {"direction", to_json(directional->direction)},
            {"irradiance", to_json(light.intensity)},
            {"angular_diameter", directional->angular_diameter}};
  }
  Json json{{"type", light.spot ? "spot" : "point"},
            {"position", to_json(light.position)},
            {"intensity", to_json(light.intensity)}};
  if (light.spot) {
    json["direction"] = to_json(light.spot->direction);
    json["inner_angle"] = light.spot->inner_angle;
    json["outer_angle"] = light.spot->outer_angle;
  }
  return json;
}

}  // namespace brume
