#pragma once

#include <optional>
#include <string>

#include "brume/render.h"
#include "render/samples/exposure.h"
#include "render/settings.h"

namespace brume {

inline constexpr int min_slices = 4;
inline constexpr int max_slices = 256;

// The settings of a FrameRenderer for a request, except samples. Threads are no more than there
// are.
Settings settings_of(const RenderRequest& request);

// The request with what settings, made of it, chose.
RenderRequest chosen(RenderRequest request, const Settings& settings);

// Makes it one of paths, which are never interpolated.
void trace_paths(RenderRequest& request, int paths, Denoising denoise);

// The reason why frames of a request cannot be denoised; empty: they can.
std::string denoise_problem(const RenderRequest& request);

// How a request exposes frames of an animation. A deep pixel is one ray.
Exposure exposure_of(const Scene& animation, const RenderRequest& request);

// A value of a request that is not allowed: its option on the command line, and why, "found ...;
// allowed: ...".
struct RequestProblem {
  std::string option;
  std::string why;
};
std::optional<RequestProblem> problem_of(const RenderRequest& request);

// Throws DomainError, also for film and camera.
void check(const RenderRequest& request);

}  // namespace brume
