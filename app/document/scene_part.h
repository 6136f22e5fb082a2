#pragma once

#include <variant>

#include "core/scene/scene.h"

namespace brume {

// What of a scene is edited as a whole, the Gaussians being edited one by one.
using Lights = std::vector<PointLight>;
using Surfaces = std::vector<Surface>;
using Emitters = std::vector<Emitter>;
using Sequences = std::vector<MediumSequence>;
struct KeyedCamera {
  Camera camera;
  CameraKeys keys;

  bool operator==(const KeyedCamera&) const = default;
};
// The homogeneous density while it has keys; without, it is edited as the Gaussians are.
struct KeyedDensity {
  double density = 0.0;
  Keys<double> keys;

  bool operator==(const KeyedDensity&) const = default;
};
using ScenePart =
    std::variant<KeyedCamera, KeyedDensity, Lights, std::optional<Environment>, MediumOptics,
                 Surfaces, Emitters, Sequences, std::optional<Playback>>;

// The part of a scene that has an index of the variant; and a scene with another part.
ScenePart scene_part(const Scene& scene, std::size_t index);
void set_scene_part(Scene& scene, const ScenePart& part);

}  // namespace brume
