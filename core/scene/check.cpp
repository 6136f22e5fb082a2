#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "brume/error.h"
#include "brume/limits.h"
#include "brume/scene.h"
#include "core/number_domain.h"
#include "core/scene/animation.h"

namespace brume {
namespace {

void check_number(const std::string& place, double value, const NumberDomain& domain) {
  if (!domain.contains(value)) throw DomainError(place, domain.refusal(value));
}

void check_value(const std::string& place, double value, const NumberDomain& domain) {
  check_number(place, value, domain);
}

template <int n>
void check_value(const std::string& place, const glm::vec<n, double>& value,
                 const NumberDomain& domain) {
  for (int k = 0; k < n; ++k) {
    check_number(place + "[" + std::to_string(k) + "]", value[k], domain);
  }
}

void check_value(const std::string& place, const glm::dquat& value, const NumberDomain&) {
  // NaN, too, is no unit.
  if (!(std::abs(glm::length(value) - 1.0) < 1e-6)) {
    throw DomainError(place, "allowed: a unit quaternion");
  }
}

// Values with keyframes, and their keys.
auto in(const std::string& object) {
  return [prefix = object.empty() ? object : object + "."](
             const char* name, const auto& value, const auto& keys, const NumberDomain& domain) {
    const std::string place = prefix + name;
    check_value(place, value, domain);
    double last = -limits::coordinate;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::string at = prefix + "keys." + name + "[" + std::to_string(i) + "]";
      check_number(at + ".time", keys[i].time, domain::seconds);
      if (i > 0 && !(keys[i].time - last >= min_key_distance)) {
        throw DomainError(at + ".time", "allowed: later than the key before it");
      }
      last = keys[i].time;
      check_value(at + ".value", keys[i].value, domain);
    }
  };
}

std::string element(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

void check_count(const char* list, std::size_t count, std::size_t allowed) {
  if (count <= allowed) return;
  throw DomainError(list, "has " + std::to_string(count) + " elements; allowed: at most " +
                              std::to_string(allowed));
}

void check_direction(const std::string& place, const glm::dvec3& direction) {
  if (direction == glm::dvec3(0.0)) {
    throw DomainError(place, "found a vector of length 0; allowed: any other");
  }
}

void check_optics(const std::string& place, const GaussianOptics& optics) {
  if (optics.albedo) check_value(place + ".albedo", *optics.albedo, domain::albedo);
  check_value(place + ".emission", optics.emission, domain::intensity);
}

void check_camera(const std::string& place, const Camera& camera, const CameraKeys& keys) {
  visit_keyed_camera(camera, keys, in(place));
  check_value(place + ".up", camera.up, domain::coordinate);
  check_direction(place + ".up", camera.up);
  if (camera.eye == camera.target && keys.eye.empty() && keys.target.empty()) {
    throw DomainError(place + ".target", "is where the eye is; allowed: any other point");
  }
}

void check_light(const std::string& place, const Light& light) {
  if (static_cast<int>(light.spot.has_value()) + static_cast<int>(light.directional.has_value()) +
          static_cast<int>(light.area.has_value()) >
      1) {
    throw DomainError(place, "allowed: at most one of spot, directional and area");
  }
  visit_keyed_light(light, in(place));
  const LightKeys& keys = light.keys;
  if (light.spot) {
    check_direction(place + ".direction", light.spot->direction);
    if (!(light.spot->inner_angle < light.spot->outer_angle) && keys.inner_angle.empty() &&
        keys.outer_angle.empty()) {
      throw DomainError(place + ".inner_angle", "found " + quoted_text(light.spot->inner_angle) +
                                                    "; allowed: less than outer_angle, which is " +
                                                    quoted_text(light.spot->outer_angle));
    }
  }
  if (light.directional) check_direction(place + ".direction", light.directional->direction);
  if (light.area) check_direction(place + ".direction", light.area->direction);
}

void check_surface(const std::string& place, const Surface& surface) {
  visit_keyed_surface(surface, in(place));
  if (!surface.mesh) throw DomainError(place + ".mesh", "there is none");
  const Material& material = surface.material;
  if (material.type == Material::Type::measured && !material.measured) {
    throw DomainError(place + ".material.measured", "there is none");
  }
  if (material.type == Material::Type::metallic_roughness) {
    const MetallicRoughness& values = material.metallic_roughness;
    const std::string at = place + ".material.";
    check_value(at + "base_color", values.base_color, domain::unit);
    check_value(at + "metallic", values.metallic, domain::unit);
    check_value(at + "roughness", values.roughness, domain::unit);
    check_value(at + "emissive", values.emissive, domain::intensity);
    check_value(at + "normal_scale", values.normal_scale, domain::normal_scale);
  }
}

void check_groups(const Scene& scene) {
  std::set<GroupId> known;
  for (std::size_t i = 0; i < scene.groups.size(); ++i) {
    const Group& group = scene.groups[i];
    const std::string place = element("groups", i);
    if (group.id == 0 || !known.insert(group.id).second) {
      throw DomainError(place + ".id", "allowed: above 0, and of no other group");
    }
    visit_keyed_group(group, in(place));
  }
  for (std::size_t i = 0; i < scene.groups.size(); ++i) {
    const Group& group = scene.groups[i];
    if (group.parent == 0) continue;
    const auto parent = std::ranges::find(scene.groups, group.parent, &Group::id);
    if (parent == scene.groups.end() || parent->parent != 0) {
      throw DomainError(element("groups", i) + ".parent",
                        "allowed: the id of a group without a parent, or 0");
    }
  }
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const GroupId group = scene.medium.group(i);
    if (group != 0 && !known.contains(group)) {
      throw DomainError(element("medium.gaussians", i) + ".group", "there is no such group");
    }
  }
}

}  // namespace

void check(const Medium& medium) {
  check_count("medium.gaussians", medium.size(), limits::gaussians);
  check_number("medium.density", medium.homogeneous_density(), domain::density);
  const auto refuse = [](std::size_t i, const char* name, auto value, const NumberDomain& domain) {
    check_value(element("medium.gaussians", i) + name, value, domain);
  };
  for (std::size_t i = 0; i < medium.size(); ++i) {
    const glm::dvec3& center = medium.centers()[i];
    // Names are made for what is refused only.
    if (!domain::coordinate.contains(center.x) || !domain::coordinate.contains(center.y) ||
        !domain::coordinate.contains(center.z)) {
      refuse(i, ".center", center, domain::coordinate);
    }
    if (!domain::length.contains(medium.radii()[i])) {
      refuse(i, ".radius", medium.radii()[i], domain::length);
    }
    if (!domain::density.contains(medium.densities()[i])) {
      refuse(i, ".density", medium.densities()[i], domain::density);
    }
    const GaussianOptics optics = medium.optics(i);
    if (optics != GaussianOptics()) check_optics(element("medium.gaussians", i), optics);
  }
}

void check(const Camera& camera) {
  check_camera("camera", camera, {});
}

void check(const Scene& scene) {
  check_camera("camera", scene.camera, scene.camera_keys);
  check_count("cameras", scene.cameras.size(), limits::cameras);
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    check_camera(element("cameras", i), scene.cameras[i].camera, scene.cameras[i].keys);
  }
  for (const int side : {scene.film.width, scene.film.height}) {
    if (side < 1 || side > limits::film_side) {
      throw DomainError("film", "found a side of " + std::to_string(side) +
                                    " pixels; allowed: 1 to " + std::to_string(limits::film_side));
    }
  }

  check(scene.medium);
  const double density = scene.medium.homogeneous_density();
  visit_keyed_density(density, scene.density_keys, in("medium"));
  visit_keyed_optics(scene.optics, in("medium"));
  visit_keyed_noise(scene.optics.noise, in("medium.noise"));
  check_count("groups", scene.groups.size(), limits::groups);
  check_groups(scene);
  check_count("emitters", scene.emitters.size(), limits::emitters);
  for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
    visit_keyed_emitter(scene.emitters[i], in(element("emitters", i)));
  }
  check_count("sequences", scene.sequences.size(), limits::sequences);
  for (std::size_t i = 0; i < scene.sequences.size(); ++i) {
    if (!scene.sequences[i].frames) {
      throw DomainError(element("sequences", i) + ".frames", "there are none");
    }
  }

  check_count("lights", scene.lights.size(), limits::lights);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    check_light(element("lights", i), scene.lights[i]);
  }
  if (scene.environment) {
    visit_keyed_environment(*scene.environment, in("environment"));
    if (!scene.environment->map) throw DomainError("environment.map", "there is none");
  }
  check_count("surfaces", scene.surfaces.size(), limits::surfaces);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    check_surface(element("surfaces", i), scene.surfaces[i]);
  }
}

}  // namespace brume
