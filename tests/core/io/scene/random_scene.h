#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "brume/scene.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {

// Scenes with a little of everything. Their meshes and maps are named in the folder, not loaded.
class RandomScene {
 public:
  RandomScene(unsigned seed, const TemporaryFolder& folder) : random_(seed), folder_(folder) {}

  Scene make() {
    Scene scene;
    scene.camera = {point(), point(), point(), number(1e-3, 179.0)};
    scene.film = {integer(1, 16384), integer(1, 16384)};
    scene.medium.set_homogeneous_density(maybe() ? number(0.0, 10.0) : 0.0);
    if (maybe()) groups(scene.groups);
    const auto count = static_cast<int>(scene.groups.size());
    for (int i = integer(0, 30); i > 0; --i) {
      GaussianOptics optics;
      if (maybe()) optics.albedo = glm::dvec3(1.0, number(0.01, 1), number(0.01, 1));
      if (maybe()) optics.emission = {number(0, 9), 0.0, number(0, 1e9)};
      scene.medium.append({point(), std::exp(number(-20, 20)), std::exp(number(-30, 20)), optics,
                           static_cast<GroupId>(integer(0, count))});
    }
    if (maybe()) scene.optics.albedo = {number(0.01, 1), 1.0, number(0.01, 1)};
    if (maybe()) scene.optics.anisotropy = number(-0.95, 0.95);
    if (maybe()) scene.optics.extent = std::exp(number(-20, 20));
    if (maybe()) {
      scene.optics.noise = {number(0, 1), number(0, 9), point(), integer(-1000, 1000)};
    }
    for (int i = integer(0, 3); i > 0; --i) {
      scene.emitters.push_back({.position = point(),
                                .rate = number(0, 1e4),
                                .lifetime = number(0, 9),
                                .velocity = point(),
                                .spread = number(0, 9),
                                .acceleration = point(),
                                .radius = {number(0.1, 1), number(0.1, 9)},
                                .density = {number(0, 1), number(0, 9)},
                                .seed = integer(-1000, 1000)});
      scene.emitters.back().visible = maybe();
      scene.emitters.back().locked = maybe();
      if (maybe()) scene.emitters.back().name = "pot";
      if (maybe()) scene.emitters.back().optics.albedo = glm::dvec3(number(0.01, 1));
      if (maybe()) scene.emitters.back().optics.emission = {number(0, 9), 0.0, number(0, 1e9)};
      if (maybe()) scene.emitters.back().emission_at_death = glm::dvec3(number(0, 9));
    }
    for (int i = integer(0, 5); i > 0; --i) {
      scene.lights.push_back(
          {.position = point(), .intensity = {number(0, 90), 0.0, number(0, 1e9)}, .on = maybe()});
      scene.lights.back().locked = maybe();
      if (maybe()) scene.lights.back().name = "key";
      if (maybe()) {
        scene.lights.back().kind = light::Spot{point() + 1.0, number(0, 40), number(41, 180)};
      } else if (maybe()) {
        scene.lights.back().position = {};
        scene.lights.back().kind = light::Directional{point() + 1.0, number(0, 89)};
      } else if (maybe()) {
        scene.lights.back().kind = area_light();
      }
    }
    if (maybe())
      scene.environment = {folder_ / "dawn.exr", nullptr, number(0, 3), number(-720, 720)};
    if (scene.environment && maybe()) {
      scene.environment->file.clear();
      scene.environment->sky =
          Sky{number(-90, 90), number(-720, 720), number(1, 10), {number(0, 1), 0.0, 1.0}, maybe()};
    }
    for (int i = integer(0, 3); i > 0; --i) {
      Surface surface;
      if (maybe()) {
        surface.primitive = Primitive{static_cast<Primitive::Shape>(integer(0, 3)),
                                      {number(0.1, 9), number(0.1, 9), number(0.1, 9)}};
      } else {
        surface.mesh_file = folder_ / "bunny.obj";
      }
      if (maybe()) surface.name = "wall \u00e9 \"2\"";
      surface.locked = maybe();
      surface.visible = maybe();
      surface.translate = point();
      surface.rotate =
          glm::normalize(glm::dquat(number(0.1, 1), number(-1, 1), number(-1, 1), number(-1, 1)));
      surface.scale = std::exp(number(-5, 5));
      surface.material.type = maybe() ? Material::Type::phong : Material::Type::diffuse;
      surface.material.reflectance = {number(0, 1), number(0, 1), 1.0};
      if (surface.material.type == Material::Type::phong) {
        surface.material.specular = {0.0, number(0, 1), number(0, 1)};
        surface.material.exponent = number(0, 1000);
      }
      keys(surface.keys.translate, 1e6);
      keys(surface.keys.rotate, 1.0);
      keys(surface.keys.scale, 9.0);
      keys(surface.keys.reflectance, 1.0);
      if (surface.material.type == Material::Type::phong) keys(surface.keys.specular, 1.0);
      surface.transfer = static_cast<Surface::Transfer>(integer(0, 2));
      scene.surfaces.push_back(surface);
    }
    keys(scene.camera_keys.eye, 1e6);
    if (maybe()) {
      scene.camera.vertical_fov = Camera().vertical_fov;
      scene.camera.height = number(1e-3, 1e3);
      keys(scene.camera_keys.height, 9.0);
    } else {
      keys(scene.camera_keys.vertical_fov, 179.0);
      scene.camera.aperture = maybe() ? number(0, 2) : 0.0;
      keys(scene.camera_keys.aperture, 1.0);
    }
    if (maybe()) scene.camera.focus_distance = number(0.1, 9);
    if (maybe()) scene.camera.roll = number(-180, 180);
    keys(scene.camera_keys.roll, 180.0);
    if (scene.camera.focus_distance) keys(scene.camera_keys.focus_distance, 9.0);
    keys(scene.density_keys, 9.0);
    keys(scene.optics.keys.albedo, 1.0);
    if (scene.optics.extent) keys(scene.optics.keys.extent, 1.0);
    keys(scene.optics.noise.keys.amplitude, 2.0);
    keys(scene.optics.noise.keys.frequency, 9.0);
    keys(scene.optics.noise.keys.velocity, 9.0);
    for (Emitter& emitter : scene.emitters) {
      keys(emitter.keys.position, 1e6);
      keys(emitter.keys.rate, 9.0);
      keys(emitter.keys.radius, 9.0);
      keys(emitter.keys.density, 9.0);
      if (emitter.optics.albedo) keys(emitter.keys.albedo, 1.0);
      keys(emitter.keys.emission, 1e9);
      keys(emitter.keys.emission_at_death, 1e9);
    }
    for (Light& light : scene.lights) {
      keys(light.keys.intensity, 1e9);
      const bool is_sun = light.as<light::Directional>();
      const bool is_spot = light.as<light::Spot>();
      keys(is_sun ? light.keys.direction : light.keys.position, 1e6);
      if (is_sun) keys(light.keys.angular_diameter, 80.0);
      if (is_spot) keys(light.keys.direction, 1e6);
      if (light.as<light::Sphere>()) keys(light.keys.radius, 9.0);
      if (is_spot) keys(light.keys.outer_angle, 180.0);
    }
    if (scene.environment) keys(scene.environment->keys.rotation, 720.0);
    if (scene.environment && scene.environment->sky) {
      keys(scene.environment->sky->keys.elevation, 90.0);
      keys(scene.environment->sky->keys.azimuth, 720.0);
      keys(scene.environment->sky->keys.ground_albedo, 1.0);
    }
    if (maybe()) scene.playback = Playback{integer(0, 9), integer(9, 99), maybe()};
    if (scene.playback && maybe()) scene.playback->frames_per_second = integer(1, 1000);
    if (maybe()) scene.camera_name = "Main";
    for (int i = integer(0, 3); i > 0; --i) {
      NamedCamera camera;
      camera.name = "Camera " + std::to_string(i);
      camera.camera.eye = point();
      camera.camera.target = camera.camera.eye + glm::dvec3(1.0, 2.0, 3.0);
      keys(camera.keys.target, 1e6);
      scene.cameras.push_back(camera);
    }
    if (maybe()) scene.output.file = folder_ / (maybe() ? "film.mp4" : "renders/a.exr");
    if (maybe()) scene.output.paths = integer(1, 999);
    if (maybe()) scene.output.exposure = number(-9, 9);
    for (const LayerName& name : layer_names) scene.output.layers.*name.layer = maybe();
    return scene;
  }

 private:
  double number(double min_value, double max_value) {
    return std::uniform_real_distribution<double>(min_value, max_value)(random_);
  }
  int integer(int min_value, int max_value) {
    return std::uniform_int_distribution<int>(min_value, max_value)(random_);
  }
  Light::Kind area_light() {
    switch (integer(0, 2)) {
      case 0:
        return light::Rectangle{point() + 1.0, point(), number(1e-6, 9), number(1e-6, 1e6),
                                maybe()};
      case 1:
        return light::Disk{point() + 1.0, number(1e-6, 1e6), maybe()};
      default:
        return light::Sphere{number(1e-6, 1e6), maybe()};
    }
  }
  bool maybe() { return integer(0, 1) == 0; }
  glm::dvec3 point() { return {number(-1e6, 1e6), number(-1, 1), number(-1e-6, 1e-6)}; }
  double up_to(double max_value, double) { return number(0.01, max_value); }
  glm::dvec2 up_to(double max_value, const glm::dvec2&) {
    return {number(0.01, max_value), number(0.01, max_value)};
  }
  glm::dvec3 up_to(double max_value, const glm::dvec3&) {
    return {number(0.01, max_value), number(0.01, max_value), number(0.01, max_value)};
  }
  glm::dquat up_to(double max_value, const glm::dquat&) {
    return glm::normalize(glm::dquat(number(0.1, max_value), number(-1, 1), number(-1, 1), 0.5));
  }
  void groups(std::vector<Group>& groups) {
    for (int i = integer(1, 4); i > 0; --i) {
      Group group{.id = static_cast<GroupId>(groups.size() + 1), .name = std::to_string(i)};
      if (!groups.empty() && maybe()) group.parent = 1;
      group.color = {number(0, 1), number(0, 1), 1.0};
      group.visible = maybe();
      group.locked = maybe();
      if (maybe()) group.density_factor = number(0, 9);
      if (maybe()) group.density_offset = number(-9, 9);
      if (maybe()) group.radius_factor = number(0.1, 9);
      if (maybe()) group.radius_offset = number(-9, 9);
      if (maybe()) group.albedo_factor = {number(0, 9), 1.0, number(0, 9)};
      if (maybe()) group.albedo_offset = {number(-1, 1), 0.0, number(-1, 1)};
      keys(group.keys.density_factor, 9.0);
      keys(group.keys.radius_offset, 9.0);
      keys(group.keys.albedo_factor, 9.0);
      groups.push_back(group);
    }
  }
  template <class T>
  void keys(Keys<T>& keys, double max_value) {
    double time = number(-9, 9);
    for (int i = maybe() ? integer(0, 4) : 0; i > 0; --i, time += number(1e-3, 5)) {
      keys.push_back({time, up_to(max_value, T{}), static_cast<Interpolation>(integer(0, 2))});
      if constexpr (std::is_same_v<T, glm::dquat>) continue;
      if (maybe()) keys.back().in = up_to(1e30, T{});
      if (maybe()) keys.back().out = -up_to(9.0, T{});
      keys.back().aligned = maybe();
    }
  }

  std::mt19937 random_;
  const TemporaryFolder& folder_;
};

}  // namespace brume
