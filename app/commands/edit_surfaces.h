#pragma once

#include <QStringList>
#include <functional>

#include "app/commands/merge_id.h"
#include "app/document/scene_part.h"

namespace brume {

class Document;

// Edits of surfaces, each one undo step. `index`: of the scene's surfaces.

QString primitive_title(Primitive::Shape shape);  // "Box"
// Their names, or else those of their shapes or mesh files; the same ones numbered: "bunny.obj",
// "bunny.obj (2)".
QStringList surface_names(const Surfaces& surfaces);

void delete_surface(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the surface's name.
void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change);

}  // namespace brume
