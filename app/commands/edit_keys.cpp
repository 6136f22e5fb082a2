#include "app/commands/edit_keys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/commands/edit_cameras.h"
#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {
namespace {

QString in_sentence(const Track& row) {
  return row.title.toLower();
}

QString move_text(const Track& row, std::size_t count) {
  return (count > 1 ? undo_text("Move keyframes of %1") : undo_text("Move keyframe of %1"))
      .arg(in_sentence(row));
}

void push(Document& document, ScenePart part, const QString& text, MergeId merge_id = no_merge) {
  // So that what keys do to the values is not taken for an edit of them.
  apply_keys(part, document.time());
  set_scene_part(document, std::move(part), text, merge_id);
}

}  // namespace

void set_keys(Document& document, const Track& row) {
  ScenePart part = scene_part(document.scene(), row.part);
  set_keys(part, row, document.time());
  push(document, std::move(part), undo_text("Set keyframe of %1").arg(in_sentence(row)));
}

void set_camera_keys(Document& document, const Camera& camera) {
  const Track row = tracks(document.scene()).front();
  ScenePart part = keyed_camera(document, camera);
  set_keys(part, row, document.time());
  push(document, std::move(part), undo_text("Set keyframe of %1").arg(in_sentence(row)));
}

void delete_keys(Document& document, const Track& row, std::span<const double> times) {
  ScenePart part = scene_part(document.scene(), row.part);
  delete_keys(part, row, times);
  push(document, std::move(part),
       (times.size() > 1 ? undo_text("Delete keyframes of %1") : undo_text("Delete keyframe of %1"))
           .arg(in_sentence(row)));
}

void move_keys(Document& document, const Track& row, const ScenePart& before,
               std::span<const KeyMove> moves, MergeId merge_id) {
  ScenePart part = before;
  move_keys(part, row, moves);
  push(document, std::move(part), move_text(row, moves.size()), merge_id);
}

void align_keys(Document& document, const Track& row, std::span<const double> times) {
  ScenePart part = scene_part(document.scene(), row.part);
  std::vector<KeyMove> moves;
  for (const double time : times) moves.push_back({time, document.time()});
  move_keys(part, row, moves);
  push(document, std::move(part), move_text(row, moves.size()));
}

void move_curve_keys(Document& document, const Track& row, const ScenePart& before,
                     std::span<const CurveKeyMove> moves, MergeId merge_id) {
  ScenePart part = before;
  std::vector<KeyMove> in_time;
  for (const CurveKeyMove& move : moves) {
    // One for the key of all its numbers.
    const bool is_known = std::ranges::any_of(in_time, [&move](const KeyMove& other) {
      return std::abs(other.from - move.time.from) < min_key_distance;
    });
    if (!is_known) in_time.push_back(move.time);
  }
  move_keys(part, row, in_time);
  for (const CurveKeyMove& move : moves) set_key_value(part, move.curve, move.time.to, move.value);
  push(document, std::move(part), move_text(row, in_time.size()), merge_id);
}

void set_tangent(Document& document, const Track& row, const CurveId& curve,
                 const TangentEdit& edit, MergeId merge_id) {
  ScenePart part = scene_part(document.scene(), row.part);
  set_tangent(part, curve, edit);
  push(document, std::move(part), undo_text("Set tangent of %1").arg(in_sentence(row)), merge_id);
}

void set_interpolation(Document& document, const Track& row, std::span<const double> times,
                       Interpolation interpolation) {
  ScenePart part = scene_part(document.scene(), row.part);
  set_interpolation(part, row, times, interpolation);
  static constexpr std::array texts{QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 smooth"),
                                    QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 linear"),
                                    QT_TRANSLATE_NOOP("Undo", "Make keyframe of %1 constant")};
  push(document, std::move(part),
       undo_text(texts.at(static_cast<std::size_t>(interpolation))).arg(in_sentence(row)));
}

void set_tangents(Document& document, const Track& row, std::span<const double> times,
                  Tangents tangents) {
  ScenePart part = scene_part(document.scene(), row.part);
  set_tangents(part, row, times, tangents);
  static constexpr std::array texts{QT_TRANSLATE_NOOP("Undo", "Make tangents of %1 automatic"),
                                    QT_TRANSLATE_NOOP("Undo", "Align tangents of %1"),
                                    QT_TRANSLATE_NOOP("Undo", "Make tangents of %1 free")};
  push(document, std::move(part),
       undo_text(texts.at(static_cast<std::size_t>(tangents))).arg(in_sentence(row)));
}

void set_scene_camera(Document& document, const Camera& camera, const QString& text) {
  set_scene_part(document, keyed_camera(document, camera), text);
}

}  // namespace brume
