#include "tools/brume/lit_splats.h"

#include <utility>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "render/splats/lit_splat_file.h"
#include "tools/brume/command.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"

namespace brume {

std::function<void()> lit_splats(const Scene& scene, double exposure, OpacityAlong along,
                                 bool y_down, const std::filesystem::path& output) {
  std::vector<std::string> warnings;
  std::optional<std::string> bytes;
  {
    const ProgressLine line("baking light");
    bytes =
        lit_splat_file(scene, {.exposure = exposure, .along = along, .y_down = y_down, .only = {}},
                       output, line.job(), &warnings);
  }
  print_warnings(warnings);
  return [bytes = finished(std::move(bytes)), output] { write_atomically(output, bytes); };
}

}  // namespace brume
