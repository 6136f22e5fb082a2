#pragma once

#include <QString>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <variant>

#include "app/commands/merge_id.h"
#include "app/document/object_ref.h"
#include "brume/scene.h"

namespace brume {

class Document;

// Edits that lights, emitters and surfaces have in common, each one undo step. Of an object that is
// not there they do nothing.

using Object = std::variant<Light, Emitter, Surface>;
std::optional<Object> object_of(const Scene& scene, const ObjectRef& ref);

// Its title in lists: its name, or else "Spot 2", "Emitter 1", "bunny.obj".
QString object_title(const Scene& scene, const ObjectRef& ref);
bool is_shown(Object object);  // visible, or a light that is on
bool is_locked(const Object& object);

// `verb` is the text of the step, with %1 for the object's name.
void change_light(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                  const std::function<void(Light&)>& change);
void change_emitter(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Emitter&)>& change);
void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change);
void delete_object(Document& document, const ObjectRef& ref);
// Adds a copy beside it along x, which becomes the document's object.
void duplicate_object(Document& document, const ObjectRef& ref);
// Without control characters and what is longer than a name may be; empty: none of its own.
void rename_object(Document& document, const ObjectRef& ref, const QString& name);
void show_object(Document& document, const ObjectRef& ref, bool shown);
void lock_object(Document& document, const ObjectRef& ref, bool locked);

// A movement: turned and stretched about the pivot, then shifted.
struct Movement {
  glm::dvec3 pivot{0.0};
  glm::dvec3 shift{0.0};
  glm::dquat turn{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 stretch{1.0};  // along the world's axes, > 0
  double size = 1.0;        // of what has a size of its own, > 0

  bool operator==(const Movement&) const = default;
  [[nodiscard]] glm::dvec3 point(const glm::dvec3& p) const {
    return pivot + shift + turn * (stretch * (p - pivot));
  }
};
// Within what files allow. A stretch along one axis changes the size of a primitive along the axis
// of its own that is nearest to it; other surfaces keep their size then.
Object moved(const Object& object, const Movement& movement);
// `before`: as it was when the gesture began. `verb` is the text of the step, with %1 for the name.
void move_object(Document& document, const ObjectRef& ref, const Object& before,
                 const Movement& movement, const QString& verb, MergeId merge_id);

}  // namespace brume
