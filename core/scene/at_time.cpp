#include "core/scene/at_time.h"

#include "core/authoring/particles.h"
#include "core/scene/animation.h"

namespace brume {

bool is_animated(const Scene& scene) {
  return !scene.emitters.empty() || has_keys(scene);
}

double last_moment(const Scene& scene) {
  return last_key_time(scene);
}

Scene at_time(const Scene& scene, double time) {
  Scene result = scene;
  apply_keys(result, time);
  clear_keys(result);
  for (const Emitter& emitter : scene.emitters) {
    for (const Gaussian& gaussian : particles_at(emitter, time)) result.medium.append(gaussian);
  }
  result.emitters.clear();
  return result;
}

}  // namespace brume
