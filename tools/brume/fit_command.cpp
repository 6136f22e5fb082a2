#include <chrono>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/fit/fit_error.h"
#include "core/fit/gaussian_fit.h"
#include "core/fit/gaussian_numbers.h"
#include "core/fit/next_start.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "core/io/gaussian_file.h"
#include "core/io/limits.h"
#include "core/io/text_scanner.h"
#include "core/io/volume_file.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/frame_range.h"
#include "tools/brume/progress_line.h"

namespace brume {
namespace {

// Above this a grid is fitted at half its resolution, again and again: the fit keeps some 6 kB of
// each block at hand.
constexpr std::size_t most_blocks = 200'000;

class FitCommand final : public Command {
 public:
  explicit FitCommand(CLI::App& app) {
    app.add_option("VOLUME", volume_, "the volume, .vdb; with %04d for the frame: a sequence")
        ->required();
    app.add_option("-o,--output", output_, "the Gaussians, .ply or .csv")->required();
    app.add_option("--count", count_, "Gaussians, at most")
        ->check(finite_in(1, 1e6))
        ->capture_default_str();
    auto* const error =
        app.add_option("--max-error", max_error_,
                       "relative RMS error of density to reach, with as few Gaussians as will do");
    error->check(finite_in(1e-4, 1.0));
    app.add_option("--grid", grid_, "the grid of the volume")->capture_default_str();
    app.add_option("--up", up_, "the axis that is up in the volume: y, or z, which is turned to y")
        ->check(CLI::IsMember({"y", "z"}))
        ->capture_default_str();
    app.add_option("--density-scale", density_scale_,
                   "what a density of 1 in the volume scatters [1/u]")
        ->check(finite_in(1e-12, 1e12))
        ->capture_default_str();
    app.add_option("--frames", frames_, "FIRST-LAST, of a sequence");
    app.add_option("--fps", fps_,
                   "frames per second, where a sequence has velocities to move its Gaussians with")
        ->check(finite_in(1e-3, 1e6))
        ->capture_default_str();
    app.footer(
        "Prints one line of JSON per frame: the relative RMS errors of density and of optical\n"
        "depth along 10,000 random lines, the mass over the volume's, and seconds. A frame of a\n"
        "sequence starts from the one before; a Gaussian keeps its id in the column id; those "
        "that\n"
        "are renewed left off where they were of no more use, began where smoke was missing, and\n"
        "have a new one.");
  }

  ExitCode run() override {
    const bool is_sequence = !frames_.empty();
    if (is_sequence != FramePattern::is_pattern(volume_) ||
        is_sequence != FramePattern::is_pattern(output_)) {
      throw UsageError(
          "a sequence needs --frames FIRST-LAST and %04d for the frame in both file names");
    }
    if (!is_sequence) {
      fit(volume_, output_, {});
      return done;
    }
    if (max_error_ > 0.0) throw UsageError("--max-error: not for a sequence; allowed: --count");
    const FramePattern volumes = parse_pattern(volume_);
    const FramePattern outputs = parse_pattern(output_);
    for (const int frame : parse_frames(frames_)) fit(volumes.of(frame), outputs.of(frame), frame);
    return done;
  }

 private:
  void check_output(const std::string& output) const {
    const std::string extension = lower_case_extension(output);
    if (extension != ".ply" && extension != ".csv") {
      throw InputError(output, "",
                       "found the extension " + shown(extension) + "; allowed: .ply, .csv");
    }
    check_writable(output);
  }

  // What turns the volume's axes into ours.
  [[nodiscard]] glm::dquat turn() const {
    return up_ == "z" ? glm::angleAxis(glm::radians(-90.0), glm::dvec3(1.0, 0.0, 0.0))
                      : glm::dquat(1.0, 0.0, 0.0, 0.0);
  }

  [[nodiscard]] DensityGrid read(const std::string& volume) const {
    DensityGrid grid = read_volume(volume, grid_);
    while (grid.blocks.size() > most_blocks) grid = coarser(grid);
    for (DensityGrid::Block& block : grid.blocks) {
      for (float& value : block.values) value *= static_cast<float>(density_scale_);
    }
    rotate(grid, turn());
    return grid;
  }

  void fit(const std::string& volume, const std::string& output, std::optional<int> frame) {
    check_output(output);
    const DensityGrid grid = read(volume);
    const auto start = std::chrono::steady_clock::now();
    const ProgressLine line(volume);
    Fit fit;
    std::size_t renewed = 0;
    if (last_.empty() || grid.blocks.empty()) {
      fit = *fit_gaussians(grid, {count_, max_error_}, {}, line.progress());
      numbers_.begin(fit.gaussians.size());
    } else {
      if (velocity_) last_ = next_start(grid, last_, *velocity_, 1.0 / fps_);
      Refit refit = *refit_gaussians(grid, last_, {}, line.progress());
      fit = std::move(refit.fit);
      renewed = numbers_.renew(refit.renewed);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    write_gaussians(output, fit.gaussians,
                    frame ? numbers_.ids() : std::span<const GaussianNumber>());

    nlohmann::ordered_json json;
    if (frame) json["frame"] = *frame;
    json["gaussians"] = fit.gaussians.size();
    if (frame) json["renewed"] = renewed;
    json["density_error"] = fit.density_error;
    json["depth_error"] = depth_error(grid, fit.gaussians);
    json["mass_ratio"] = grid.blocks.empty() ? 1.0 : mass_ratio(grid, fit.gaussians);
    json["seconds"] = seconds.count();
    print_result(json.dump() + "\n");
    last_ = std::move(fit.gaussians);
    if (!frame) return;
    velocity_ = read_velocity(volume);
    if (velocity_) rotate(*velocity_, turn());
  }

  std::string volume_;
  std::string output_;
  std::size_t count_ = 500;
  double max_error_ = 0.0;
  std::string grid_ = "density";
  std::string up_ = "y";
  double density_scale_ = 1.0;
  std::string frames_;
  double fps_ = 30.0;  // as the timeline
  std::vector<Gaussian> last_;  // of the frame before, and what moves them
  std::optional<VelocityGrid> velocity_;
  GaussianNumbers numbers_;
};

}  // namespace

std::unique_ptr<Command> make_fit_command(CLI::App& app) {
  return std::make_unique<FitCommand>(app);
}

}  // namespace brume
