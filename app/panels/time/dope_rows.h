#pragma once

#include <QSet>
#include <QString>
#include <vector>

#include "app/document/keyframe_tracks.h"

namespace brume {

// A row of a dope sheet: an object with all its keyframes, or below it one of its values.
struct DopeRow {
  QString text;
  bool is_object = false;
  std::vector<Track> tracks;                      // of a value one
  std::vector<std::vector<Keyframe>> track_keys;  // by track
  std::vector<Keyframe> keys;                     // all of them by time, each time once

  [[nodiscard]] bool is_fixed() const;  // an imported animation, which stays as it is
};

// The rows of all values with keyframes whose titles contain a text, grouped by object. Values of
// folded objects have none.
std::vector<DopeRow> dope_rows(const Scene& scene, const QString& filter,
                               const QSet<QString>& folded);

// Chosen keyframes of several tracks.
class KeySelection {
 public:
  [[nodiscard]] bool contains(const Track& track, double time) const;
  // Whether all keyframes of a row at a time are chosen.
  [[nodiscard]] bool contains(const DopeRow& row, double time) const;
  [[nodiscard]] const std::vector<TrackKeys>& keys() const { return keys_; }
  [[nodiscard]] bool empty() const { return keys_.empty(); }
  void set(std::vector<TrackKeys> keys) { keys_ = std::move(keys); }
  // Those of a row at a time.
  void add(const DopeRow& row, double time);
  void remove(const DopeRow& row, double time);
  // Forgets keyframes that are no longer there.
  void prune(const Scene& scene);

 private:
  std::vector<TrackKeys> keys_;
};

}  // namespace brume
