#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "render/frame.h"
#include "render/settings.h"
#include "render/transfer/transfer_store.h"

namespace brume {

// The stages a scene needs, and why the others are skipped: the single place that decides.
struct RenderPlan {
  bool surfaces = false;                   // visible, and casting shadows
  bool lit_surfaces = false;               // surfaces, and lights or an environment
  bool gaussians = false;                  // with non-zero extinction
  bool homogeneous = false;                // b0 > 0
  bool noise = false;                      // Gaussians, and noise that displaces view rays
  bool environment = false;                // with non-zero radiance
  bool airlight = false;                   // a medium, and lights or an environment
  bool scattered_on_surfaces = false;      // surfaces, lights and a scattering medium between them
  std::vector<PointLight> lights;          // lights that are on
  std::vector<TransferRequest> transfers;  // without duplicates
  std::vector<SkippedStage> skipped;

  RenderPlan(const Scene& scene, AirlightMethod method);

  // Whether the transfer requested by a surface is used by any light.
  [[nodiscard]] bool needs_transfer(const Surface& surface) const;
};

}  // namespace brume
