#pragma once

#include "app/commands/merge_id.h"
#include "app/document/key_rows.h"

namespace brume {

class Document;

// What users do to keys, each one undo step; at the document's time where none is given.

// The values of a row as they are become keys of now.
void set_keys(Document& document, const KeyRow& row);
// The same of the camera, which becomes `camera` before.
void set_camera_keys(Document& document, const Camera& camera);
void delete_keys(Document& document, const KeyRow& row, double time);
// `before` is the part as it was when the gesture began.
void move_keys(Document& document, const KeyRow& row, const ScenePart& before, double from,
               double to, MergeId merge_id);
void set_interpolation(Document& document, const KeyRow& row, double time,
                       Interpolation interpolation);

// The scene's camera, and if it has keys that of now.
void set_scene_camera(Document& document, const Camera& camera, const QString& text);

}  // namespace brume
