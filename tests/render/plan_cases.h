#pragma once

#include <string>
#include <vector>

#include "brume/frame.h"
#include "brume/scene.h"
#include "render/render_plan.h"
#include "render/settings.h"

namespace brume {

// A small scene of some parts, and a method: what a plan decides by.
struct PlanCase {
  // `idle`: there, but without effect, as a light that is off.
  enum class Part { none, idle, active };
  Part lights = Part::none;
  Part sky = Part::none;
  Part gaussians = Part::none;
  bool fog = false;
  bool noise = false;
  bool surfaces = false;
  Surface::Transfer transfer = Surface::Transfer::none;  // requested by the surfaces
  AirlightMethod method = AirlightMethod::paper;
  int scale = 1;
  Scattering scattering = Scattering::single;

  [[nodiscard]] Scene scene() const;
  // With grids and tables of few cells.
  [[nodiscard]] Settings settings() const;
  [[nodiscard]] std::string name() const;
};

// All combinations of parts that are there or not, without noise, at one scale: few enough to be
// rendered.
std::vector<PlanCase> few_plan_cases(const std::vector<AirlightMethod>& methods);

// One stage and its reason a line.
std::string in_words(const std::vector<SkippedStage>& stages);

// That a frame ran each stage of its plan once and no other, and says why the rest was left out.
void expect_planned(const FrameStatistics& statistics, const RenderPlan& plan,
                    const std::string& name);

}  // namespace brume
