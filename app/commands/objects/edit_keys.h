#pragma once

#include <span>

#include "app/commands/merge_id.h"
#include "app/document/time/keyframe_curves.h"

namespace brume {

class Document;

// Edits of keyframes, of one track or several, each one undo step; at the document's time if none
// is given.

// Sets keyframes of tracks from their current values.
void set_keys(Document& document, std::span<const Track> tracks);
void set_keys(Document& document, const Track& track);
// Moves the camera to `camera` and sets its keyframe.
void set_camera_keys(Document& document, const Camera& camera);
void delete_keys(Document& document, std::span<const TrackKeys> keys);

// The parts of the scene that tracks are of, as they are at the start of a gesture.
std::vector<ScenePart> parts_of(const Scene& scene, std::span<const TrackKeys> keys);
// Moves keyframes in time; `parts` are as parts_of() says.
struct TrackMoves {
  Track track;
  std::vector<KeyMove> moves;
};
void move_keys(Document& document, std::vector<ScenePart> parts, std::span<const TrackMoves> moves,
               MergeId merge_id);
// Sets parts back to what they were at the start of a gesture, as its end.
void restore_parts(Document& document, std::vector<ScenePart> parts, MergeId gesture);
// Moves the keyframes to the document's time.
void align_keys(Document& document, std::span<const TrackKeys> keys);
// Moves keys of curves in time, and sets that number of each.
struct CurveKeyMove {
  Track track;
  CurveId curve;
  KeyMove time;
  double value;
};
void move_curve_keys(Document& document, std::vector<ScenePart> parts,
                     std::span<const CurveKeyMove> moves, MergeId merge_id);
void set_tangent(Document& document, const Track& track, const CurveId& curve,
                 const TangentEdit& edit, MergeId merge_id);
void set_interpolation(Document& document, std::span<const TrackKeys> keys,
                       Interpolation interpolation);
void set_tangents(Document& document, std::span<const TrackKeys> keys, Tangents tangents);

// Copied keyframes, with the parts of the scene that they were in.
struct CopiedKeys {
  std::vector<ScenePart> parts;
  std::vector<TrackKeys> keys;
};
CopiedKeys copy_keys(const Scene& scene, std::span<const TrackKeys> keys);
// Pastes keyframes into the tracks that they are from, the first at the document's time. Those of
// one track go into `chosen` ones instead, if there are any, as far as their values are of its
// types. Returns what was pasted.
std::vector<TrackKeys> paste_keys(Document& document, const CopiedKeys& copied,
                                  std::span<const Track> chosen);

// Sets the scene's camera, and its keyframe if it has any.
void set_scene_camera(Document& document, const Camera& camera, const QString& text);

}  // namespace brume
