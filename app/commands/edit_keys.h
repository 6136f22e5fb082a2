#pragma once

#include <span>

#include "app/commands/merge_id.h"
#include "app/document/keyframe_curves.h"

namespace brume {

class Document;

// Edits of keyframes, each one undo step; at the document's time if none is given.

// Sets keyframes of a track from its current values.
void set_keys(Document& document, const Track& row);
// Moves the camera to `camera` and sets its keyframe.
void set_camera_keys(Document& document, const Camera& camera);
void delete_keys(Document& document, const Track& row, std::span<const double> times);
// `before`: the scene part at the start of the gesture.
void move_keys(Document& document, const Track& row, const ScenePart& before,
               std::span<const KeyMove> moves, MergeId merge_id);
// Moves the keys at some times to the document's time.
void align_keys(Document& document, const Track& row, std::span<const double> times);
// Moves keys of curves in time, and sets that number of each.
struct CurveKeyMove {
  CurveId curve;
  KeyMove time;
  double value;
};
void move_curve_keys(Document& document, const Track& row, const ScenePart& before,
                     std::span<const CurveKeyMove> moves, MergeId merge_id);
void set_tangent(Document& document, const Track& row, const CurveId& curve,
                 const TangentEdit& edit, MergeId merge_id);
void set_interpolation(Document& document, const Track& row, std::span<const double> times,
                       Interpolation interpolation);
void set_tangents(Document& document, const Track& row, std::span<const double> times,
                  Tangents tangents);

// Sets the scene's camera, and its keyframe if it has any.
void set_scene_camera(Document& document, const Camera& camera, const QString& text);

}  // namespace brume
