#pragma once

#include <string>
#include <vector>

#include "brume/scene.h"
#include "brume/stage.h"
#include "render/settings.h"
#include "tools/bench/measure/measurement.h"

namespace brume {

// Scenes that show whether a render plan may leave a stage out: one in which the stage is left
// out, the same with as good as nothing for it to do (a density, light or amplitude of about 1e-9),
// so that it runs, and one that needs it.
struct PlanDecision {
  Stage stage;
  std::string why;
  AirlightMethod method = AirlightMethod::sliced;
  Scene left_out, made, needed;
};

// One for every stage that a plan may leave out.
std::vector<PlanDecision> plan_decisions();

// Renders with the scene's requested radiance transfer.
Frame render_planned(const Scene& scene, AirlightMethod method);

// Maximum difference of two frames' radiance or transmittance, relative to the maximum of `scale`.
double max_change(const Frame& a, const Frame& b, const Frame& scale);

// CPU milliseconds that leaving the stage out saves, of a frame with a moved camera.
struct PlanSaving {
  Stage stage;
  std::string why;
  Spread left_out, made;
  double change = 0.0;  // of the picture: max_change()
};
PlanSaving measure_saving(const PlanDecision& decision, int frames);

}  // namespace brume
