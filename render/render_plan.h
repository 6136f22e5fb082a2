#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// What a scene needs to be rendered, and why the rest is left out: the one place that decides.
struct RenderPlan {
  bool surfaces = false;                   // any to be seen and to cast shadows
  bool lit_surfaces = false;               // surfaces, and lights or an environment
  bool gaussians = false;                  // any that takes light away
  bool homogeneous = false;                // b0 > 0
  bool noise = false;                      // Gaussians and noise that bends view rays through them
  bool environment = false;                // one that gives light
  bool airlight = false;                   // a medium, and lights or an environment
  bool scattered_on_surfaces = false;      // surfaces, lights and a medium that scatters on the way
  std::vector<PointLight> lights;          // those that give light
  std::vector<TransferRequest> transfers;  // each once
  std::vector<SkippedStage> skipped;

  RenderPlan(const Scene& scene, AirlightMethod method);

  // Whether there is light for the transfer that a surface asks for.
  [[nodiscard]] bool needs_transfer(const Surface& surface) const;
};

}  // namespace brume
