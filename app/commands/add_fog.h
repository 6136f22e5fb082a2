#pragma once

#include <span>

#include "core/authoring/fog_shapes.h"

namespace brume {

class Document;

// Where fog is added, and how large: sizes and densities follow from it, so that fog looks the same
// in a room and in a valley.
struct FogPlace {
  glm::dvec3 target{0.0};  // on the ground, or what is selected
  double size = 1.0;       // of what is in view there [u]
  glm::dvec3 eye{0.0};
  double headroom = 1e12;  // below what is above the target [u]
  FindGround find_ground;  // where the ground is
};

// Ready-made fog, each one step of undo; what it adds is selected.
struct FogPreset {
  const char* name;  // of its action
  const char* title;
  const char* hint;
  void (*add)(Document& document, const FogPlace& place);
};
std::span<const FogPreset> fog_presets();
void add_fog_preset(Document& document, const FogPreset& preset, const FogPlace& place);

// One step of undo, if the budget of Gaussians allows.
void add_fog_shape(Document& document, const FogShape& shape);

}  // namespace brume
