#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brume/error.h"
#include "core/fit/fit_error.h"
#include "core/fit/volume_fitter.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/text_scanner.h"
#include "core/io/volume/volume_file.h"
#include "core/number_domain.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/frame_range.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/request_arguments.h"
#include "tools/brume/run_frames.h"

namespace brume {
namespace {

class FitCommand final : public Command {
 public:
  explicit FitCommand(CLI::App& app) {
    app.add_option("VOLUME", volume_, "the volume, .vdb; with %04d for the frame, a sequence")
        ->type_name("FILE")
        ->required();
    app.add_option("-o,--output", output_, "the Gaussians, .ply or .csv")
        ->type_name("FILE")
        ->required();
    app.add_option("--count", how_.options.count, "maximum number of Gaussians")
        ->check(finite_in(1, 1e6))
        ->capture_default_str();
    auto* const error =
        app.add_option("--max-error", how_.options.max_error,
                       "relative RMS error of density to reach with as few Gaussians as possible");
    error->check(finite_in(1e-4, 1.0));
    app.add_option("--shape", shape_, "shape of the Gaussians: ball or ellipsoid")
        ->type_name("TEXT:{ball,ellipsoid}")
        ->check(CLI::IsMember({"ball", "ellipsoid"}))
        ->capture_default_str();
    app.add_option("--grid", how_.grid, "the grid to fit; none: flames only")
        ->capture_default_str();
    app.add_option("--up", up_, "up axis of the volume: y, or z, which is rotated to y")
        ->check(CLI::IsMember({"y", "z"}))
        ->capture_default_str();
    app.add_option("--density-scale", how_.density_scale,
                   "scattering coefficient of a density of 1 [1/u]")
        ->check(finite_in(1e-12, 1e12))
        ->capture_default_str();
    app.add_option("--frames", frames_, "fit a sequence, FIRST-LAST");
    app.add_option("--fps", how_.frames_per_second,
                   "frames per second of a sequence with velocities")
        ->check(finite_in(1e-3, 1e6))
        ->capture_default_str();
    add_appearance(app, how_.appearance);
    app.footer(
        "Prints one line of JSON per frame: the relative RMS errors of density and of optical\n"
        "depth along 10,000 random lines, the mass over the volume's, the errors of extinction,\n"
        "emission and flames if the volume has these, and seconds. A frame of a sequence starts\n"
        "from the Gaussians of the previous frame, which keep their number in the column id.\n"
        "Renewed ones were moved to where the residual is largest and get a new number.\n"
        "--color, --emission, --temperature and --flame: auto takes the first grid that programs\n"
        "use for it, none takes no grid.");
  }

  ExitCode run() override {
    const bool is_sequence = !frames_.empty();
    if (is_sequence != FramePattern::is_pattern(volume_) ||
        is_sequence != FramePattern::is_pattern(output_)) {
      throw UsageError(
          "a sequence needs --frames FIRST-LAST and %04d for the frame in both file names");
    }
    const std::string extension = lower_case_extension(output_);
    if (extension != ".ply" && extension != ".csv") {
      throw InputError(output_, "",
                       "found the extension " + quoted_text(extension) + "; allowed: .ply, .csv");
    }
    how_.z_up = up_ == "z";
    how_.options.shape = shape_ == "ball" ? FitShape::ball : FitShape::ellipsoid;
    fitter_.emplace(how_);
    CommandFiles files;
    if (!is_sequence) {
      files.add_input(volume_);
      files.add_output(output_);
      fit(volume_, output_, {})();
      return done;
    }
    if (how_.options.max_error > 0.0)
      throw UsageError("--max-error: not for a sequence; allowed: --count");
    const FramePattern volumes = parse_pattern(volume_);
    const FramePattern outputs = parse_pattern(output_);
    const std::vector<int> frames = parse_frames(frames_);
    for (const int frame : frames) {
      files.add_input(volumes.file_of(frame));
      files.add_output(outputs.file_of(frame));
    }
    return run_frames(frames, [&](int frame, const std::string&) {
      return fit(volumes.file_of(frame), outputs.file_of(frame), frame);
    });
  }

 private:
  static void add_appearance(CLI::App& app, AppearanceOptions& appearance) {
    const auto add_grid = [&](const char* option, std::string& name, const char* help) {
      app.add_option(option, name, help)->capture_default_str();
    };
    add_grid("--color", appearance.grids.color, "the grid of the albedo");
    add_grid("--emission", appearance.grids.emission,
             "the grid of the radiance per unit of extinction optical depth");
    add_grid("--temperature", appearance.grids.temperature, "the grid of the temperature");
    add_grid("--flame", appearance.grids.flame, "the grid of where fire is");
    const auto add_number = [&](const char* option, double& number, const NumberDomain& domain,
                                const char* help) {
      app.add_option(option, number, help)
          ->check(finite_in(domain.min_value, domain.max_value))
          ->capture_default_str();
    };
    constexpr NumberDomain factor{1e-12, 1e12, "a number from 1e-12 to 1e12"};
    add_number("--temperature-scale", appearance.temperature_scale, factor,
               "temperature of a value of 1 [K]");
    add_number("--emission-scale", appearance.emission_scale, factor,
               "factor of emission and of black bodies' radiance");
    add_number("--flame-scale", appearance.flame_scale, factor, "extinction of a flame of 1 [1/u]");
    add_number("--flame-temperature", appearance.flame_temperature, domain::temperature,
               "temperature of flames without one at which matter glows [K]");
  }

  FittedVolume fitted_volume(const std::string& volume) {
    const ProgressLine line("fitting " + volume);
    return finished(fitter_->next(volume, interruption(), line.progress()));
  }

  // Returns what writes the Gaussians and tells of them.
  FrameLoop::Write fit(const std::string& volume, const std::string& output,
                       std::optional<int> frame) {
    print_warnings(volume_warnings(volume));
    const auto start = std::chrono::steady_clock::now();
    const FittedVolume fitted = fitted_volume(volume);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::vector<Gaussian> gaussians = fitted.gaussians();
    std::vector<GaussianNumber> ids;
    if (frame) ids.assign(fitter_->ids().begin(), fitter_->ids().end());

    nlohmann::ordered_json json;
    if (frame) json["frame"] = *frame;
    json["gaussians"] = gaussians.size();
    if (frame) json["renewed"] = fitted.renewed;
    json["density_error"] = fitted.fit.density_error;
    const std::vector<Gaussian>& smoke = fitted.fit.gaussians;
    json["depth_error"] = depth_error(fitted.grid, smoke);
    json["mass_ratio"] = fitted.grid.blocks.empty() ? 1.0 : mass_ratio(fitted.grid, smoke);
    if (fitted.errors.extinction) json["extinction_error"] = *fitted.errors.extinction;
    if (fitted.errors.emission) json["emission_error"] = *fitted.errors.emission;
    if (fitted.flames) {
      json["flames"] = fitted.flames->gaussians.size();
      json["flame_error"] = fitted.flames->density_error;
    }
    json["seconds"] = seconds.count();
    return [gaussians = std::move(gaussians), ids = std::move(ids), output, line = json.dump()] {
      write_gaussians(output, gaussians, ids);
      print_result(line + "\n");
    };
  }

  std::string volume_;
  std::string output_;
  VolumeFit how_;
  std::string shape_ = "ellipsoid";
  std::string up_ = "y";
  std::string frames_;
  std::optional<VolumeFitter> fitter_;
};

}  // namespace

std::unique_ptr<Command> make_fit_command(CLI::App& app) {
  return std::make_unique<FitCommand>(app);
}

}  // namespace brume
