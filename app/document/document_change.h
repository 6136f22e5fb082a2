#pragma once

#include <QFlags>

namespace brume {

class MediumEdit;
struct ObjectPlaces;

enum class Change : unsigned {
  scene = 1u << 0,   // another one was opened
  medium = 1u << 1,  // the Gaussians
  part = 1u << 2,    // a part of the scene other than the Gaussians
  groups = 1u << 3,  // their values, or what they do at another time
  splines = 1u << 4,
  selection = 1u << 5,
  hidden_or_locked = 1u << 6,  // Gaussians that are
  object = 1u << 7,            // the object that keys and handles act on
  active_light = 1u << 8,
  active_emitter = 1u << 9,
  active_group = 1u << 10,
  active_spline = 1u << 11,
  file = 1u << 12,      // where the scene is saved, or its version
  modified = 1u << 13,  // whether it differs from the file, or the file is missing
  time = 1u << 14,  // with a part or groups: they have the values of another time, no other keys
};
Q_DECLARE_FLAGS(Changes, Change)
Q_DECLARE_OPERATORS_FOR_FLAGS(Changes)

// A change of a document.
struct DocumentChange {
  Changes what;
  const MediumEdit* edit = nullptr;      // of Change::medium; else null
  const ObjectPlaces* places = nullptr;  // of a part whose objects have other places; else null
};

}  // namespace brume
