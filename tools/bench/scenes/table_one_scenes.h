#pragma once

#include <array>

#include "brume/scene.h"

namespace brume {

// Scenes of the kinds that Table 1 of the paper times, with its numbers of vertices, Gaussians and
// lights, made in memory. The paper's own meshes and fogs are not published: shapes are ours. Where
// it has an environment, surfaces have radiance transfer with interreflection, and there is a point
// light besides for everything to be on; with the suffix _sky there is none, as in the paper.
// Frames of 800 x 600 as there.
struct TableOneScene {
  const char* name;
  Scene (*with_lights)();
  std::size_t vertices;
  std::size_t gaussians;
  double frames_per_second;  // the paper's
  bool has_lights = true;

  [[nodiscard]] Scene make() const;
};

Scene statue_scene();
Scene open_box_scene();
Scene terrain_scene();
Scene city_scene();
Scene machine_scene();

inline constexpr std::array table_one_scenes{
    TableOneScene{"statue", statue_scene, 78054, 34, 101.0},
    TableOneScene{"box", open_box_scene, 8901, 3008, 34.0},
    TableOneScene{"terrain", terrain_scene, 65047, 292, 92.0},
    TableOneScene{"city", city_scene, 77226, 353, 162.0},
    TableOneScene{"machine", machine_scene, 44430, 1223, 31.0},
    TableOneScene{"terrain_sky", terrain_scene, 65047, 292, 92.0, false},
    TableOneScene{"city_sky", city_scene, 77226, 353, 162.0, false},
    TableOneScene{"machine_sky", machine_scene, 44430, 1223, 31.0, false},
};

}  // namespace brume
