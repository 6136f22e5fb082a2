#pragma once

#include <variant>

#include "brume/scene.h"

namespace brume {

// Parts of a scene that are edited as a whole, unlike Gaussians.
using Cameras =
    std::vector<NamedCamera>;  // those not in use: they neither come, go nor change places
using Lights = std::vector<Light>;
using Surfaces = std::vector<Surface>;
using Emitters = std::vector<Emitter>;
using Sequences = std::vector<MediumSequence>;
using Groups = std::vector<Group>;
using Splines = std::vector<PaintedSpline>;
struct KeyedCamera {
  Camera camera;
  CameraKeys keys;

  bool operator==(const KeyedCamera&) const = default;
};
// The homogeneous density if keyframed; otherwise it is edited by MediumEdit.
struct KeyedDensity {
  double density = 0.0;
  Keys<double> keys;

  bool operator==(const KeyedDensity&) const = default;
};
// All cameras, with their keys.
struct CameraList {
  NamedCamera in_use;
  std::vector<NamedCamera> others;

  bool operator==(const CameraList&) const = default;
};
using ScenePart =
    std::variant<KeyedCamera, KeyedDensity, CameraList, Lights, std::optional<Environment>,
                 MediumOptics, Surfaces, Emitters, Sequences, std::optional<Playback>, Film, Output,
                 Groups, Splines, Cameras>;

template <class T>
std::size_t index_of() {
  return ScenePart(T{}).index();
}

// Reads the scene part of a variant index; and replaces a part.
ScenePart scene_part(const Scene& scene, std::size_t index);
void set_scene_part(Scene& scene, const ScenePart& part);

}  // namespace brume
