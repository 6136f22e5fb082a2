#include "app/commands/objects/edit_objects.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <type_traits>
#include <utility>

#include "app/commands/allowed_name.h"
#include "app/commands/objects/edit_emitters.h"
#include "app/commands/objects/edit_lights.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/object_titles.h"
#include "brume/limits.h"
#include "brume/mesh_arrays.h"
#include "core/math/rounded.h"
#include "core/scene/copies.h"
#include "core/scene/fields/light_fields.h"

namespace brume {
namespace {

using Kind = ObjectRef::Kind;

// Calls visit(list, most) with the list that objects of a kind are in, and how many it may have.
auto visit_list(const Scene& scene, Kind kind, auto&& visit) {
  switch (kind) {
    case Kind::light:
      return visit(scene.lights, limits::lights);
    case Kind::emitter:
      return visit(scene.emitters, limits::emitters);
    case Kind::surface:
      break;
  }
  return visit(scene.surfaces, limits::surfaces);
}

// In undo texts: its name, or else "spot 2".
QString object_name(const Scene& scene, const ObjectRef& ref) {
  if (ref.kind == Kind::light) return light_name(scene.lights[ref.index], ref.index);
  if (ref.kind == Kind::emitter) return emitter_name(scene.emitters[ref.index], ref.index);
  return object_title(scene, ref);
}

// Calls change(list, ref.index) with a copy of the list that an object is in, as one undo step.
void change_list(Document& document, const ObjectRef& ref, const QString& verb, MergeId merge_id,
                 const auto& change) {
  visit_list(document.scene(), ref.kind, [&](auto list, std::size_t) {
    if (ref.index >= list.size()) return;
    const QString text = verb.arg(object_name(document.scene(), ref));
    change(list);
    set_scene_part(document, std::move(list), text, merge_id);
  });
}

// `change` gets a Light&, an Emitter& or a Surface&.
void change_object(Document& document, const ObjectRef& ref, const QString& verb, MergeId merge_id,
                   const auto& change) {
  change_list(document, ref, verb, merge_id, [&]<class T>(std::vector<T>& list) {
    if constexpr (std::is_invocable_v<decltype(change), T&>) change(list[ref.index]);
  });
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
    const MeshBox box = world_box(*surface);
    return rounded(1.1 * std::max(box.high.x - box.low.x, 0.0), 3);
  }
  if (const auto* emitter = std::get_if<Emitter>(&object))
    return rounded(3.0 * emitter->radius[1], 3);
  const double distance = glm::distance(std::get<Light>(object).position, scene.camera.target);
  return rounded(0.1 * distance, 3);
}

bool& shown_member(Light& light) {
  return light.on;
}

bool& shown_member(auto& object) {
  return object.visible;
}

bool refuses_node(Document& document, const ObjectRef& ref) {
  if (ref.node) {
    Q_EMIT document.refused(Document::tr("A node is part of its file. Select its surface."));
  }
  return ref.node.has_value();
}

}  // namespace

std::optional<Object> object_of(const Scene& scene, const ObjectRef& ref) {
  return visit_list(scene, ref.kind, [&](const auto& list, std::size_t) {
    return ref.index < list.size() ? std::optional<Object>(list[ref.index]) : std::nullopt;
  });
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

bool is_shown(Object object) {
  return std::visit([](auto& o) { return shown_member(o); }, object);
}

bool is_locked(const Object& object) {
  return std::visit([](const auto& o) { return o.locked; }, object);
}

void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change) {
  change_object(document, {Kind::light, index}, verb, merge_id, change);
}

void change_emitter(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Emitter&)>& change) {
  change_object(document, {Kind::emitter, index}, verb, merge_id, change);
}

void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change) {
  change_object(document, {Kind::surface, index}, verb, merge_id, change);
}

void delete_object(Document& document, const ObjectRef& ref) {
  if (refuses_node(document, ref)) return;
  change_list(document, ref, undo_text("Delete %1"), no_merge, [&](auto& list) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(ref.index));
  });
}

void duplicate_object(Document& document, const ObjectRef& ref) {
  if (refuses_node(document, ref)) return;
  const std::optional<Object> object = object_of(document.scene(), ref);
  if (!object) return;
  const glm::dvec3 shift(width_of(*object, document.scene()), 0.0, 0.0);
  Object copy = moved(*object, {.shift = shift});
  if (auto* emitter = std::get_if<Emitter>(&copy)) ++emitter->seed;  // for particles of its own
  const QString text = undo_text("Duplicate %1").arg(object_title(document.scene(), ref));
  visit_list(document.scene(), ref.kind, [&]<class T>(std::vector<T> list, std::size_t most) {
    if (list.size() >= most) return;
    list.push_back(std::get<T>(copy));
    const ObjectRef added{ref.kind, list.size() - 1};
    set_scene_part(document, std::move(list), text);
    document.set_object(added);
  });
}

void rename_object(Document& document, const ObjectRef& ref, const QString& name) {
  const std::string text = allowed_name(name).toStdString();
  change_list(document, ref, undo_text("Rename %1"), no_merge, [&]<class T>(std::vector<T>& list) {
    if constexpr (std::is_same_v<T, Surface>) {
      // Copies stay scattered over it.
      for (Surface& surface : list) {
        if (text.empty() || !surface.copies) continue;
        Scatter& scatter = surface.copies->scatter;
        if (find_scattered_over(scatter, list) == &list[ref.index]) scatter.over = text;
      }
    }
    list[ref.index].name = text;
  });
}

void show_object(Document& document, const ObjectRef& ref, bool shown) {
  if (refuses_node(document, ref)) return;
  const QString verb = ref.kind == Kind::light
                           ? shown ? undo_text("Turn on %1") : undo_text("Turn off %1")
                       : shown ? undo_text("Show %1")
                               : undo_text("Hide %1");
  change_object(document, ref, verb, no_merge,
                [shown](auto& object) { shown_member(object) = shown; });
}

void lock_object(Document& document, const ObjectRef& ref, bool locked) {
  if (refuses_node(document, ref)) return;
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
