#include "render/gl/gl_plan.h"

#include "render/gl/shader_constants.h"

namespace brume::gl {
namespace {

std::string refusal_of(const Settings& settings) {
  if (settings.arithmetic == Settings::Arithmetic::plain_double) return "it is asked for in double";
  const AirlightMethod method = settings.airlight;
  if (method == AirlightMethod::march || method == AirlightMethod::reference) {
    return std::string("airlight ") + to_string(method) + " is the CPU's only";
  }
  if (method == AirlightMethod::paper) return {};
  if (settings.slices > most_slices) {
    return "there are more slices than a work group has room for";
  }
  if (settings.light_table.radii > 1024) {
    return "light tables have more radii than a work group has room for";
  }
  return {};
}

}  // namespace

GlPlan::GlPlan(const Settings& settings, const RenderPlan& plan) : refusal(refusal_of(settings)) {
  if (!refusal.empty()) {
    on_cpu.push_back({"frame", refusal});
    return;
  }
  if (settings.airlight == AirlightMethod::paper && plan.gaussians && !plan.lights.empty()) {
    on_cpu.push_back({"light_depth", "depths of centres are not on the device yet"});
    on_cpu.push_back({"eye_depth", "depths of centres are not on the device yet"});
  }
  if (!plan.transfers.empty()) {
    on_cpu.push_back({"vertex_light", "light at the vertices is not taken on the device yet"});
  }
  if (!plan.environment || !plan.airlight) return;
  if (settings.airlight != AirlightMethod::paper) {
    on_cpu.push_back({"environment", "its grid is not on the device yet"});
  } else if (plan.surfaces && plan.gaussians) {
    on_cpu.push_back({"average_depth", "the grids around surfaces are not on the device yet"});
  }
}

}  // namespace brume::gl
