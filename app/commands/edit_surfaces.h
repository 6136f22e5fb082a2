#pragma once

#include <QString>
#include <functional>

#include "app/commands/merge_id.h"
#include "app/document/surface_names.h"

namespace brume {

class Document;

// Edits of surfaces, each one undo step. `index`: of the scene's surfaces.

void delete_surface(Document& document, std::size_t index);
// `verb` is the text of the step, with %1 for the surface's name.
void change_surface(Document& document, std::size_t index, const QString& verb, MergeId merge_id,
                    const std::function<void(Surface&)>& change);

}  // namespace brume
