#include "app/panels/time/dope_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>
#include <tuple>

namespace brume {
namespace {

// The time nearest to another in a sorted list is that one or the one before it.
bool has_time(const auto& sorted, double time, auto&& time_of) {
  const auto next = std::ranges::lower_bound(sorted, time, {}, time_of);
  const auto is_it = [&](const auto& other) {
    return is_same_key_time(std::invoke(time_of, other), time);
  };
  return (next != sorted.end() && is_it(*next)) || (next != sorted.begin() && is_it(*(next - 1)));
}

bool has_key(const std::vector<Keyframe>& keys, double time) {
  return has_time(keys, time, &Keyframe::time);
}

bool has_time(const std::vector<double>& times, double time) {
  return has_time(times, time, std::identity());
}

// Merges keyframes into others by time; of two at one time the first ones' stays.
void merge(std::vector<Keyframe>& keys, const std::vector<Keyframe>& others) {
  std::vector<Keyframe> all;
  all.reserve(keys.size() + others.size());
  std::ranges::merge(keys, others, std::back_inserter(all), {}, &Keyframe::time, &Keyframe::time);
  const auto is_same = [](const Keyframe& a, const Keyframe& b) {
    return is_same_key_time(a.time, b.time);
  };
  const auto doubled = std::ranges::unique(all, is_same);
  all.erase(doubled.begin(), doubled.end());
  keys = std::move(all);
}

QString heading(const Track& track) {
  return track.object.isEmpty() ? QCoreApplication::translate("DopeSheet", "Medium") : track.object;
}

DopeObject object_of(const Track& track) {
  return track.object.isEmpty() ? DopeObject{index_of<MediumOptics>(), 0}
                                : DopeObject{track.part, track.place};
}

// Values that are keyed jointly, such as where the camera is, have no name of their own.
QString value_text(const Track& track) {
  return track.value.isEmpty() ? QCoreApplication::translate("DopeSheet", "View") : track.value;
}

// An order of tracks.
auto order_of(const Track& track) {
  return std::tie(track.part, track.place, track.value);
}

bool is_before(const TrackKeys& keys, const Track& track) {
  return order_of(keys.track) < order_of(track);
}

}  // namespace

bool DopeRow::is_fixed() const {
  return std::ranges::all_of(tracks, [](const Track& track) { return track.count == 0; });
}

bool DopeRow::has_own_key(double time) const {
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    if (tracks[k].count > 0 && has_key(track_keys[k], time)) return true;
  }
  return false;
}

std::vector<DopeRow> dope_rows(const Scene& scene, std::vector<KeyedTrack> all,
                               const QString& filter, const std::set<DopeObject>& folded) {
  for (const Track& track : imported_tracks(scene)) {
    // Behind the keyframes of its surface, if that has any.
    const auto last = std::find_if(all.rbegin(), all.rend(), [&track](const KeyedTrack& other) {
      return other.track.part == track.part && other.track.place == track.place;
    });
    all.insert(last == all.rend() ? all.end() : last.base(),
               {track, keyframes_of(scene, track), {}});
  }
  std::erase_if(all, [&filter](const KeyedTrack& keyed) {
    const QString text = heading(keyed.track) + ' ' + value_text(keyed.track);
    return !text.contains(filter.trimmed(), Qt::CaseInsensitive);
  });
  std::vector<DopeRow> rows;
  std::size_t object_row = 0;
  for (const auto& [track, keys, values] : all) {
    const DopeObject object = object_of(track);
    if (rows.empty() || rows[object_row].object != object) {
      object_row = rows.size();
      rows.push_back({object, heading(track), true, {}, {}, {}});
    }
    rows[object_row].tracks.push_back(track);
    rows[object_row].track_keys.push_back(keys);
    merge(rows[object_row].keys, keys);
    if (folded.contains(object)) continue;
    rows.push_back({object, value_text(track), false, {track}, {keys}, keys});
  }
  return rows;
}

std::vector<TrackKeys>::const_iterator KeySelection::find(const Track& track) const {
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), track, is_before);
  return found != keys_.end() && found->track == track ? found : keys_.end();
}

bool KeySelection::contains(const Track& track, double time) const {
  const auto found = find(track);
  return found != keys_.end() && has_time(found->times, time);
}

bool KeySelection::contains(const DopeRow& row, double time) const {
  for (std::size_t k = 0; k < row.tracks.size(); ++k) {
    const Track& track = row.tracks[k];
    if (track.count > 0 && has_key(row.track_keys[k], time) && !contains(track, time)) return false;
  }
  return true;
}

void KeySelection::set(std::vector<TrackKeys> keys) {
  keys_ = std::move(keys);
  for (TrackKeys& track : keys_) std::ranges::sort(track.times);
  std::ranges::sort(keys_, {}, [](const TrackKeys& track) { return order_of(track.track); });
}

void KeySelection::add(const DopeRow& row, double time) {
  for (std::size_t k = 0; k < row.tracks.size(); ++k) {
    const Track& track = row.tracks[k];
    if (track.count == 0 || contains(track, time) || !has_key(row.track_keys[k], time)) continue;
    auto found = std::lower_bound(keys_.begin(), keys_.end(), track, is_before);
    if (found == keys_.end() || found->track != track) found = keys_.insert(found, {track, {}});
    found->times.insert(std::ranges::upper_bound(found->times, time), time);
  }
}

void KeySelection::remove(const DopeRow& row, double time) {
  for (TrackKeys& keys : keys_) {
    if (std::ranges::find(row.tracks, keys.track) == row.tracks.end()) continue;
    std::erase_if(keys.times, [time](double other) { return is_same_key_time(other, time); });
  }
  std::erase_if(keys_, [](const TrackKeys& keys) { return keys.times.empty(); });
}

void KeySelection::prune(const std::vector<KeyedTrack>& present) {
  std::vector<TrackKeys> kept;
  for (const auto& [track, keys, values] : present) {
    const auto found = find(track);
    if (found == keys_.end()) continue;
    TrackKeys still{track, {}};
    std::ranges::copy_if(found->times, std::back_inserter(still.times),
                         [&keys](double time) { return has_key(keys, time); });
    if (!still.times.empty()) kept.push_back(std::move(still));
  }
  set(std::move(kept));
}

void KeySelection::follow(const ObjectPlaces& places) {
  std::vector<TrackKeys> kept;
  for (TrackKeys& keys : keys_) {
    std::vector<Track> track{keys.track};
    follow_places(track, places);
    if (!track.empty()) kept.push_back({track.front(), std::move(keys.times)});
  }
  set(std::move(kept));
}

}  // namespace brume
