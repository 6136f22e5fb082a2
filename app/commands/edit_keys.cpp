#include "app/commands/edit_keys.h"

#include "app/commands/scene_part_command.h"
#include "app/commands/undo_text.h"
#include "app/document/document.h"

namespace brume {
namespace {

QString in_sentence(const Track& row) {
  return row.title.toLower();
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
  ScenePart part = KeyedCamera{camera, document.scene().camera_keys};
  set_keys(part, row, document.time());
  push(document, std::move(part), undo_text("Set keyframe of %1").arg(in_sentence(row)));
}

void delete_keys(Document& document, const Track& row, double time) {
  ScenePart part = scene_part(document.scene(), row.part);
  delete_keys(part, row, time);
  push(document, std::move(part), undo_text("Delete keyframe of %1").arg(in_sentence(row)));
}

void move_keys(Document& document, const Track& row, const ScenePart& before, double old_time,
               double new_time, MergeId merge_id) {
  ScenePart part = before;
  move_keys(part, row, old_time, new_time);
  push(document, std::move(part), undo_text("Move keyframe of %1").arg(in_sentence(row)), merge_id);
}

void move_curve_key(Document& document, const Track& row, const Curve& curve,
                    const ScenePart& before, const CurveKeyMove& move, MergeId merge_id) {
  ScenePart part = before;
  if (move.new_time != move.old_time) move_keys(part, row, move.old_time, move.new_time);
  set_key_value(part, curve, move.new_time, move.value);
  push(document, std::move(part), undo_text("Move keyframe of %1").arg(in_sentence(row)), merge_id);
}

void set_interpolation(Document& document, const Track& row, double time,
                       Interpolation interpolation) {
  ScenePart part = scene_part(document.scene(), row.part);
  set_interpolation(part, row, time, interpolation);
  const QString text = interpolation == Interpolation::linear
                           ? undo_text("Make keyframe of %1 linear")
                           : undo_text("Make keyframe of %1 smooth");
  push(document, std::move(part), text.arg(in_sentence(row)));
}

void set_scene_camera(Document& document, const Camera& camera, const QString& text) {
  set_scene_part(document, KeyedCamera{camera, document.scene().camera_keys}, text);
}

}  // namespace brume
