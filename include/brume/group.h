#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "brume/gaussian.h"
#include "brume/keys.h"
#include "brume/object_id.h"

namespace brume {

// Keyframes of a group's values; see core/scene/animation/animation.h.
struct GroupKeys {
  Keys<double> density_factor;
  Keys<double> density_offset;
  Keys<double> radius_factor;
  Keys<double> radius_offset;
  Keys<glm::dvec3> albedo_factor;
  Keys<glm::dvec3> albedo_offset;

  bool operator==(const GroupKeys&) const = default;
};

// A group of Gaussians, which have its id: named, and changed together without losing their own
// values. What is rendered has density * factor + offset, and so on, the parent's after the
// group's; evaluated by core/scene/group_effects.h.
struct Group {
  GroupId id = 0;                 // of one scene, > 0
  std::string name{};             // not empty, of one scene
  glm::dvec3 color{0.5};          // of its handles in the editor, linear RGB in [0, 1]
  GroupId parent = 0;             // a group without a parent; 0: none
  bool visible = true;            // else no frame has its Gaussians, nor those of groups in it
  bool locked = false;            // the editor selects and erases none of them
  double density_factor = 1.0;    // >= 0
  double density_offset = 0.0;    // [1/u]
  double radius_factor = 1.0;     // > 0
  double radius_offset = 0.0;     // [u]
  glm::dvec3 albedo_factor{1.0};  // RGB, >= 0
  glm::dvec3 albedo_offset{0.0};  // RGB, in [-1, 1]
  GroupKeys keys{};
  ObjectId object_id = 0;  // of what its scene file has besides

  bool operator==(const Group&) const = default;
};

}  // namespace brume
