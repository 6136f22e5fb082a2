#include "tools/make_scenes/sample_scene.h"

#include <charconv>
#include <cmath>
#include <functional>

#include "tools/make_scenes/generated_files.h"

namespace brume {
namespace {

std::string number(double value) {
  char text[32];
  const auto end =
      std::to_chars(text, text + sizeof text, rounded(value), std::chars_format::fixed).ptr;
  return {text, end};
}

template <typename... Parts>
std::string concat(const Parts&... parts) {
  std::string text;
  ((text += parts), ...);
  return text;
}

std::string triple(const glm::dvec3& v) {
  return concat("[", number(v.x), ", ", number(v.y), ", ", number(v.z), "]");
}

// A JSON array with one item a line.
template <typename Item>
std::string lines(const std::vector<Item>& items,
                  const std::function<std::string(const Item&)>& text_of) {
  std::string text = "[";
  for (const Item& item : items) {
    text += concat(text.size() == 1 ? "\n    " : ",\n    ", text_of(item));
  }
  return concat(text, items.empty() ? "]" : "\n  ]");
}

std::string optics_text(const GaussianOptics& optics) {
  std::string text;
  if (optics.albedo) text += concat(R"(, "albedo": )", triple(*optics.albedo));
  if (optics.emission != glm::dvec3(0.0)) {
    text += concat(R"(, "emission": )", triple(optics.emission));
  }
  return text;
}

std::string gaussian_text(const Gaussian& g) {
  return concat(R"({ "center": )", triple(g.center), R"(, "radius": )", number(g.radius),
                R"(, "density": )", number(g.density), optics_text(g.optics), " }");
}

std::string key_text(const SampleKey& key) {
  return concat(R"({ "time": )", number(key.time), R"(, "value": )", triple(key.direction), " }");
}

std::string cone_text(const SampleLight& light) {
  if (!(light.outer_angle > 0.0)) return "";
  std::string text =
      concat(R"(,
      "direction": )",
             triple(light.directions.at(0).direction), R"(, "inner_angle": )",
             number(light.inner_angle), R"(, "outer_angle": )", number(light.outer_angle));
  if (light.directions.size() < 2) return text;
  text += R"(, "keys": { "direction": [)";
  for (const SampleKey& key : light.directions) {
    text += concat(&key == &light.directions[0] ? "\n      " : ",\n      ", key_text(key));
  }
  return text + " ] }";
}

std::string profile_text(const SampleLight& light) {
  if (light.profile.empty()) return "";
  return concat(R"(,
      "profile": ")",
                light.profile, R"(", "profile_rotation": )", number(light.profile_rotation));
}

std::string light_text(const SampleLight& light) {
  if (light.is_directional) {
    return concat(R"({ "type": "directional", "direction": )",
                  triple(light.directions.at(0).direction), R"(, "irradiance": )",
                  triple(light.intensity), " }");
  }
  if (light.width > 0.0) {
    return concat(R"({ "type": "rectangle", "position": )", triple(light.position),
                  R"(, "direction": )", triple(light.directions.at(0).direction), R"(, "width": )",
                  number(light.width), R"(, "height": )", number(light.height), R"(, "radiance": )",
                  triple(light.intensity), R"(, "two_sided": true })");
  }
  return concat(R"({ "type": ")", light.outer_angle > 0.0 ? "spot" : "point", R"(", "position": )",
                triple(light.position), R"(, "intensity": )", triple(light.intensity),
                cone_text(light), profile_text(light), " }");
}

std::string highlight_text(const SampleSurface& s) {
  if (!(s.specular > 0.0)) return "";
  return concat(R"(, "specular": )", triple(glm::dvec3(s.specular)), R"(, "exponent": )",
                number(s.exponent));
}

std::string environment_text(const SampleScene& scene) {
  if (scene.environment.empty()) return "";
  std::string text = concat("  \"environment\": { \"file\": \"", scene.environment, "\"");
  if (scene.environment_intensity != 1.0) {
    text += concat(", \"intensity\": ", number(scene.environment_intensity));
  }
  return text + " },\n";
}

std::string transfer_text(const SampleSurface& s) {
  return s.transfer.empty() ? "" : concat(R"(, "transfer": ")", s.transfer, "\"");
}

std::string surface_text(const SampleSurface& s) {
  return concat(R"({ "mesh": ")", s.mesh, R"(", "translate": )", triple(s.translate),
                R"(, "scale": )", number(s.scale), ",\n      \"material\": { \"type\": \"",
                s.specular > 0.0 ? "phong" : "diffuse",
                "\", \"reflectance\": ", triple(s.reflectance), highlight_text(s), " }",
                transfer_text(s), " }");
}

std::string medium_text(const SampleScene& scene) {
  std::string text = concat(R"({ "density": )", number(scene.homogeneous_density));
  if (!scene.medium_file.empty()) text += concat(R"(, "file": ")", scene.medium_file, "\"");
  if (!scene.gaussians.empty()) {
    text += concat(R"(, "gaussians": )", lines<Gaussian>(scene.gaussians, gaussian_text));
  }
  if (scene.albedo != 1.0) {
    text += concat(R"(, "albedo": )", triple(glm::dvec3(scene.albedo)));
  }
  if (scene.anisotropy != 0.0) {
    text += concat(R"(, "anisotropy": )", number(scene.anisotropy));
  }
  return text + " }";
}

}  // namespace

SampleLight spot(const glm::dvec3& position, const glm::dvec3& direction,
                 const glm::dvec3& intensity, double inner, double outer) {
  return {position, intensity, inner, outer, {{0.0, direction}}};
}

double rounded(double value) {
  const double result = std::round(value * 1e4) / 1e4;
  return result == 0.0 ? 0.0 : result;  // no -0
}

void write_sample_scene(const std::filesystem::path& file, const SampleScene& scene) {
  const Camera& camera = scene.camera;
  write_bytes(file, concat("{\n  \"format\": \"brume-scene\", \"version\": 1,\n",
                           "  \"camera\": { \"eye\": ", triple(camera.eye), ", \"target\": ",
                           triple(camera.target), ",\n    \"up\": ", triple(camera.up),
                           ", \"vertical_fov\": ", number(camera.vertical_fov), " },\n",
                           "  \"film\": { \"width\": 800, \"height\": 600 },\n",
                           "  \"medium\": ", medium_text(scene), ",\n",
                           "  \"lights\": ", lines<SampleLight>(scene.lights, light_text), ",\n",
                           environment_text(scene), "  \"surfaces\": ",
                           lines<SampleSurface>(scene.surfaces, surface_text), "\n}\n"));
}

}  // namespace brume
