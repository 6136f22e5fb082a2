#pragma once

#include <string>
#include <vector>

#include "render/frame.h"
#include "render/render_plan.h"
#include "render/settings.h"

namespace brume::gl {

// What of a frame runs on the device, and what on the CPU and why. Says so without a device.
struct GlPlan {
  std::string refusal;               // why all of it is the CPU's; empty: it is not
  std::vector<SkippedStage> on_cpu;  // stages that are the CPU's all the same

  GlPlan(const Settings& settings, const RenderPlan& plan);
};

}  // namespace brume::gl
