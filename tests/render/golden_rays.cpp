#include "tests/render/golden_rays.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/render/test_scenes.h"

namespace brume {
namespace {

using Json = nlohmann::json;

glm::dvec3 vec(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

GoldenRay golden_ray(const Json& json) {
  GoldenRay ray;
  json.at("name").get_to(ray.name);
  json.at("albedo").get_to(ray.albedo);
  Scene& scene = ray.scene;
  scene.film = {1, 1};
  scene.camera = {vec(json.at("eye")), vec(json.at("target")), {0, 1, 0}, 30.0};
  for (const Json& g : json.at("gaussians")) {
    scene.medium.append({vec(g.at("center")), g.at("radius"), g.at("density")});
  }
  for (const Json& light : json.at("lights")) {
    scene.lights.push_back({vec(light.at("position")), glm::dvec3(light.at("intensity")), {}});
  }
  json.at("anisotropy").get_to(scene.optics.anisotropy);
  if (const double radiance = json.at("environment"); radiance > 0.0) {
    scene.environment.emplace().map = constant_sky(static_cast<float>(radiance));
  }
  constexpr const char* orders[] = {"order_1", "order_2", "order_3_and_up"};
  for (std::size_t i = 0; i < 3; ++i) {
    json.at(orders[i]).get_to(ray.orders[i]);
    json.at("standard_error").at(orders[i]).get_to(ray.order_errors[i]);
    ray.radiance += ray.orders[i];
  }
  json.at("standard_error").at("all").get_to(ray.standard_error);
  return ray;
}

}  // namespace

Scene GoldenRay::scattering_scene() const {
  Scene result = scene;
  result.medium = Medium();
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    Gaussian gaussian = scene.medium.gaussian(i);
    gaussian.density *= albedo;
    result.medium.append(gaussian);
  }
  result.optics.albedo = glm::dvec3(albedo);
  return result;
}

std::vector<GoldenRay> golden_rays() {
  std::ifstream file(BRUME_MULTIPLE_SCATTERING);
  const Json golden = Json::parse(file);
  std::vector<GoldenRay> rays;
  for (const Json& json : golden.at("rays")) rays.push_back(golden_ray(json));
  return rays;
}

}  // namespace brume
