#include "render/gl/gl_plan.h"

#include "render/gl/shader_source.h"

namespace brume::gl {
namespace {

// Stages that also a frame of the device runs on the CPU.
struct CpuStage {
  Stage stage;
  Reason why;
};
constexpr CpuStage cpu_stages[] = {
    {Stage::light_depth, Reason::center_depths_on_cpu},
    {Stage::eye_depth, Reason::center_depths_on_cpu},
    {Stage::vertex_light, Reason::vertex_light_on_cpu},
    {Stage::environment, Reason::environment_on_cpu},
    {Stage::average_depth, Reason::average_depth_on_cpu},
};

}  // namespace

std::optional<Reason> refusal(const RenderPlan& plan) {
  const Settings& settings = plan.settings;
  if (settings.precision == Settings::Precision::plain_double) return Reason::double_precision;
  if (plan.has_mirrors) return Reason::mirrors_on_cpu;
  if (plan.has_holes || plan.has_panes) return Reason::coverage_on_cpu;
  if (plan.has_copies) return Reason::copies_on_cpu;
  if (plan.has_visible_lights) return Reason::visible_lights_on_cpu;
  switch (settings.airlight) {
    case AirlightMethod::paper:
      return std::nullopt;
    case AirlightMethod::reference:
      return Reason::reference_on_cpu;
    case AirlightMethod::path:
      return Reason::path_on_cpu;
    case AirlightMethod::auto_:  // plans have none
    case AirlightMethod::sliced:
      break;
  }
  if (settings.slices > max_slices) return Reason::too_many_slices;
  if (settings.optical_depth_table.radii > max_table_radii) return Reason::too_many_radii;
  return std::nullopt;
}

RenderPlan device_plan(RenderPlan plan, const DisplayOptions* display) {
  for (const Stage timed : {Stage::upsample, Stage::vertex_light}) {
    plan.stages.add(timed, plan.parts.has(timed));
    plan.parts.remove(timed);
  }
  plan.stages.add(Stage::lists, plan.has_medium());
  plan.stages.add(Stage::submit);
  plan.stages.add(Stage::read_back, !display);
  plan.stages.add(Stage::display, display);
  plan.stages.add(Stage::wait, display);
  plan.stages.add(Stage::read_depth, display && display->depth && plan.runs(Stage::visibility));
  for (const CpuStage& known : cpu_stages) {
    if (plan.runs(known.stage)) plan.on_cpu.push_back({known.stage, to_string(known.why)});
  }
  return plan;
}

}  // namespace brume::gl
