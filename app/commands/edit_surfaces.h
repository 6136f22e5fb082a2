#pragma once

#include <QStringList>
#include <functional>

#include "app/commands/merge_id.h"
#include "app/document/scene_part.h"

namespace brume {

class Document;

// Edits of surfaces, each one undo step. `index`: of the scene's surfaces.

// The names of their mesh files, those of the same name numbered: "bunny.obj", "bunny.obj (2)".
QStringList surface_names(const Surfaces& surfaces);

void delete_surface(Document& document, std::size_t index);
// Adds a copy as the last surface, beside the original along x.
void duplicate_surface(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the surface's name.
void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change);

}  // namespace brume
