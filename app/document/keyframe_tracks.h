#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/document/scene_part.h"

namespace brume {

// A track of the timeline: values that are keyframed together.
struct Track {
  QString title;         // "Light 1 position"
  std::size_t part = 0;  // index of ScenePart
  // Range of the part's animatable values, in the order of core/scene/animation.h.
  std::size_t first = 0;
  std::size_t count = 1;
};

// All tracks; and those with keyframes.
std::vector<Track> tracks(const Scene& scene);
std::vector<Track> tracks_with_keys(const Scene& scene);

// A keyframe of a track.
struct Keyframe {
  double time = 0.0;
  Interpolation interpolation = Interpolation::smooth;

  bool operator==(const Keyframe&) const = default;
};
std::vector<Keyframe> keyframes_of(const Scene& scene, const Track& row);

// Edits of a part's keyframes; no effect without such a key.
//
// Sets keys from the track's current values at a time.
void set_keys(ScenePart& part, const Track& row, double time);
void delete_keys(ScenePart& part, const Track& row, double time);
// Replaces a key at `new_time`.
void move_keys(ScenePart& part, const Track& row, double old_time, double new_time);
void set_interpolation(ScenePart& part, const Track& row, double time, Interpolation interpolation);

// Evaluates the part's keyframed values at a time.
void apply_keys(ScenePart& part, double time);
// Sets keys at a time for keyframed values that an edit has changed without changing their keys.
void key_changes(const ScenePart& before, ScenePart& after, double time);

}  // namespace brume
