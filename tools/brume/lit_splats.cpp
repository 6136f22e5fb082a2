#include "tools/brume/lit_splats.h"

#include <memory>
#include <utility>
#include <vector>

#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussians/splat_ply.h"
#include "render/display/to_display.h"
#include "render/render_plan.h"
#include "render/splats/baked_splats.h"
#include "render/transfer/transfer_cache.h"
#include "tools/brume/command.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/web_page.h"

namespace brume {
namespace {

std::vector<SplatColor> baked(const Scene& scene, double exposure) {
  Settings settings = sliced_settings({}, 24);
  settings.scattering = Scattering::multiple;
  TransferStore transfers;
  if (const auto needed = needed_transfers(scene, settings); !needed.empty()) {
    const ProgressLine line("radiance transfer");
    std::vector<std::string> warnings;
    transfers.make(needed, cache_folder(), line.job(), &warnings);
    print_warnings(warnings);
    check_interrupted();
  }
  const ProgressLine line("baking light");
  const auto show = [exposure](const glm::vec3& radiance) {
    return to_display(radiance, exposure);
  };
  return finished(bake_splats(scene, settings, show, transfers, line.job()));
}

}  // namespace

std::function<void()> lit_splats(const Scene& scene, double exposure, OpacityAlong along,
                                 bool y_down, const std::filesystem::path& output) {
  std::vector<Gaussian> gaussians;
  for (std::size_t i = 0; i < scene.medium.size(); ++i) {
    gaussians.push_back(scene.medium.gaussian(i));
  }
  const std::vector<SplatColor> colors = baked(scene, exposure);
  const bool is_page = lower_case_extension(output) == ".html";
  std::string bytes =
      splats_ply(gaussians, {along, scene.optics.albedo, colors, y_down || is_page});
  if (is_page) bytes = web_page(output.stem().string(), bytes, scene.camera, scene.film);
  return [bytes = std::move(bytes), output] { write_atomically(output, bytes); };
}

}  // namespace brume
