#pragma once

#include "brume/export.h"
#include "brume/scene.h"

namespace brume {

// Whether a scene depends on time.
BRUME_EXPORT bool is_animated(const Scene& scene);

// Time of the last keyframe or sequence frame, at least 0 [s].
BRUME_EXPORT double last_moment(const Scene& scene);

// Frames per second of the scene, by which frames become times, shutters and motion: those of its
// timeline, else default_frame_rate.
BRUME_EXPORT double frame_rate(const Scene& scene);
// Sets it; a scene without a timeline gets one that ends at last_moment().
BRUME_EXPORT void set_frame_rate(Scene& scene, double rate);

// Upper bound of the Gaussians of a scene at any time, including sequences and particles; bounded
// by limits::gaussians.
BRUME_EXPORT std::size_t gaussian_count(const Scene& scene);

// Whether what groups make of the medium is the same at any time.
BRUME_EXPORT bool has_constant_groups(const Scene& scene);

// Makes the medium what the groups make of it, without hidden ones; the scene has no groups then.
BRUME_EXPORT void apply_groups(Scene& scene);

// Evaluates a scene at a time [s]: keyframed values are evaluated, groups are applied, particles
// and sequences are added to the medium; the result has no keys, groups, emitters, sequences or
// hidden surfaces, imported scenes are in parts (shown_surfaces()), a sky is an environment map and
// its sun the last of the lights, and it shows this time.
BRUME_EXPORT Scene evaluate_at(const Scene& scene, double time);

}  // namespace brume
