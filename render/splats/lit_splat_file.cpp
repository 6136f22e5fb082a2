#include "render/splats/lit_splat_file.h"

#include <algorithm>

#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/splat_page.h"
#include "core/io/gaussians/splat_ply.h"
#include "render/display/to_display.h"
#include "render/render_plan.h"
#include "render/splats/baked_splats.h"
#include "render/transfer/transfer_cache.h"

namespace brume {
namespace {

std::optional<std::vector<SplatColor>> baked(const Scene& scene, double exposure, const Job& job,
                                             std::vector<std::string>* warnings) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = Scattering::multiple;
  TransferStore transfers;
  const std::vector<TransferRequest> needed = needed_transfers(scene, settings);
  const double first = needed.empty() ? 0.0 : 0.5;  // of the progress
  if (!transfers.make(needed, cache_folder(), job.subrange(0.0, first), warnings)) return {};
  const auto show = [exposure](const glm::vec3& radiance) {
    return to_display(radiance, exposure);
  };
  return bake_splats(scene, settings, show, transfers, job.subrange(first, 1.0));
}

}  // namespace

std::optional<std::string> lit_splat_file(const Scene& scene, const LitSplatOptions& options,
                                          const std::filesystem::path& file, const Job& job,
                                          std::vector<std::string>* warnings) {
  auto colors = baked(scene, options.exposure, job, warnings);
  if (!colors) return std::nullopt;
  std::vector<Gaussian> gaussians = scene.medium.gaussians();
  if (options.only) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < gaussians.size(); ++i) {
      if (!std::ranges::binary_search(*options.only, scene.medium.ids()[i])) continue;
      gaussians[count] = gaussians[i];
      (*colors)[count++] = (*colors)[i];
    }
    gaussians.resize(count);
    colors->resize(count);
  }
  const bool is_page = lower_case_extension(file) == ".html";
  std::string ply = splats_ply(
      gaussians, {options.along, scene.optics.albedo, *colors, options.y_down || is_page});
  if (!is_page) return ply;
  return splat_page(file.stem().string(), ply, scene.camera, scene.film);
}

}  // namespace brume
