#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "brume/scene.h"
#include "core/scene/fields/emitter_fields.h"
#include "core/scene/fields/environment_fields.h"
#include "core/scene/fields/group_fields.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/fields/medium_fields.h"
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
    if (maybe()) fill(scene.optics.noise, scene.optics.noise.keys);
    for (int i = integer(0, 3); i > 0; --i) {
      Emitter& emitter = scene.emitters.emplace_back();
      fill(emitter, emitter.keys);
      // No more of them than a scene may have.
      emitter.rate = number(0.0, 1e4);
      emitter.lifetime = number(0.0, 9.0);
      emitter.keys.rate.clear();
      keys(emitter.keys.rate, 9.0);
      if (maybe()) emitter.name = "pot";
    }
    for (int i = integer(0, 5); i > 0; --i) {
      Light& light = scene.lights.emplace_back();
      light.kind = light_kind(static_cast<std::size_t>(integer(0, light_kinds.size() - 1)));
      fill(light, light.keys);
      if (auto* spot = light.as<light::Spot>(); spot && spot->inner_angle > spot->outer_angle) {
        std::swap(spot->inner_angle, spot->outer_angle);
      }
      if (maybe()) light.name = "key";
    }
    if (maybe()) {
      Environment& environment = scene.environment.emplace();
      fill(environment, environment.keys);
      if (maybe()) {
        fill(environment.sky.emplace(), environment.sky->keys);
      } else {
        environment.file = folder_ / "dawn.exr";
      }
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
      surface.holdout = maybe();
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
    if (maybe()) scene.output.denoise = Denoising::solved;
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
  // Any value of a domain, of the sizes that designers use.
  double within(const NumberDomain& domain, double) {
    return domain.nearest(
        number(std::max(domain.min_value, -1e6), std::min(domain.max_value, 1e6)));
  }
  bool within(const NumberDomain&, bool) { return maybe(); }
  std::int64_t within(const NumberDomain&, std::int64_t) { return integer(-1000, 1000); }
  template <int n>
  glm::vec<n, double> within(const NumberDomain& domain, glm::vec<n, double> value) {
    for (int k = 0; k < n; ++k) value[k] = within(domain, 0.0);
    return value;
  }
  template <class T>
  std::optional<T> within(const NumberDomain& domain, const std::optional<T>&) {
    return maybe() ? std::optional(within(domain, T{})) : std::nullopt;
  }
  // Every value that the tables know of an object, and keyframes of it.
  template <class Owner>
  void fill(Owner& owner, auto& all_keys) {
    visit_fields_of(owner, [this, &owner](const auto& field) {
      auto& value = field.of(owner);
      if (field.info.is_always_saved || maybe()) value = within(field.domain, value);
    });
    visit_keyed_fields(owner, all_keys, [this](const auto& field, auto& keys) {
      const double low = std::max(field.domain.min_value, 0.01);
      this->keys(keys, std::min(field.domain.max_value, low + 9.0), low);
    });
  }
  bool maybe() { return integer(0, 1) == 0; }
  glm::dvec3 point() { return {number(-1e6, 1e6), number(-1, 1), number(-1e-6, 1e-6)}; }
  double up_to(double max_value, double, double min_value = 0.01) {
    return number(min_value, max_value);
  }
  template <int n>
  glm::vec<n, double> up_to(double max_value, glm::vec<n, double> value, double min_value = 0.01) {
    for (int k = 0; k < n; ++k) value[k] = number(min_value, max_value);
    return value;
  }
  glm::dquat up_to(double max_value, const glm::dquat&, double = 0.0) {
    return glm::normalize(glm::dquat(number(0.1, max_value), number(-1, 1), number(-1, 1), 0.5));
  }
  void groups(std::vector<Group>& groups) {
    for (int i = integer(1, 4); i > 0; --i) {
      Group group{.id = static_cast<GroupId>(groups.size() + 1), .name = std::to_string(i)};
      if (!groups.empty() && maybe()) group.parent = 1;
      fill(group, group.keys);
      groups.push_back(group);
    }
  }
  template <class T>
  void keys(Keys<T>& keys, double max_value, double min_value = 0.01) {
    double time = number(-9, 9);
    for (int i = maybe() ? integer(0, 4) : 0; i > 0; --i, time += number(1e-3, 5)) {
      keys.push_back(
          {time, up_to(max_value, T{}, min_value), static_cast<Interpolation>(integer(0, 2))});
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
