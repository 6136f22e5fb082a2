#pragma once

#include <QString>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/document/object_places.h"
#include "app/document/scene_part.h"

namespace brume {

// A track of the timeline: values that are keyframed together.
struct Track {
  QString object;        // whose values they are, as lists call it: "key", "Camera"; or empty
  QString value;         // "Position"; empty for values that are keyed jointly
  std::size_t part = 0;  // index of ScenePart
  // Range of the part's animatable values, in the order of core/scene/animation/animation.h.
  std::size_t first = 0;
  std::size_t count = 1;  // 0: the animation of an imported scene, which stays as it is
  std::size_t place = 0;  // where its object is among the part's

  [[nodiscard]] QString title() const;  // "key position"
  // Whether it has the part's animatable value of an index.
  [[nodiscard]] bool has_value(std::size_t index) const { return index - first < count; }
  // Whether it is of the same value of the same object, which may have another name by now, and
  // its values another place in the part.
  bool operator==(const Track& other) const;
};

// Gives tracks of a part the places that objects have now; those of objects that went are gone.
void follow_places(std::vector<Track>& tracks, const ObjectPlaces& places);

// Some keyframes of a track, by their times [s].
struct TrackKeys {
  Track track;
  std::vector<double> times;
};

// All tracks.
std::vector<Track> tracks(const Scene& scene);
// The rows of surfaces whose imported scenes move by themselves.
std::vector<Track> imported_tracks(const Scene& scene);
// The track of one value, by its name in files, of an object of a part: a light, a group, an
// emitter, a surface by its index; of the medium noise is the second. The density has no name.
Track value_track(const Scene& scene, std::size_t part, std::size_t object, std::string_view name);
template <class Part>
Track value_track(const Scene& scene, std::string_view name, std::size_t object = 0) {
  return value_track(scene, index_of<Part>(), object, name);
}

// Who chooses the slopes of a smooth curve at a key: nobody, the user one for both sides, or one
// for each.
enum class Tangents { automatic, aligned, free };
template <class T>
Tangents tangents_of(const Key<T>& key) {
  if (!key.in && !key.out) return Tangents::automatic;
  return key.aligned ? Tangents::aligned : Tangents::free;
}

// A keyframe of a track.
struct Keyframe {
  double time = 0.0;
  Interpolation interpolation = Interpolation::smooth;
  Tangents tangents = Tangents::automatic;

  bool operator==(const Keyframe&) const = default;
};
std::vector<Keyframe> keyframes_of(const Scene& scene, const Track& row);  // by time

// Whether two moments are one to keyframes [s].
inline bool is_same_key_time(double a, double b) {
  return std::abs(a - b) < min_key_distance;
}

// A track with its keyframes by time; those with any.
struct KeyedTrack {
  Track track;
  std::vector<Keyframe> keys;
  std::vector<std::size_t> values;  // those of the part's that have keys
};
std::vector<KeyedTrack> keyed_tracks(const Scene& scene);

// Whether its curves may have tangents: those of rotations have none.
bool may_have_tangents(const Scene& scene, const Track& row);

// Edits of a part's keyframes at some times; no effect without such a key.
//
// Sets keys from the track's current values at a time. A key that is there keeps its tangents.
void set_keys(ScenePart& part, const Track& row, double time);
void delete_keys(ScenePart& part, const Track& row, std::span<const double> times);
// Replaces keys that are where others go; of several that go to one place the last stays.
struct KeyMove {
  double from;  // [s]
  double to;
};
void move_keys(ScenePart& part, const Track& row, std::span<const KeyMove> moves);
// Copies keys from a track of a part, which may be another one with values of the same types: they
// are brought into its domains, without their tangents if they come from other ones.
void paste_keys(ScenePart& part, const Track& row, const ScenePart& copied, const Track& copied_row,
                std::span<const KeyMove> moves);
void set_interpolation(ScenePart& part, const Track& row, std::span<const double> times,
                       Interpolation interpolation);
// Makes them smooth. Tangents begin as the automatic slopes; aligned ones as the mean of what they
// were.
void set_tangents(ScenePart& part, const Track& row, std::span<const double> times,
                  Tangents tangents);

// Evaluates the part's keyframed values at a time.
void apply_keys(ScenePart& part, double time);
// Sets keys at a time for keyframed values that an edit has changed without changing their keys.
void key_changes(const ScenePart& before, ScenePart& after, double time);

}  // namespace brume
