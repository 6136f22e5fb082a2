#include "app/commands/edit_objects.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "app/commands/allowed_name.h"
#include "app/commands/edit_emitters.h"
#include "app/commands/edit_lights.h"
#include "app/commands/edit_surfaces.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/math/rounded.h"
#include "core/scene/fields/light_fields.h"

namespace brume {
namespace {

using Kind = ObjectRef::Kind;

template <class T>
std::optional<Object> element(const std::vector<T>& list, std::size_t index) {
  return index < list.size() ? std::optional<Object>(list[index]) : std::nullopt;
}

// `change` gets a Light&, an Emitter& or a Surface&.
void change_object(Document& document, const ObjectRef& ref, const QString& verb, MergeId merge_id,
                   const auto& change) {
  switch (ref.kind) {
    case Kind::light:
      return change_light(document, ref.index, verb, merge_id, change);
    case Kind::emitter:
      return change_emitter(document, ref.index, verb, merge_id, change);
    case Kind::surface:
      return change_surface(document, ref.index, verb, merge_id, change);
  }
}

glm::dvec3 allowed_place(const glm::dvec3& p) {
  return glm::clamp(p, -limits::coordinate, limits::coordinate);
}

double allowed_length(double length) {
  return std::clamp(length, limits::min_length, limits::max_length);
}

void move(Light& light, const Movement& movement) {
  if (auto* position = find_value<glm::dvec3>(light, "position")) {
    *position = allowed_place(movement.point(*position));
  }
  for (const char* name : {"direction", "up"}) {
    if (auto* direction = find_value<glm::dvec3>(light, name)) {
      *direction = movement.turn * *direction;
    }
  }
  scale(light, movement.size);
}

void move(Emitter& emitter, const Movement& movement) {
  emitter.position = allowed_place(movement.point(emitter.position));
  emitter.velocity = allowed_place(movement.turn * (movement.size * emitter.velocity));
  emitter.acceleration = allowed_place(movement.turn * (movement.size * emitter.acceleration));
  emitter.spread = std::min(movement.size * emitter.spread, limits::coordinate);
  for (const int k : {0, 1}) emitter.radius[k] = allowed_length(movement.size * emitter.radius[k]);
}

// The axis of the surface that points most along an axis of the world.
int own_axis(const Surface& surface, int world_axis) {
  const glm::dmat3 axes = glm::mat3_cast(surface.rotate);
  int nearest = 0;
  for (const int k : {1, 2}) {
    if (std::abs(axes[k][world_axis]) > std::abs(axes[nearest][world_axis])) nearest = k;
  }
  return nearest;
}

void move(Surface& surface, const Movement& movement) {
  surface.translate = allowed_place(movement.point(surface.translate));
  surface.rotate = glm::normalize(movement.turn * surface.rotate);
  surface.scale = allowed_length(movement.size * surface.scale);
  if (!surface.primitive || movement.size != 1.0 || movement.stretch == glm::dvec3(1.0)) return;
  for (const int k : {0, 1, 2}) {
    double& size = surface.primitive->size[own_axis(surface, k)];
    size = allowed_length(movement.stretch[k] * size);
  }
  surface.mesh = mesh_of(*surface.primitive);
}

// About as wide as it is seen [u].
double width_of(const Object& object, const Scene& scene) {
  if (const auto* surface = std::get_if<Surface>(&object)) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec3& p : world_points(*surface)) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    return rounded(1.1 * std::max(high - low, 0.0), 3);
  }
  if (const auto* emitter = std::get_if<Emitter>(&object))
    return rounded(3.0 * emitter->radius[1], 3);
  const double distance = glm::distance(std::get<Light>(object).position, scene.camera.target);
  return rounded(0.1 * distance, 3);
}

}  // namespace

std::optional<Object> object_of(const Scene& scene, const ObjectRef& ref) {
  switch (ref.kind) {
    case Kind::light:
      return element(scene.lights, ref.index);
    case Kind::emitter:
      return element(scene.emitters, ref.index);
    case Kind::surface:
      return element(scene.surfaces, ref.index);
  }
  return std::nullopt;
}

QString object_title(const Scene& scene, const ObjectRef& ref) {
  switch (ref.kind) {
    case Kind::light:
      return light_title(scene.lights.at(ref.index), ref.index);
    case Kind::emitter:
      return emitter_title(scene.emitters.at(ref.index), ref.index);
    case Kind::surface:
      return surface_names(scene.surfaces).at(static_cast<int>(ref.index));
  }
  return {};
}

bool is_shown(const Object& object) {
  if (const auto* light = std::get_if<Light>(&object)) return light->on;
  if (const auto* emitter = std::get_if<Emitter>(&object)) return emitter->visible;
  return std::get<Surface>(object).visible;
}

bool is_locked(const Object& object) {
  return std::visit([](const auto& o) { return o.locked; }, object);
}

void delete_object(Document& document, const ObjectRef& ref) {
  switch (ref.kind) {
    case Kind::light:
      return delete_light(document, ref.index);
    case Kind::emitter:
      return delete_emitter(document, ref.index);
    case Kind::surface:
      return delete_surface(document, ref.index);
  }
}

void duplicate_object(Document& document, const ObjectRef& ref) {
  const std::optional<Object> object = object_of(document.scene(), ref);
  if (!object) return;
  const QString text = undo_text("Duplicate %1").arg(object_title(document.scene(), ref));
  const auto add = [&]<class T>(std::vector<T> list, std::size_t most, const Object& copy) {
    if (list.size() >= most) return;
    list.push_back(std::get<T>(copy));
    const ObjectRef added{ref.kind, list.size() - 1};
    set_scene_part(document, std::move(list), text);
    document.set_object(added);
  };
  const glm::dvec3 shift(width_of(*object, document.scene()), 0.0, 0.0);
  Object copy = moved(*object, {.shift = shift});
  const Scene& scene = document.scene();
  if (auto* emitter = std::get_if<Emitter>(&copy)) {
    ++emitter->seed;  // or its particles would be the same
    add(scene.emitters, limits::emitters, copy);
  } else if (ref.kind == Kind::light) {
    add(scene.lights, limits::lights, copy);
  } else {
    add(scene.surfaces, limits::surfaces, copy);
  }
}

void rename_object(Document& document, const ObjectRef& ref, const QString& name) {
  change_object(document, ref, undo_text("Rename %1"), no_merge,
                [text = allowed_name(name).toStdString()](auto& object) { object.name = text; });
}

void show_object(Document& document, const ObjectRef& ref, bool shown) {
  if (ref.kind == Kind::light) {
    return change_light(document, ref.index,
                        shown ? undo_text("Turn on %1") : undo_text("Turn off %1"), no_merge,
                        [shown](Light& light) { light.on = shown; });
  }
  const QString verb = shown ? undo_text("Show %1") : undo_text("Hide %1");
  if (ref.kind == Kind::emitter) {
    change_emitter(document, ref.index, verb, no_merge,
                   [shown](Emitter& emitter) { emitter.visible = shown; });
  } else {
    change_surface(document, ref.index, verb, no_merge,
                   [shown](Surface& surface) { surface.visible = shown; });
  }
}

void lock_object(Document& document, const ObjectRef& ref, bool locked) {
  change_object(document, ref, locked ? undo_text("Lock %1") : undo_text("Unlock %1"), no_merge,
                [locked](auto& object) { object.locked = locked; });
}

Object moved(const Object& object, const Movement& movement) {
  Object result = object;
  std::visit([&](auto& o) { move(o, movement); }, result);
  return result;
}

void move_object(Document& document, const ObjectRef& ref, const Object& before,
                 const Movement& movement, const QString& verb, MergeId merge_id) {
  change_object(document, ref, verb, merge_id, [&]<class T>(T& object) {
    object = std::get<T>(movement == Movement{.pivot = movement.pivot} ? before
                                                                       : moved(before, movement));
  });
}

}  // namespace brume
