#include "app/panels/time/dope_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace brume {
namespace {

bool is_same_time(double a, double b) {
  return std::abs(a - b) < min_key_distance;
}

bool has_key(const std::vector<Keyframe>& keys, double time) {
  return std::ranges::any_of(keys,
                             [time](const Keyframe& key) { return is_same_time(key.time, time); });
}

// Merges keyframes into others by time.
void merge(std::vector<Keyframe>& keys, const std::vector<Keyframe>& others) {
  if (keys.empty()) keys = others;
  for (const Keyframe& key : others) {
    if (!has_key(keys, key.time)) keys.push_back(key);
  }
  std::ranges::sort(keys, {}, &Keyframe::time);
}

QString heading(const Track& track) {
  return track.object.isEmpty() ? QCoreApplication::translate("DopeSheet", "Medium") : track.object;
}

// Values that are keyed jointly, such as where the camera is, have no name of their own.
QString value_text(const Track& track) {
  return track.value.isEmpty() ? QCoreApplication::translate("DopeSheet", "View") : track.value;
}

}  // namespace

bool DopeRow::is_fixed() const {
  return std::ranges::all_of(tracks, [](const Track& track) { return track.count == 0; });
}

std::vector<DopeRow> dope_rows(const Scene& scene, const QString& filter,
                               const QSet<QString>& folded) {
  std::vector<Track> all = tracks_with_keys(scene);
  for (const Track& track : imported_tracks(scene)) {
    // Behind the keyframes of its surface, if that has any.
    const auto last = std::find_if(all.rbegin(), all.rend(),
                                   [&track](const Track& other) { return other.ref == track.ref; });
    all.insert(last == all.rend() ? all.end() : last.base(), track);
  }
  std::erase_if(all, [&filter](const Track& track) {
    const QString text = heading(track) + ' ' + value_text(track);
    return !text.contains(filter.trimmed(), Qt::CaseInsensitive);
  });
  std::vector<DopeRow> rows;
  std::size_t object = 0;  // its row
  for (const Track& track : all) {
    const QString title = heading(track);
    if (rows.empty() || rows[object].text != title) {
      object = rows.size();
      rows.push_back({title, true, {}, {}, {}});
    }
    const std::vector<Keyframe> keys = keyframes_of(scene, track);
    rows[object].tracks.push_back(track);
    rows[object].track_keys.push_back(keys);
    merge(rows[object].keys, keys);
    if (!folded.contains(title)) rows.push_back({value_text(track), false, {track}, {keys}, keys});
  }
  return rows;
}

bool KeySelection::contains(const Track& track, double time) const {
  const auto found = std::ranges::find(keys_, track, &TrackKeys::track);
  return found != keys_.end() && std::ranges::any_of(found->times, [time](double other) {
           return is_same_time(other, time);
         });
}

bool KeySelection::contains(const DopeRow& row, double time) const {
  for (std::size_t k = 0; k < row.tracks.size(); ++k) {
    if (!contains(row.tracks[k], time) && has_key(row.track_keys[k], time)) return false;
  }
  return true;
}

void KeySelection::add(const DopeRow& row, double time) {
  for (std::size_t k = 0; k < row.tracks.size(); ++k) {
    const Track& track = row.tracks[k];
    if (track.count == 0 || contains(track, time) || !has_key(row.track_keys[k], time)) continue;
    auto found = std::ranges::find(keys_, track, &TrackKeys::track);
    if (found == keys_.end()) found = keys_.insert(found, {track, {}});
    found->times.push_back(time);
  }
}

void KeySelection::remove(const DopeRow& row, double time) {
  for (TrackKeys& keys : keys_) {
    if (std::ranges::find(row.tracks, keys.track) == row.tracks.end()) continue;
    std::erase_if(keys.times, [time](double other) { return is_same_time(other, time); });
  }
  std::erase_if(keys_, [](const TrackKeys& keys) { return keys.times.empty(); });
}

void KeySelection::prune(const Scene& scene) {
  if (keys_.empty()) return;
  const std::vector<Track> all = tracks_with_keys(scene);
  std::erase_if(keys_, [&](TrackKeys& keys) {
    if (std::ranges::find(all, keys.track) == all.end()) return true;
    const std::vector<Keyframe> present = keyframes_of(scene, keys.track);
    std::erase_if(keys.times, [&present](double time) { return !has_key(present, time); });
    return keys.times.empty();
  });
}

}  // namespace brume
