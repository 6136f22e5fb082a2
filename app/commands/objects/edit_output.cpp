#include "app/commands/objects/edit_output.h"

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {

void set_film(Document& document, const Film& film, MergeId gesture) {
  set_scene_part(document, film, undo_text("Set size of picture"), gesture);
}

void change_output(Document& document, const QString& text, MergeId gesture,
                   const std::function<void(Output&)>& change) {
  Output output = document.scene().output;
  change(output);
  set_scene_part(document, std::move(output), text, gesture);
}

}  // namespace brume
