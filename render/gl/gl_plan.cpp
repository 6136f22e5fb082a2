#include "render/gl/gl_plan.h"

#include "render/gl/shader_constants.h"

namespace brume::gl {
namespace {

std::string refusal_of(const Settings& settings) {
  if (settings.precision == Settings::Precision::plain_double)
    return "double precision was requested";
  const AirlightMethod method = settings.airlight;
  if (method == AirlightMethod::march || method == AirlightMethod::reference) {
    return std::string("airlight ") + to_string(method) + " runs only on the CPU";
  }
  if (method == AirlightMethod::paper) return {};
  if (settings.slices > max_slices) {
    return "more slices than fit into a work group";
  }
  if (settings.optical_depth_table.radii > 1024) {
    return "optical-depth tables have more radii than fit into a work group";
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
    on_cpu.push_back({"light_depth", "optical depths at the centres are computed on the CPU"});
    on_cpu.push_back({"eye_depth", "optical depths at the centres are computed on the CPU"});
  }
  if (!plan.transfers.empty()) {
    on_cpu.push_back({"vertex_light", "vertex lighting is computed on the CPU"});
  }
  if (!plan.environment || !plan.airlight) return;
  if (settings.airlight != AirlightMethod::paper) {
    on_cpu.push_back({"environment", "its grid is computed on the CPU"});
  } else if (plan.surfaces && plan.gaussians) {
    on_cpu.push_back({"average_depth", "the grids around surfaces are computed on the CPU"});
  }
}

}  // namespace brume::gl
