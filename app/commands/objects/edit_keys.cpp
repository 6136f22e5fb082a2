#include "app/commands/objects/edit_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/commands/objects/edit_cameras.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"
#include "app/document/text/words.h"

namespace brume {
namespace {

const Track& track_of(const Track& track) {
  return track;
}
const Track& track_of(const auto& keys) {
  return keys.track;
}

// "light 1 position", or "3 values".
QString tracks_text(const auto& tracks) {
  const Track& first = track_of(tracks.front());
  const auto is_other = [&first](const auto& keys) { return track_of(keys) != first; };
  if (std::ranges::none_of(tracks, is_other)) return in_sentence(first.title());
  return undo_text("%n value(s)", static_cast<int>(tracks.size()));
}

std::size_t count_of(std::span<const TrackKeys> keys) {
  std::size_t count = 0;
  for (const TrackKeys& track : keys) count += track.times.size();
  return count;
}

std::vector<ScenePart> parts_of_tracks(const Scene& scene, const auto& tracks) {
  std::vector<ScenePart> parts;
  for (const auto& keys : tracks) {
    const std::size_t index = track_of(keys).part;
    const auto is_it = [index](const ScenePart& part) { return part.index() == index; };
    if (std::ranges::none_of(parts, is_it)) parts.push_back(scene_part(scene, index));
  }
  return parts;
}

// The part that a track is of, which is among them.
ScenePart& part_of(std::vector<ScenePart>& parts, const Track& track) {
  return *std::ranges::find_if(
      parts, [&track](const ScenePart& part) { return part.index() == track.part; });
}

void push(Document& document, std::vector<ScenePart> parts, const QString& text,
          MergeId merge_id = no_merge) {
  // So that what keys do to the values is not taken for an edit of them.
  for (ScenePart& part : parts) apply_keys(part, document.time());
  set_scene_parts(document, std::move(parts), text, merge_id);
}

// Calls edit(part, keys) for each track, as one step.
void edit_tracks(Document& document, std::span<const TrackKeys> keys, const QString& text,
                 const auto& edit) {
  if (keys.empty()) return;
  std::vector<ScenePart> parts = parts_of(document.scene(), keys);
  for (const TrackKeys& track : keys) edit(part_of(parts, track.track), track);
  push(document, std::move(parts), text.arg(tracks_text(keys)));
}

QString move_text(const auto& tracks, std::size_t count) {
  return undo_text("Move keyframe(s) of %1", static_cast<int>(count)).arg(tracks_text(tracks));
}

}  // namespace

void set_keys(Document& document, std::span<const Track> tracks) {
  if (tracks.empty()) return;
  std::vector<ScenePart> parts = parts_of_tracks(document.scene(), tracks);
  for (const Track& track : tracks) set_keys(part_of(parts, track), track, document.time());
  push(document, std::move(parts), undo_text("Set keyframe of %1").arg(tracks_text(tracks)));
}

void set_keys(Document& document, const Track& track) {
  set_keys(document, std::span(&track, 1));
}

void set_camera_keys(Document& document, const Camera& camera) {
  const std::array track{tracks(document.scene()).front()};
  ScenePart part = keyed_camera(document, camera);
  set_keys(part, track[0], document.time());
  push(document, {std::move(part)}, undo_text("Set keyframe of %1").arg(tracks_text(track)));
}

void delete_keys(Document& document, std::span<const TrackKeys> keys) {
  edit_tracks(
      document, keys, undo_text("Delete keyframe(s) of %1", static_cast<int>(count_of(keys))),
      [](ScenePart& part, const TrackKeys& track) { delete_keys(part, track.track, track.times); });
}

std::vector<ScenePart> parts_of(const Scene& scene, std::span<const TrackKeys> keys) {
  return parts_of_tracks(scene, keys);
}

void move_keys(Document& document, std::vector<ScenePart> parts, std::span<const TrackMoves> moves,
               MergeId merge_id) {
  if (moves.empty()) return;
  std::size_t count = 0;
  for (const TrackMoves& track : moves) {
    move_keys(part_of(parts, track.track), track.track, track.moves);
    count += track.moves.size();
  }
  push(document, std::move(parts), move_text(moves, count), merge_id);
}

void restore_parts(Document& document, std::vector<ScenePart> parts, MergeId gesture) {
  push(document, std::move(parts), {}, gesture);
}

void align_keys(Document& document, std::span<const TrackKeys> keys) {
  std::vector<TrackMoves> moves;
  for (const TrackKeys& track : keys) {
    TrackMoves& aligned = moves.emplace_back(TrackMoves{track.track, {}});
    for (const double time : track.times) aligned.moves.push_back({time, document.time()});
  }
  move_keys(document, parts_of(document.scene(), keys), moves, no_merge);
}

void move_curve_keys(Document& document, std::vector<ScenePart> parts,
                     std::span<const CurveKeyMove> moves, MergeId merge_id) {
  std::vector<TrackMoves> in_time;
  for (const CurveKeyMove& move : moves) {
    auto track = std::ranges::find(in_time, move.track, &TrackMoves::track);
    if (track == in_time.end()) track = in_time.insert(track, {move.track, {}});
    track->moves.push_back(move.time);
  }
  if (in_time.empty()) return;
  std::size_t count = 0;
  for (TrackMoves& track : in_time) {
    // One move is that of the key of all its numbers.
    std::ranges::stable_sort(track.moves, {}, &KeyMove::from);
    const auto others = std::ranges::unique(track.moves, [](const KeyMove& a, const KeyMove& b) {
      return is_same_key_time(a.from, b.from);
    });
    track.moves.erase(others.begin(), others.end());
    count += track.moves.size();
    move_keys(part_of(parts, track.track), track.track, track.moves);
  }
  for (const CurveKeyMove& move : moves) {
    set_key_value(part_of(parts, move.track), move.curve, move.time.to, move.value);
  }
  push(document, std::move(parts), move_text(in_time, count), merge_id);
}

void set_tangent(Document& document, const Track& track, const CurveId& curve,
                 const TangentEdit& edit, MergeId merge_id) {
  ScenePart part = scene_part(document.scene(), track.part);
  set_tangent(part, curve, edit);
  push(document, {std::move(part)},
       undo_text("Set tangent of %1").arg(tracks_text(std::array{track})), merge_id);
}

void set_interpolation(Document& document, std::span<const TrackKeys> keys,
                       Interpolation interpolation) {
  static constexpr std::array texts{QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 smooth"),
                                    QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 linear"),
                                    QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 constant")};
  edit_tracks(document, keys, undo_text(texts.at(static_cast<std::size_t>(interpolation))),
              [interpolation](ScenePart& part, const TrackKeys& track) {
                set_interpolation(part, track.track, track.times, interpolation);
              });
}

void set_tangents(Document& document, std::span<const TrackKeys> keys, Tangents tangents) {
  static constexpr std::array texts{QT_TRANSLATE_NOOP("Undo", "Make tangents of %1 automatic"),
                                    QT_TRANSLATE_NOOP("Undo", "Align tangents of %1"),
                                    QT_TRANSLATE_NOOP("Undo", "Make tangents of %1 free")};
  edit_tracks(document, keys, undo_text(texts.at(static_cast<std::size_t>(tangents))),
              [tangents](ScenePart& part, const TrackKeys& track) {
                set_tangents(part, track.track, track.times, tangents);
              });
}

CopiedKeys copy_keys(const Scene& scene, std::span<const TrackKeys> keys) {
  return {parts_of(scene, keys), {keys.begin(), keys.end()}};
}

std::vector<TrackKeys> paste_keys(Document& document, const CopiedKeys& copied,
                                  std::span<const Track> chosen) {
  std::vector<ScenePart> sources = copied.parts;
  double first = std::numeric_limits<double>::infinity();
  for (const TrackKeys& track : copied.keys) first = std::min(first, std::ranges::min(track.times));
  std::vector<TrackKeys> pasted;
  std::vector<const TrackKeys*> pasted_from;
  const auto add = [&](const TrackKeys& source, const Track& track) {
    pasted.push_back({track, {}});
    pasted_from.push_back(&source);
    for (const double time : source.times) {
      pasted.back().times.push_back(time - first + document.time());
    }
  };
  const std::vector<Track> all = tracks(document.scene());
  for (const TrackKeys& source : copied.keys) {
    if (copied.keys.size() == 1 && !chosen.empty()) {
      for (const Track& track : chosen) add(source, track);
    } else if (const auto found = std::ranges::find(all, source.track); found != all.end()) {
      add(source, *found);
    }
  }
  if (pasted.empty()) return {};
  std::vector<ScenePart> parts = parts_of(document.scene(), pasted);
  for (std::size_t k = 0; k < pasted.size(); ++k) {
    const TrackKeys& source = *pasted_from[k];
    std::vector<KeyMove> moves;
    for (std::size_t i = 0; i < source.times.size(); ++i) {
      moves.push_back({source.times[i], pasted[k].times[i]});
    }
    paste_keys(part_of(parts, pasted[k].track), pasted[k].track, part_of(sources, source.track),
               source.track, moves);
  }
  push(document, std::move(parts), undo_text("Paste keyframes of %1").arg(tracks_text(pasted)));
  return pasted;
}

void set_scene_camera(Document& document, const Camera& camera, const QString& text) {
  set_scene_part(document, keyed_camera(document, camera), text);
}

}  // namespace brume
