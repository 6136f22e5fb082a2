#pragma once

#include "render/gl_renderer.h"
#include "tools/bench/bench_run.h"

namespace brume {

// One scene with all settings that are tried, their errors, and a picture. `gl` may be null.
SceneReport measure_scene(const BenchScene& bench, const BenchOptions& options, GlRenderer* gl);

}  // namespace brume
