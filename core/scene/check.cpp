#include "core/scene/check.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ranges>
#include <set>
#include <utility>

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

using brume::check_value;

template <int n>
void check_value(const std::string& place, const glm::vec<n, double>& value,
                 const NumberDomain& domain) {
  for (int k = 0; k < n; ++k) {
    // Places are named for what is refused only: there are many values.
    if (!domain.contains(value[k])) {
      check_value(place + "[" + std::to_string(k) + "]", value[k], domain);
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
      check_value(key_place + ".time", keys[i].time, domain::seconds);
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

// The elements of a list, of which there may be `allowed`, each with its place.
auto elements(const std::string& list, const auto& values, std::size_t allowed) {
  check_count(list, values.size(), allowed);
  return std::views::iota(std::size_t{0}, values.size()) |
         std::views::transform([list, &values](std::size_t i) {
           return std::pair<std::string, decltype(values[i])>(element(list, i), values[i]);
         });
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

// A number by which others refer to an object.
void check_own_id(const std::string& place, const char* kind, std::uint64_t id,
                  std::set<std::uint64_t>& known) {
  if (id != 0 && known.insert(id).second) return;
  throw DomainError(place + ".id", std::string("allowed: above 0, and of no other ") + kind);
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

void check_gaussian(const std::string& list, std::size_t index, const Gaussian& gaussian) {
  const auto& [center, radius, density, optics, group, shape] = gaussian;
  // Its place is named only where there is something to say: there are many.
  if (contains(domain::coordinate, center) && domain::length.contains(radius) &&
      domain::density.contains(density) && optics == GaussianOptics() && gaussian.is_ball()) {
    return;
  }
  const std::string place = element(list, index);
  check_value(place + ".center", center, domain::coordinate);
  check_value(place + ".radius", radius, domain::length);
  check_value(place + ".density", density, domain::density);
  check_optics(place, optics);
  check_shape(place + ".shape", shape);
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
  for (const auto& [place, camera] : elements("cameras", scene.cameras, limits::cameras)) {
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
  for (const auto& [copy, placement] : elements(place, *copies.placements, limits::copies)) {
    check_value(copy + ".translate", placement.translate, domain::coordinate);
    check_value(copy + ".scale", placement.scale, domain::length);
    check_rotation(copy + ".rotate", placement.rotate, 1e-3);
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
  std::set<std::uint64_t> ids;
  std::set<std::string> names;
  for (const auto& [place, group] : elements("medium.groups", scene.groups, limits::groups)) {
    check_own_id(place, "group", group.id, ids);
    check_own_name(place + ".name", group.name, names);
    check_fields(place, group, group.keys);
  }
  for (const auto& [place, group] : elements("medium.groups", scene.groups, limits::groups)) {
    if (group.parent == 0) continue;
    const Group* parent = find_group(scene.groups, group.parent);
    if (parent && parent->parent == 0) continue;
    throw DomainError(place + ".parent", "allowed: the id of a group without a parent, or 0");
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
  for (const auto& [point, value] :
       elements(place + ".points", spline.points, limits::spline_points)) {
    check_value(point, value, domain::coordinate);
  }
  const Paintbrush& brush = spline.brush;
  check_value(place + ".radius", brush.radius, domain::length);
  check_value(place + ".density", brush.density, domain::density);
  check_value(place + ".spacing", brush.spacing, domain::brush_spacing);
  check_value(place + ".scatter", brush.scatter, domain::brush_scatter);
  check_value(place + ".falloff", brush.falloff, domain::unit);
  check_value(place + ".flow", brush.flow, domain::unit);
  check_value(place + ".jitter", brush.jitter, domain::unit);
  check_value(place + ".stretch", brush.stretch, domain::brush_stretch);
  check_value(place + ".mirror_center", spline.mirrors.center, domain::coordinate);
  check_optics(place, spline.optics);
}

void check_splines(const Scene& scene) {
  std::set<std::uint64_t> ids;
  std::set<std::string> names;
  for (const auto& [place, spline] : elements("medium.splines", scene.splines, limits::splines)) {
    check_own_id(place, "spline", spline.id, ids);
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
  check_value(place + ".frames_per_second", sequence.frames_per_second, domain::rate);
  check_value(place + ".start", sequence.start, domain::seconds);
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
  for (const auto& [place, emitter] :
       elements("medium.emitters", scene.emitters, limits::emitters)) {
    check_name(place + ".name", emitter.name, 0);
    check_fields(place, emitter, emitter.keys);
  }
  for (const auto& [place, sequence] :
       elements("medium.sequences", scene.sequences, limits::sequences))
    check_sequence(place, sequence);
  check_count("medium, with emitters and sequences", gaussian_count(scene), limits::gaussians);
}

void check_output(const Output& output) {
  if (output.paths) check_integer("output.paths", *output.paths, 1, limits::paths);
  if (output.samples) check_integer("output.samples", *output.samples, 1, limits::samples);
  if (const auto& shutter = output.shutter) {
    check_value("output.shutter", glm::dvec2(shutter->open, shutter->close), domain::shutter);
    if (!(shutter->open < shutter->close)) {
      throw DomainError("output.shutter", "allowed: one that opens before it closes");
    }
  }
  if (output.exposure) check_value("output.exposure", *output.exposure, domain::stops);
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
    } else if (!scene.environment->map) {
      throw DomainError("environment.map", "there is none");
    }
  }
  for (const auto& [place, surface] : elements("surfaces", scene.surfaces, limits::surfaces))
    check_surface(place, surface);
  check_copy_count(scene);
}

}  // namespace brume
