#pragma once

#include <QString>
#include <set>
#include <vector>

#include "app/document/time/keyframe_tracks.h"

namespace brume {

// An object of the dope sheet: a part of the scene, and the object's place in it. The values of the
// medium are those of one object.
struct DopeObject {
  std::size_t part = 0;
  std::size_t place = 0;

  auto operator<=>(const DopeObject&) const = default;
};

// A row of a dope sheet: an object with all its keyframes, or below it one of its values.
struct DopeRow {
  DopeObject object;
  QString text;
  bool is_object = false;
  std::vector<Track> tracks;                      // a value's row has one
  std::vector<std::vector<Keyframe>> track_keys;  // by track
  std::vector<Keyframe> keys;                     // all of them by time, each time once

  [[nodiscard]] bool is_fixed() const;  // an imported animation, which stays as it is
  // Whether an edit may change the keyframe at a time: none of an imported animation alone.
  [[nodiscard]] bool has_own_key(double time) const;
};

// The rows of a scene's values with keyframes, which are `keyed`, and of imported animations, whose
// titles contain a text, grouped by object. Values of folded objects have none.
std::vector<DopeRow> dope_rows(const Scene& scene, std::vector<KeyedTrack> keyed,
                               const QString& filter, const std::set<DopeObject>& folded);

// Chosen keyframes of several tracks.
class KeySelection {
 public:
  [[nodiscard]] bool contains(const Track& track, double time) const;
  // Whether all keyframes of a row at a time are chosen, but for those of imported animations.
  [[nodiscard]] bool contains(const DopeRow& row, double time) const;
  [[nodiscard]] const std::vector<TrackKeys>& keys() const { return keys_; }
  [[nodiscard]] bool empty() const { return keys_.empty(); }
  void set(std::vector<TrackKeys> keys);
  // These choose the keyframes of a row at a time, or no longer.
  void add(const DopeRow& row, double time);
  void remove(const DopeRow& row, double time);
  // Forgets keyframes that are no longer there, and takes tracks as they are now.
  void prune(const std::vector<KeyedTrack>& present);
  // Follows objects that are elsewhere in their part.
  void follow(const ObjectPlaces& places);

 private:
  // Its keys in keys_; end() if none is chosen.
  [[nodiscard]] std::vector<TrackKeys>::const_iterator find(const Track& track) const;

  std::vector<TrackKeys> keys_;  // by part, place and value; their times in order
};

}  // namespace brume
