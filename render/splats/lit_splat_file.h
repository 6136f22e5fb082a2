#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "brume/scene.h"
#include "brume/splat.h"
#include "render/util/job.h"

namespace brume {

// How a scene's lit fog is written as splats.
struct LitSplatOptions {
  double exposure = 0.0;  // [stops]
  OpacityAlong along = OpacityAlong::mean;
  bool y_down = false;  // of a PLY; see SplatOutput
  // Only these of the Gaussians are written, lit as among all; sorted. nullopt: all.
  std::optional<std::vector<GaussianId>> only;
};

// Bakes the light of a scene's fog into splats, exposed and shown as a .png is, and returns what
// `file` is to hold: a PLY of splats, or a web page that shows them if the extension is .html.
// nullopt if stopped. Warnings, one line each, are appended to `warnings`. Throws InputError if the
// viewer of the page is not installed.
std::optional<std::string> lit_splat_file(const Scene& scene, const LitSplatOptions& options,
                                          const std::filesystem::path& file, const Job& job = {},
                                          std::vector<std::string>* warnings = nullptr);

}  // namespace brume
