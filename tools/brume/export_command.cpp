#include <iostream>
#include <string>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/gaussian_csv.h"
#include "core/io/gaussian_file.h"
#include "core/io/number_domain.h"
#include "core/io/scene_file.h"
#include "core/io/text_scanner.h"
#include "core/io/volume_file.h"
#include "core/scene/at_time.h"
#include "core/volume/medium_grid.h"
#include "render/frame_file.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{2} << 30;

std::string in_megabytes(std::uintmax_t bytes) {
  return std::to_string((bytes + 999'999) / 1'000'000) + " MB";
}

class ExportCommand final : public Command {
 public:
  explicit ExportCommand(CLI::App& app) {
    app.add_option("SCENE", scene_, "the scene, .brume")->required();
    app.add_option("-o,--output", output_,
                   "its Gaussians: .vdb (a fog volume, grid density), .ply or .csv")
        ->required();
    app.add_option("--voxel", voxel_size_,
                   "size of a voxel of the .vdb; by default half the least radius")
        ->check(finite_in(1e-12, 1e12));
    app.add_flag("--half", half_, "store the .vdb in half precision");
    app.add_option("--time", time_, "the moment to write [s], of keys and emitters")
        ->check(finite_in(-1e9, 1e9))
        ->capture_default_str();
  }

  ExitCode run() override {
    const std::string extension = lower_case_extension(output_);
    if (extension != ".vdb" && extension != ".ply" && extension != ".csv") {
      throw InputError(output_, "",
                       "found the extension " + shown(extension) + "; allowed: .vdb, .ply, .csv");
    }
    if (extension != ".vdb" && (half_ || voxel_size_ > 0.0)) {
      throw UsageError("--voxel and --half: only for .vdb");
    }
    check_writable(output_);
    std::vector<std::string> warnings;
    const Scene scene = at_time(load_scene(scene_, &warnings), time_);
    const Medium& medium = scene.medium;
    if (medium.homogeneous_density() > 0.0) {
      warnings.push_back("the homogeneous density, " + shown(medium.homogeneous_density()) +
                         " everywhere, has no bounds and is left out");
    }
    print_warnings(warnings);
    if (extension == ".vdb") {
      write_volume(output_, sample(medium), half_);
      return done;
    }
    std::vector<Gaussian> gaussians;
    for (std::size_t i = 0; i < medium.size(); ++i) gaussians.push_back(medium.gaussian(i));
    if (extension == ".csv") {
      write_gaussians_csv(output_, gaussians);
    } else {
      write_gaussians(output_, gaussians);
    }
    return done;
  }

 private:
  // Says how large the grid will be before it is made.
  [[nodiscard]] DensityGrid sample(const Medium& medium) const {
    const double chosen = voxel_size_ > 0.0 ? voxel_size_ : fitting_voxel_size(medium);
    const double size = chosen > 0.0 ? chosen : 1.0;  // nothing to sample
    const auto plan = MediumSampling::plan(medium, size, most_bytes / sizeof(DensityGrid::Block));
    if (!plan) {
      throw InputError(scene_, "medium",
                       "a grid with voxels of " + shown(size) + " needs more than " +
                           in_megabytes(most_bytes) + "; allowed: a larger --voxel");
    }
    std::cerr << "brume: voxels of " << shown(size) << ", " << in_megabytes(plan->bytes())
              << " of memory\n";
    const ProgressLine line(output_);
    return *plan->sample({}, line.progress());
  }

  std::string scene_;
  std::string output_;
  double voxel_size_ = 0.0;
  bool half_ = false;
  double time_ = 0.0;
};

}  // namespace

std::unique_ptr<Command> make_export_command(CLI::App& app) {
  return std::make_unique<ExportCommand>(app);
}

}  // namespace brume
