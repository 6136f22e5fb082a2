#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/document/scene_part.h"

namespace brume {

// A row of the timeline: what of a scene is keyed together.
struct KeyRow {
  QString title;         // "Light 1 position"
  std::size_t part = 0;  // index of ScenePart
  // Of the part's values that can have keys, in the order of core/scene/animation.h.
  std::size_t first = 0;
  std::size_t count = 1;
};

// All that can have keys; and of them those that have.
std::vector<KeyRow> key_rows(const Scene& scene);
std::vector<KeyRow> rows_with_keys(const Scene& scene);

// A moment at which values of a row have keys.
struct KeyMark {
  double time = 0.0;
  Interpolation interpolation = Interpolation::smooth;

  bool operator==(const KeyMark&) const = default;
};
std::vector<KeyMark> key_marks(const Scene& scene, const KeyRow& row);

// Changes of a part; each leaves it as it is where there is no such key.
// Keys of a row's values as they are, at a moment.
void set_keys(ScenePart& part, const KeyRow& row, double time);
void delete_keys(ScenePart& part, const KeyRow& row, double time);
// One that is there already at `to` gives way.
void move_keys(ScenePart& part, const KeyRow& row, double from, double to);
void set_interpolation(ScenePart& part, const KeyRow& row, double time,
                       Interpolation interpolation);

// Gives the part's values with keys those of a moment.
void apply_keys(ScenePart& part, double time);
// Where an edit has changed values that have keys, but not their keys: sets the keys of that
// moment.
void key_changes(const ScenePart& before, ScenePart& after, double time);

}  // namespace brume
