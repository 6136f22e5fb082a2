#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/background_job.h"
#include "core/scene/scene.h"

namespace brume {

// The Gaussians of a scene for other programs. The homogeneous density has no bounds and is left
// out.
struct MediumExport {
  std::shared_ptr<const Scene> scene;  // with all its times
  std::filesystem::path file;          // .vdb (a fog volume, grid `density`), .ply or .csv
  double voxel_size = 0.0;             // of a .vdb; 0: half the least radius
  bool half = false;                   // a .vdb in half precision
  double time = 0.0;                   // [s]
  // Frames of the timeline instead, into numbered files.
  struct Range {
    int first = 0;
    int last = 0;
    double frames_per_second = 30.0;
  };
  std::optional<Range> range;
};

// A grid is never larger [bytes].
inline constexpr std::uintmax_t most_grid_bytes = std::uintmax_t{2} << 30;
// What the grid of a medium takes; nullopt where that is more. voxel_size as in MediumExport.
std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size);

// The work of such an export. Each file is written whole or not at all; files of a range that are
// complete when it is stopped stay.
BackgroundJob::Work export_medium(const MediumExport& wanted);

}  // namespace brume
