#pragma once

#include <QString>
#include <functional>

#include "app/commands/merge_id.h"
#include "brume/output.h"

namespace brume {

class Document;
struct Film;

// Edits of what is rendered to files, each one undo step.
void set_film(Document& document, const Film& film, MergeId gesture = no_merge);
void change_output(Document& document, const QString& text, MergeId gesture,
                   const std::function<void(Output&)>& change);

}  // namespace brume
