#pragma once

#include <string>
#include <vector>

#include "render/frame.h"
#include "render/render_plan.h"
#include "render/settings.h"

namespace brume::gl {

// Decides which stages run on the device and which on the CPU, with reasons. Needs no device.
struct GlPlan {
  std::string refusal;               // why the whole frame runs on the CPU; empty: it does not
  std::vector<SkippedStage> on_cpu;  // stages that run on the CPU nevertheless

  GlPlan(const Settings& settings, const RenderPlan& plan);
};

}  // namespace brume::gl
