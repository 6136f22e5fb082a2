#pragma once

#include <QString>
#include <functional>
#include <string>

#include "app/commands/merge_id.h"
#include "brume/scene.h"

namespace brume {

class Document;

// The material of a surface, or one of those of its imported scene, by name.
struct MaterialRef {
  std::size_t surface = 0;
  std::string name{};  // empty: the surface's own
};

// The material as frames show it; nullptr if it is not there, as that of an imported scene itself.
const Material* find_material(const Scene& scene, const MaterialRef& ref);
// True if it takes the place of one of an imported scene's file.
bool is_changed(const Scene& scene, const MaterialRef& ref);

// Edits of one undo step each. `verb` is the text of the step, with %1 for what the material is of.
void change_material(Document& document, const MaterialRef& ref, const QString& verb,
                     MergeId merge_id, const std::function<void(Material&)>& change);
// Gives an imported scene the material of its file again.
void restore_material(Document& document, const MaterialRef& ref);

}  // namespace brume
