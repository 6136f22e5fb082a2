#include "tools/make_scenes/sample_scene.h"

#include <charconv>
#include <cmath>
#include <functional>

#include "tools/make_scenes/generated_files.h"

namespace brume {
namespace {

std::string number(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, rounded(value)).ptr;
  return {text, end};
}

std::string triple(const glm::dvec3& v) {
  return "[" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + "]";
}

// A JSON array with one item a line.
template <typename Item>
std::string lines(const std::vector<Item>& items,
                  const std::function<std::string(const Item&)>& text) {
  std::string result = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    result += (i == 0 ? "\n    " : ",\n    ") + text(items[i]);
  }
  return result + (items.empty() ? "]" : "\n  ]");
}

std::string gaussian_text(const Gaussian& g) {
  return R"({ "center": )" + triple(g.center) + R"(, "radius": )" + number(g.radius) +
         R"(, "density": )" + number(g.density) + " }";
}

std::string light_text(const SampleLight& light) {
  return R"({ "type": "point", "position": )" + triple(light.position) + R"(, "intensity": )" +
         triple(light.intensity) + " }";
}

std::string surface_text(const SampleSurface& s) {
  const std::string rotate = "[" + number(s.rotate.w) + ", " + number(s.rotate.x) + ", " +
                             number(s.rotate.y) + ", " + number(s.rotate.z) + "]";
  return R"({ "mesh": ")" + s.mesh + R"(", "translate": )" + triple(s.translate) +
         R"(, "rotate": )" + rotate + R"(, "scale": )" + number(s.scale) +
         ",\n      \"material\": { \"type\": \"diffuse\", \"reflectance\": " +
         triple(s.reflectance) + " } }";
}

std::string medium_text(const SampleScene& scene) {
  std::string text = R"({ "density": )" + number(scene.homogeneous_density);
  if (!scene.medium_file.empty()) text += R"(, "file": ")" + scene.medium_file + "\"";
  if (!scene.gaussians.empty()) {
    text += R"(, "gaussians": )" + lines<Gaussian>(scene.gaussians, gaussian_text);
  }
  return text + " }";
}

}  // namespace

double rounded(double value) {
  const double result = std::round(value * 1e4) / 1e4;
  return result == 0.0 ? 0.0 : result;  // no -0
}

void write_sample_scene(const std::filesystem::path& file, const SampleScene& scene) {
  const Camera& camera = scene.camera;
  std::string text = "{\n  \"format\": \"brume-scene\", \"version\": 1,\n";
  text += "  \"camera\": { \"eye\": " + triple(camera.eye) +
          ", \"target\": " + triple(camera.target) + ", \"up\": " + triple(camera.up) +
          ", \"vertical_fov\": " + number(camera.vertical_fov) + " },\n";
  text += "  \"film\": { \"width\": 800, \"height\": 600 },\n";
  text += "  \"medium\": " + medium_text(scene) + ",\n";
  text += "  \"lights\": " + lines<SampleLight>(scene.lights, light_text) + ",\n";
  text += "  \"surfaces\": " + lines<SampleSurface>(scene.surfaces, surface_text) + "\n}\n";
  write_bytes(file, text);
}

}  // namespace brume
