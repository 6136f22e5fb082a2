#pragma once

#include "app/commands/merge_id.h"
#include "app/document/keyframe_curves.h"

namespace brume {

class Document;

// Edits of keyframes, each one undo step; at the document's time if none is given.

// Sets keyframes of a track from its current values.
void set_keys(Document& document, const Track& row);
// Moves the camera to `camera` and sets its keyframe.
void set_camera_keys(Document& document, const Camera& camera);
void delete_keys(Document& document, const Track& row, double time);
// `before`: the scene part at the start of the gesture.
void move_keys(Document& document, const Track& row, const ScenePart& before, double old_time,
               double new_time, MergeId merge_id);
// The same, and sets one number of the key.
struct CurveKeyMove {
  double old_time;  // [s]
  double new_time;
  double value;
};
void move_curve_key(Document& document, const Track& row, const Curve& curve,
                    const ScenePart& before, const CurveKeyMove& move, MergeId merge_id);
void set_interpolation(Document& document, const Track& row, double time,
                       Interpolation interpolation);

// Sets the scene's camera, and its keyframe if it has any.
void set_scene_camera(Document& document, const Camera& camera, const QString& text);

}  // namespace brume
