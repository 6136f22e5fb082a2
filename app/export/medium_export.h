#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/jobs/background_job.h"
#include "brume/scene.h"

namespace brume {

// Parameters of exporting a scene's Gaussians. The homogeneous density is unbounded and excluded.
struct MediumExport {
  std::shared_ptr<const Scene> scene;  // with all its times
  std::filesystem::path file;          // .vdb (grids as write_volume() names them), .ply or .csv
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

// Maximum size of a grid [bytes].
inline constexpr std::uintmax_t max_grid_bytes = std::uintmax_t{2} << 30;
// Memory of a medium's grid; nullopt beyond the maximum. voxel_size: see MediumExport.
std::optional<std::uintmax_t> grid_bytes(const Medium& medium, double voxel_size);

// The background work of an export. Files are written atomically; complete ones of a cancelled
// range stay.
BackgroundJob::Work export_medium(const MediumExport& request);

}  // namespace brume
