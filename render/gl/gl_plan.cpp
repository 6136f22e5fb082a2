#include "render/gl/gl_plan.h"

#include <algorithm>

#include "render/gl/shader_constants.h"

namespace brume::gl {
namespace {

// As many boundaries of slices as choose_slices() may make.
std::size_t most_boundaries_of(const Settings& settings, const RenderPlan& plan) {
  const auto slices = static_cast<std::size_t>(std::max(settings.slices, 4));
  const std::size_t lights = plan.lights.size();
  const std::size_t of_light =
      std::max<std::size_t>(slices / std::clamp<std::size_t>(lights, 1, 4), 4);
  return 4 + slices + lights * of_light + (plan.homogeneous ? slices : 0);
}

std::string refusal_of(const Settings& settings, const RenderPlan& plan) {
  if (settings.arithmetic == Settings::Arithmetic::plain_double) return "it is asked for in double";
  const AirlightMethod method = settings.airlight;
  if (method == AirlightMethod::march || method == AirlightMethod::reference) {
    return std::string("airlight ") + to_string(method) + " is the CPU's only";
  }
  if (method == AirlightMethod::paper) return {};
  if (settings.slices > most_slices || most_boundaries_of(settings, plan) > most_boundaries) {
    return "there are more slices than a work group has room for";
  }
  if (settings.light_table.radii > 1024) {
    return "light tables have more radii than a work group has room for";
  }
  return {};
}

}  // namespace

GlPlan::GlPlan(const Settings& settings, const RenderPlan& plan)
    : refusal(refusal_of(settings, plan)) {
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
