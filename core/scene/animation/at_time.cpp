#include "brume/at_time.h"

#include <algorithm>
#include <cmath>

#include "brume/edits.h"
#include "brume/limits.h"
#include "core/number_domain.h"
#include "core/scene/animation/animation.h"
#include "core/scene/animation/keys_in_domain.h"
#include "core/scene/animation/particles.h"
#include "core/scene/group_effects.h"
#include "core/scene/imported_scene.h"
#include "core/scene/lights/sky.h"

namespace brume {

bool is_animated(const Scene& scene) {
  const Noise& noise = scene.optics.noise;
  const bool has_wind = noise.amplitude > 0.0 && noise.velocity != glm::dvec3(0.0);
  return !scene.emitters.empty() || !scene.sequences.empty() || has_wind || has_keys(scene);
}

double last_moment(const Scene& scene) {
  double last = last_key_time(scene);
  for (const MediumSequence& sequence : scene.sequences) last = std::max(last, end_of(sequence));
  return last;
}

double frame_rate(const Scene& scene) {
  return scene.playback ? scene.playback->frames_per_second : default_frame_rate;
}

void set_frame_rate(Scene& scene, double rate) {
  if (!scene.playback) {
    const double last = std::ceil(last_moment(scene) * rate - 1e-6);
    scene.playback = Playback{0, static_cast<int>(std::clamp<double>(last, 0.0, limits::frame))};
  }
  scene.playback->frames_per_second = rate;
}

std::size_t gaussian_count(const Scene& scene) {
  std::size_t count = scene.medium.size();
  for (const Emitter& emitter : scene.emitters) count += max_particles(emitter);
  for (const MediumSequence& sequence : scene.sequences) count += gaussian_count(sequence);
  return count;
}

bool has_constant_groups(const Scene& scene) {
  return scene.optics.keys.albedo.empty() &&
         std::ranges::all_of(scene.groups,
                             [](const Group& group) { return group.keys == GroupKeys(); });
}

void apply_groups(Scene& scene) {
  const GroupEffects effects(scene.groups);
  scene.groups.clear();
  Medium& medium = scene.medium;
  medium = with_effects(medium, effects, scene.optics.albedo);
  MediumEdit::remove(medium, hidden_by_groups(medium, effects)).apply(medium);
}

Scene evaluate_at(const Scene& scene, double time) {
  Scene result = scene;
  result.time = time;
  apply_keys(result, time);
  Noise& noise = result.optics.noise;
  // Noise drifts by velocity * time: the mean velocity gives the way that the wind has gone.
  if (!noise.keys.velocity.empty() && time != 0.0) {
    noise.velocity = nearest(domain::coordinate, integral(noise.keys.velocity, 0.0, time) / time);
  }
  clear_keys(result);
  apply_groups(result);
  apply_sky(result);
  result.surfaces = shown_surfaces(result.surfaces, time);
  for (const Emitter& emitter : scene.emitters) {
    if (!emitter.visible) continue;
    for (const Gaussian& gaussian : particles_at(emitter, time)) result.medium.append(gaussian);
  }
  for (const MediumSequence& sequence : scene.sequences) {
    for (const Gaussian& gaussian : sequence_at(sequence, time, result.optics.albedo))
      result.medium.append(gaussian);
  }
  result.emitters.clear();
  result.sequences.clear();
  return result;
}

}  // namespace brume
