#pragma once

#include <QString>
#include <span>
#include <variant>

#include "app/commands/gaussians/operation_numbers.h"

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

// The numbers of ready-made fog.
using FogNumbers = std::variant<FogShape, FogColumn, EvenFog>;

// Ready-made fog, each one step of undo; what it adds is selected.
struct FogPreset {
  const char* name;  // of its action
  const char* title;
  const char* hint;
  FogNumbers (*numbers)(const Document& document, const FogPlace& place);  // that suit the place
  void (*add)(Document& document, const FogNumbers& numbers, const FogPlace& place);
};
std::span<const FogPreset> fog_presets();
void add_fog_preset(Document& document, const FogPreset& preset, const FogPlace& place);

// More would be slow to edit and to render.
inline constexpr double max_fog_cells = 50'000.0;
QString fog_problem(const FogShape& shape);  // empty: none

// One step of undo, if the budget of Gaussians allows. Both can be adjusted as the last operation.
void add_fog_shape(Document& document, const FogShape& shape);

}  // namespace brume
