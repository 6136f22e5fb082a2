#include "core/scene/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "brume/scene.h"
#include "core/math/max_component.h"
#include "core/scene/animation/animation.h"
#include "core/scene/cameras.h"
#include "core/scene/copies.h"
#include "core/scene/fields/copies_fields.h"
#include "core/scene/fields/description.h"
#include "core/scene/group_effects.h"
#include "core/scene/light_rules.h"
#include "core/scene/lights/sky.h"

namespace brume {

void check_value(const std::string& place, double value, const NumberDomain& domain) {
  if (!domain.contains(value)) throw DomainError(place, domain.refusal(value));
}

namespace {

template <int n>
void check_value(const std::string& place, const glm::vec<n, double>& value,
                 const NumberDomain& domain) {
  for (int k = 0; k < n; ++k) {
    // Places are named for what is refused only: there are many values.
    if (!domain.contains(value[k])) {
      brume::check_value(place + "[" + std::to_string(k) + "]", value[k], domain);
    }
  }
}

void check_rotation(const std::string& place, const glm::dquat& value, double tolerance) {
  // NaN, too, is no unit.
  if (!(std::abs(glm::length(value) - 1.0) < tolerance)) {
    throw DomainError(place, "allowed: a unit quaternion");
  }
}

void check_value(const std::string& place, const glm::dquat& value, const NumberDomain&) {
  check_rotation(place, value, 1e-3);
}

std::string element(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

// Values with keyframes, and their keys.
auto in(const std::string& object) {
  return [prefix = object + "."](const char* name, const auto& value, const auto& keys,
                                 const NumberDomain& domain) {
    check_value(prefix + name, value, domain);
    if (keys.empty()) return;
    const std::string list = prefix + "keys." + name;
    if (keys.size() > limits::keys_of_value) {
      throw DomainError(list,
                        "allowed: at most " + std::to_string(limits::keys_of_value) + " keyframes");
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::string key_place = element(list, i);
      brume::check_value(key_place + ".time", keys[i].time, domain::seconds);
      if (i > 0 && !(keys[i].time - keys[i - 1].time >= min_key_distance)) {
        throw DomainError(key_place + ".time", "allowed: later than the key before it");
      }
      check_value(key_place + ".value", keys[i].value, domain);
      if (keys[i].in) check_value(key_place + ".in", *keys[i].in, domain::slope);
      if (keys[i].out) check_value(key_place + ".out", *keys[i].out, domain::slope);
    }
  };
}

void check_integer(const std::string& place, std::int64_t value, std::int64_t low,
                   std::int64_t high) {
  if (value >= low && value <= high) return;
  throw DomainError(place, "found " + std::to_string(value) + "; allowed: " + std::to_string(low) +
                               " to " + std::to_string(high));
}

void check_count(const std::string& list, std::size_t count, std::size_t allowed) {
  if (count <= allowed) return;
  throw DomainError(list, "has " + std::to_string(count) + " elements; allowed: at most " +
                              std::to_string(allowed));
}

void check_name(const std::string& place, const std::string& name, std::size_t shortest) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (name.size() < shortest || name.size() > limits::name_length ||
      std::ranges::any_of(name, is_control)) {
    throw DomainError(place, "allowed: a name of " + std::to_string(shortest) + " to " +
                                 std::to_string(limits::name_length) +
                                 " bytes without control characters");
  }
}

// A name by which others refer to an object.
void check_own_name(const std::string& place, const std::string& name,
                    std::set<std::string>& known) {
  check_name(place, name, 1);
  if (!known.insert(name).second) {
    throw DomainError(place, "allowed: a name that no other of its kind has");
  }
}

void check_optics(const std::string& place, const GaussianOptics& optics) {
  if (optics.albedo) check_value(place + ".albedo", *optics.albedo, domain::albedo);
  check_value(place + ".emission", optics.emission, domain::intensity);
}

void check_shape(const std::string& place, const GaussianShape& shape) {
  check_value(place + ".stretch", shape.stretch, domain::stretch);
  if (max_component(shape.stretch) != 1.0) {
    throw DomainError(place + ".stretch", "allowed: numbers of which the greatest is 1");
  }
  // Its error counts as many times as the ellipsoid is long.
  check_rotation(place + ".rotation", shape.rotation, 1e-9);
}

bool is_sound(const Gaussian& gaussian) {
  const auto& [center, radius, density, optics, group, shape] = gaussian;
  return domain::coordinate.contains(center.x) && domain::coordinate.contains(center.y) &&
         domain::coordinate.contains(center.z) && domain::length.contains(radius) &&
         domain::density.contains(density);
}

void check_gaussian(const std::string& list, std::size_t index, const Gaussian& gaussian) {
  const bool has_optics = gaussian.optics != GaussianOptics();
  if (is_sound(gaussian) && !has_optics && gaussian.is_ball()) return;
  const std::string place = element(list, index);
  check_value(place + ".center", gaussian.center, domain::coordinate);
  brume::check_value(place + ".radius", gaussian.radius, domain::length);
  brume::check_value(place + ".density", gaussian.density, domain::density);
  check_optics(place, gaussian.optics);
  check_shape(place + ".shape", gaussian.shape);
}

// Values of core/scene/fields.
void check_values(const std::string& place, const auto& owner) {
  visit_present(owner, [&place]<class T>(const auto& field, const T& value) {
    if constexpr (!std::is_integral_v<T>) {
      check_value(place + "." + field.info.name, value, field.domain);
    }
  });
  visit_fields_of(owner, [&](const auto& field) {
    const FieldInfo* const other = replacement(field, owner);
    if (other && !field.info.is_always_saved && !is_usual(field, owner)) {
      throw DomainError(place + "." + other->name, found_beside(field.info.name));
    }
  });
}

// The same, and their keyframes.
void check_fields(const std::string& place, const auto& owner, const auto& keys) {
  check_values(place, owner);
  visit_keyed(owner, keys, in(place));
}

void check_camera(const std::string& place, const Camera& camera, const CameraKeys& keys) {
  check_fields(place, camera, keys);
  if (const auto refused = refusal(camera)) {
    throw DomainError(place + "." + refused->member, refused->message);
  }
}

void check_cameras(const Scene& scene) {
  check_camera("camera", scene.camera, scene.camera_keys);
  std::set<std::string> names;
  check_own_name("camera.name", scene.camera_name, names);
  check_count("cameras", scene.cameras.size(), limits::cameras);
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
    const NamedCamera& camera = scene.cameras[i];
    const std::string place = element("cameras", i);
    check_own_name(place + ".name", camera.name, names);
    check_camera(place, camera.camera, camera.keys);
  }
}

void check_light(const std::string& place, const Light& light) {
  check_name(place + ".name", light.name, 0);
  check_fields(place, light, light.keys);
  if (const auto refused = refusal(light)) {
    throw DomainError(place + "." + refused->member, refused->message);
  }
}

void check_material(const std::string& place, const Material& material) {
  if (material.type == Material::Type::measured && !material.measured) {
    throw DomainError(place + ".measured", "there is none");
  }
  if (material.type == Material::Type::metallic_roughness) {
    check_values(place, material.metallic_roughness);
  }
}

void check_copies(const std::string& place, const Copies& copies) {
  check_values(place, copies.scatter);
  if (!copies.placements) return;
  check_count(place, copies.placements->size(), limits::copies);
  for (std::size_t i = 0; i < copies.placements->size(); ++i) {
    const auto& [translate, rotate, scale] = (*copies.placements)[i];
    check_value(element(place, i) + ".translate", translate, domain::coordinate);
    brume::check_value(element(place, i) + ".scale", scale, domain::length);
    check_rotation(element(place, i) + ".rotate", rotate, 1e-3);
  }
}

void check_surface(const std::string& place, const Surface& surface) {
  check_name(place + ".name", surface.name, 0);
  visit_keyed_surface(surface, in(place));
  if (!surface.mesh) throw DomainError(place + ".mesh", "there is none");
  if (surface.primitive) check_size(place + ".primitive.size", *surface.primitive);
  check_material(place + ".material", surface.material);
  std::set<std::string> names;
  for (std::size_t i = 0; i < surface.materials.size(); ++i) {
    const std::string material = element(place + ".materials", i);
    check_own_name(material + ".name", surface.materials[i].name, names);
    check_material(material, surface.materials[i]);
  }
  if (surface.copies) check_copies(place + ".copies", *surface.copies);
}

void check_copy_count(const Scene& scene) {
  const double count = copy_count(scene.surfaces);
  if (count <= static_cast<double>(limits::copies)) return;
  throw DomainError("surfaces", "have " + quoted_text(count) + " copies; allowed: at most " +
                                    std::to_string(limits::copies));
}

void check_groups(const Scene& scene) {
  check_count("medium.groups", scene.groups.size(), limits::groups);
  std::set<GroupId> ids;
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.groups.size(); ++i) {
    const Group& group = scene.groups[i];
    const std::string place = element("medium.groups", i);
    if (group.id == 0 || !ids.insert(group.id).second) {
      throw DomainError(place + ".id", "allowed: above 0, and of no other group");
    }
    check_own_name(place + ".name", group.name, names);
    check_fields(place, group, group.keys);
  }
  for (std::size_t i = 0; i < scene.groups.size(); ++i) {
    const Group& group = scene.groups[i];
    if (group.parent == 0) continue;
    const Group* parent = find_group(scene.groups, group.parent);
    if (parent == nullptr || parent->parent != 0) {
      throw DomainError(element("medium.groups", i) + ".parent",
                        "allowed: the id of a group without a parent, or 0");
    }
  }
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    const GroupId group = scene.medium.group(i);
    if (group != 0 && !ids.contains(group)) {
      throw DomainError(element("medium.gaussians", i) + ".group", "there is no such group");
    }
  }
}

void check_spline(const std::string& place, const PaintedSpline& spline) {
  if (spline.points.empty()) throw DomainError(place + ".points", "allowed: at least one");
  check_count(place + ".points", spline.points.size(), limits::spline_points);
  for (std::size_t i = 0; i < spline.points.size(); ++i) {
    check_value(element(place + ".points", i), spline.points[i], domain::coordinate);
  }
  const Paintbrush& brush = spline.brush;
  brume::check_value(place + ".radius", brush.radius, domain::length);
  brume::check_value(place + ".density", brush.density, domain::density);
  brume::check_value(place + ".spacing", brush.spacing, domain::brush_spacing);
  brume::check_value(place + ".scatter", brush.scatter, domain::brush_scatter);
  brume::check_value(place + ".falloff", brush.falloff, domain::unit);
  brume::check_value(place + ".flow", brush.flow, domain::unit);
  brume::check_value(place + ".jitter", brush.jitter, domain::unit);
  brume::check_value(place + ".stretch", brush.stretch, domain::brush_stretch);
  check_value(place + ".mirror_center", spline.mirrors.center, domain::coordinate);
  check_optics(place, spline.optics);
}

void check_splines(const Scene& scene) {
  check_count("medium.splines", scene.splines.size(), limits::splines);
  std::set<SplineId> ids;
  std::set<std::string> names;
  for (std::size_t i = 0; i < scene.splines.size(); ++i) {
    const PaintedSpline& spline = scene.splines[i];
    const std::string place = element("medium.splines", i);
    if (spline.id == 0 || !ids.insert(spline.id).second) {
      throw DomainError(place + ".id", "allowed: above 0, and of no other spline");
    }
    check_own_name(place + ".name", spline.name, names);
    check_spline(place, spline);
  }
}

void check_sequence(const std::string& place, const MediumSequence& sequence) {
  constexpr int max_frame = 999'999'999;
  check_integer(place + ".first", sequence.first, 0, max_frame);
  check_integer(place + ".last", sequence.last, sequence.first,
                std::min<std::int64_t>(max_frame,
                                       std::int64_t{sequence.first} + limits::sequence_frames - 1));
  brume::check_value(place + ".frames_per_second", sequence.frames_per_second, domain::rate);
  brume::check_value(place + ".start", sequence.start, domain::seconds);
  if (!sequence.frames) throw DomainError(place + ".frames", "there are none");
  const SequenceFrames& frames = *sequence.frames;
  if (frames.size() != static_cast<std::size_t>(sequence.last - sequence.first) + 1) {
    throw DomainError(place + ".frames", "allowed: as many as from `first` to `last`");
  }
  // Others are checked when they are read.
  for (std::size_t i = 0; frames.are_in_memory() && i < frames.size(); ++i) {
    const std::string frame_place = element(place + ".frames", i);
    const SequenceFrame& frame = *frames.frame(i);
    if (frame.ids.size() != frame.gaussians.size() ||
        std::ranges::adjacent_find(frame.ids, std::greater_equal<>()) != frame.ids.end()) {
      throw DomainError(frame_place + ".ids", "allowed: ascending, one for each Gaussian");
    }
    for (std::size_t k = 0; k < frame.gaussians.size(); ++k) {
      check_gaussian(frame_place + ".gaussians", k, frame.gaussians[k]);
    }
  }
}

void check_medium(const Scene& scene) {
  check(scene.medium);
  const double density = scene.medium.homogeneous_density();
  visit_keyed_density(density, scene.density_keys, in("medium"));
  check_fields("medium", scene.optics, scene.optics.keys);
  check_fields("medium.noise", scene.optics.noise, scene.optics.noise.keys);
  check_groups(scene);
  check_splines(scene);
  check_count("medium.emitters", scene.emitters.size(), limits::emitters);
  for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
    const std::string place = element("medium.emitters", i);
    check_name(place + ".name", scene.emitters[i].name, 0);
    check_fields(place, scene.emitters[i], scene.emitters[i].keys);
  }
  check_count("medium.sequences", scene.sequences.size(), limits::sequences);
  for (std::size_t i = 0; i < scene.sequences.size(); ++i) {
    check_sequence(element("medium.sequences", i), scene.sequences[i]);
  }
  check_count("medium, with emitters and sequences", gaussian_count(scene), limits::gaussians);
}

void check_shutter(const std::string& place, const Shutter& shutter) {
  brume::check_value(place + "[0]", shutter.open, domain::shutter);
  brume::check_value(place + "[1]", shutter.close, domain::shutter);
  if (!(shutter.open < shutter.close)) {
    throw DomainError(place, "allowed: one that opens before it closes");
  }
}

void check_output(const Output& output) {
  if (output.paths) check_integer("output.paths", *output.paths, 1, limits::paths);
  if (output.samples) check_integer("output.samples", *output.samples, 1, limits::samples);
  if (output.shutter) check_shutter("output.shutter", *output.shutter);
  if (output.exposure) brume::check_value("output.exposure", *output.exposure, domain::stops);
}

}  // namespace

void check_film(const std::string& place, const Film& film) {
  check_integer(place + ".width", film.width, 1, limits::film_side);
  check_integer(place + ".height", film.height, 1, limits::film_side);
  if (const auto& region = film.region) {
    check_integer(place + ".region.full_width", region->full_width, 1, limits::film_side);
    check_integer(place + ".region.full_height", region->full_height, 1, limits::film_side);
    check_integer(place + ".region.x", region->x, 0, region->full_width - film.width);
    check_integer(place + ".region.y", region->y, 0, region->full_height - film.height);
  }
  constexpr NumberDomain shift{-1e6, 1e6, "a number of pixels from -1e6 to 1e6"};
  check_value(place + ".shift", film.shift, shift);
}

void check_size(const std::string& place, const Primitive& primitive) {
  check_value(place, primitive.size, domain::length);
}

void check(const Medium& medium) {
  check_count("medium.gaussians", medium.size(), limits::gaussians);
  check_value("medium.density", medium.homogeneous_density(), domain::density);
  for (std::size_t i = 0; i < medium.size(); ++i) {
    check_gaussian("medium.gaussians", i, medium.gaussian(i));
  }
}

void check(const Camera& camera) {
  check_camera("camera", camera, {});
}

void check(const Scene& scene) {
  check_cameras(scene);
  check_film("film", scene.film);
  check_output(scene.output);
  if (const auto& playback = scene.playback) {
    check_integer("timeline.first", playback->first, 0, limits::frame);
    check_integer("timeline.last", playback->last, playback->first, limits::frame);
    check_value("timeline.frames_per_second", playback->frames_per_second, domain::frame_rate);
  }
  check_medium(scene);
  const bool has_sun = sun_of_sky(scene) != nullptr;
  check_count(has_sun ? "lights, with the sky's sun" : "lights", scene.lights.size() + has_sun,
              limits::lights);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    check_light(element("lights", i), scene.lights[i]);
  }
  if (scene.environment) {
    check_fields("environment", *scene.environment, scene.environment->keys);
    if (const auto& sky = scene.environment->sky) {
      if (!scene.environment->file.empty() || scene.environment->map) {
        throw DomainError("environment.sky", found_beside("file"));
      }
      check_fields("environment.sky", *sky, sky->keys);
    } else if (!scene.environment->map)
      throw DomainError("environment.map", "there is none");
  }
  check_count("surfaces", scene.surfaces.size(), limits::surfaces);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    check_surface(element("surfaces", i), scene.surfaces[i]);
  }
  check_copy_count(scene);
}

}  // namespace brume
