#pragma once

#include "brume/scene.h"
#include "core/number_domain.h"
#include "core/scene/fields/camera_fields.h"
#include "core/scene/fields/emitter_fields.h"
#include "core/scene/fields/environment_fields.h"
#include "core/scene/fields/group_fields.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/fields/material_fields.h"
#include "core/scene/fields/medium_fields.h"

namespace brume {

// Keyframed values of a scene (brume/keys.h). Each visit_ function, and visit_keyed() of the types
// in core/scene/fields, calls visit(name, value, keys, domain) for every animatable value of an
// object; `name` is its key in the scene file.

template <class S>
void visit_keyed_surface(S& surface, auto&& visit) {
  auto& keys = surface.keys;
  visit("translate", surface.translate, keys.translate, domain::coordinate);
  visit("rotate", surface.rotate, keys.rotate, domain::coordinate);
  visit("scale", surface.scale, keys.scale, domain::length);
  visit_keyed(surface.material, keys, visit);
}

// With those of its sky.
template <class E>
void visit_keyed_environment(E& environment, auto&& visit) {
  visit_keyed(environment, visit);
  if (environment.sky) visit_keyed(*environment.sky, visit);
}

template <class D, class K>
void visit_keyed_density(D& homogeneous_density, K& keys, auto&& visit) {
  visit("density", homogeneous_density, keys, domain::density);
}

// Whether any value has keyframes, of cameras that are not in use, too, or an imported scene moves.
bool has_keys(const Scene& scene);
// Time of the last keyframe, of imported scenes too, at least 0 [s].
double last_key_time(const Scene& scene);

// Evaluates all keyframed values at a time [s], of cameras that are not in use, too. If a camera's
// eye and target coincide, it looks along -z.
void apply_keys(Scene& scene, double time);

void clear_keys(Scene& scene);

}  // namespace brume
