#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brume/at_time.h"
#include "brume/error.h"
#include "brume/limits.h"
#include "core/authoring/simplify.h"
#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/usd_file.h"
#include "core/io/text_scanner.h"
#include "core/io/volume/volume_file.h"
#include "core/medium/splat.h"
#include "core/number_domain.h"
#include "core/volume/medium_grid.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/frame_range.h"
#include "tools/brume/interruption.h"
#include "tools/brume/lit_splats.h"
#include "tools/brume/progress_line.h"
#include "tools/brume/request_arguments.h"
#include "tools/brume/run_frames.h"

namespace brume {
namespace {

constexpr std::uintmax_t max_bytes = std::uintmax_t{2} << 30;
constexpr std::size_t max_blocks = max_bytes / sizeof(DensityGrid::Block);

std::string in_megabytes(std::uintmax_t bytes) {
  return std::to_string((bytes + 999'999) / 1'000'000) + " MB";
}

class ExportCommand final : public Command {
 public:
  explicit ExportCommand(CLI::App& app) {
    app.add_option(
           "SCENE", input_,
           "a scene (.brume) or Gaussians (.ply, .csv, splats of .glb, .gltf; with %04d for the "
           "frame, a sequence)")
        ->type_name("FILE")
        ->required();
    app.add_option(
           "-o,--output", output_,
           "output: .vdb (a fog volume with the grid density, and albedo and emission if "
           "Gaussians have their own), .ply, .csv, .glb or .gltf (splats), .html (see --web), "
           "or .usda (a USD stage of a scene: camera, lights, surfaces and, in .vdb files "
           "beside it, the fog)")
        ->type_name("FILE")
        ->required();
    app.add_flag("--splats", splats_,
                 "write the .ply as programs of Gaussian splatting do: opacities, logarithms of "
                 "standard deviations, quaternions, and the albedo as color; in a .usda the fog as "
                 "splats too");
    app.add_option("--opacity-along", along_,
                   "the radius along which a Gaussian is as opaque as its splat, read or written")
        ->type_name("TEXT:{shortest,mean,longest}")
        ->check(CLI::IsMember({"shortest", "mean", "longest"}))
        ->default_str("mean");
    app.add_flag("--colors", colors_, "colours of splats that are read become albedos");
    app.add_flag("--lit", lit_,
                 "the splats of a .ply as the scene lights them, as spherical harmonics of display "
                 "values; implies --splats");
    app.add_flag("--y-down", y_down_,
                 "y points down in splats of a .ply, read or written, as captures have it and most "
                 "viewers expect it: turned by half about z");
    app.add_option("--up", up_,
                   "up axis of a file of Gaussians that is read: y, or z, which is turned to y; "
                   "--y-down then counts for what is written")
        ->type_name("TEXT:{y,z}")
        ->check(CLI::IsMember({"y", "z"}))
        ->default_str("y");
    app.add_flag("--web", web_,
                 "one page, an .html, that shows the lit splats in a browser, offline");
    app.add_option("--exposure", exposure_, "exposure of lit splats, in stops")
        ->check(finite_in(-100.0, 100.0));
    app.add_option("--voxel", voxel_size_,
                   "voxel size of the .vdb; default: half the smallest radius")
        ->check(finite_in(1e-12, 1e12));
    app.add_flag("--half", half_, "store the .vdb in half precision");
    app.add_option("--simplify", simplify_,
                   "merge Gaussians into fewer, up to this relative rms error of optical depth")
        ->check(finite_in(1e-4, 1.0));
    auto* const time =
        app.add_option("--time", time_, "time to export [s], for keyframes and emitters");
    time->check(finite_in(-1e9, 1e9))->capture_default_str();
    app.add_option("--frames", frames_,
                   "export a sequence, FIRST-LAST; OUT needs %04d for the frame, but for .usda; "
                   "frame n of a scene is at n / fps seconds")
        ->excludes(time);
    add_frame_rate(app, fps_);
  }

  ExitCode run() override {
    const std::string extension = lower_case_extension(output_);
    check(extension);
    if (extension == ".usda") {
      write_stage();
      return done;
    }
    const bool is_sequence = !frames_.empty();
    const bool are_files = FramePattern::is_pattern(input_);
    if (is_sequence != FramePattern::is_pattern(output_) || (are_files && !is_sequence)) {
      throw UsageError("a sequence needs --frames FIRST-LAST and %04d for the frame in OUT");
    }
    check_splats(extension);
    if (!is_sequence) {
      files_.add_output(output_);
      if (lit_) {
        writing_lit(time_, output_)();
      } else {
        writing(read(time_), output_)();
      }
      return done;
    }
    const FramePattern outputs = parse_pattern(output_);
    const std::vector<int> frames = parse_frames(frames_);
    for (const int frame : frames) {
      files_.add_output(outputs.file_of(frame));
      if (are_files) files_.add_input(parse_pattern(input_).file_of(frame));
    }
    // A fault of the scene is in all frames.
    if (!are_files) static_cast<void>(read_scene_at(time_of(frames.front())));
    return run_frames(frames, [&](int frame, const std::string&) {
      if (lit_) return writing_lit(time_of(frame), outputs.file_of(frame));
      return writing(
          are_files ? read_file(parse_pattern(input_).file_of(frame)) : read(time_of(frame)),
          outputs.file_of(frame));
    });
  }

 private:
  // Whether the options go together with the extension of the output, and what they imply.
  void check(const std::string& extension) {
    const std::array allowed{".vdb", ".ply", ".csv", ".glb", ".gltf", ".usda", ".html"};
    if (std::ranges::find(allowed, extension) == allowed.end()) {
      throw InputError(output_, "",
                       "found the extension " + quoted_text(extension) +
                           "; allowed: .vdb, .ply, .csv, .glb, .gltf, .usda, .html");
    }
    const bool is_ply = extension == ".ply";
    const bool is_page = extension == ".html";
    if (web_ && !is_page) throw UsageError("--web: only for .html");
    if (lit_ && !is_ply && !is_page) throw UsageError("--lit: only for .ply and .html");
    lit_ = lit_ || is_page;
    if (exposure_ != 0.0 && !lit_) throw UsageError("--exposure: only for --lit and --web");
    if (splats_ && (extension == ".vdb" || extension == ".csv")) {
      throw UsageError("--splats: only for .ply and .usda; .glb and .gltf are splats");
    }
    splats_ = splats_ || lit_ || extension == ".glb" || extension == ".gltf";
    if (extension != ".vdb" && extension != ".usda" && (half_ || voxel_size_ > 0.0)) {
      throw UsageError("--voxel and --half: only for .vdb and .usda");
    }
    const bool is_scene = lower_case_extension(input_) == ".brume";
    if (is_scene && !up_.empty()) throw UsageError("--up: only for files of Gaussians");
    if (lit_ && !is_scene) {
      throw InputError(input_, "", "found no scene; allowed for --lit and --web: a .brume");
    }
  }

  // The same of options for splats, read or written.
  void check_splats(const std::string& extension) const {
    if (along_.empty() && !y_down_ && !colors_) return;
    const bool is_sequence = FramePattern::is_pattern(input_);
    const std::string first =
        is_sequence ? parse_pattern(input_).file_of(parse_frames(frames_).front()) : input_;
    const bool reads = lower_case_extension(input_) != ".brume" && has_splats(first);
    if (!along_.empty() && !reads && !splats_) {
      throw UsageError("--opacity-along: only for splats, read or written");
    }
    if (colors_ && !reads) throw UsageError("--colors: only for splats that are read");
    const bool reads_ply = reads && may_have_y_down(first) && up_.empty();
    if (y_down_ && !reads_ply && !(splats_ && extension == ".ply")) {
      throw UsageError("--y-down: only for splats of a .ply, read or written");
    }
  }

  // Whether --y-down counts for the splats of a file: those of glTF have y up.
  static bool may_have_y_down(const std::string& file) {
    return lower_case_extension(file) == ".ply";
  }

  [[nodiscard]] OpacityAlong along() const {
    if (along_ == "shortest") return OpacityAlong::shortest;
    return along_ == "longest" ? OpacityAlong::longest : OpacityAlong::mean;
  }

  // Gaussians, and their ids if these are written.
  struct NumberedMedium {
    Medium medium;
    std::vector<GaussianNumber> ids{};
  };

  // The medium with as few Gaussians as --simplify asks for.
  [[nodiscard]] Medium simplified(const Medium& medium) const {
    if (!(simplify_ > 0.0)) return medium;
    const ProgressLine line("simplifying");
    const Simplified less = finished(brume::simplify(
        medium, {.max_error = simplify_, .ellipsoids = true}, interruption(), line.progress()));
    const std::vector<Gaussian> left = less.of(medium);
    print_note(std::to_string(medium.size()) + " Gaussians became " + std::to_string(left.size()) +
               ", with an error of " + quoted_text(less.error));
    Medium result;
    result.set_homogeneous_density(medium.homogeneous_density());
    for (const Gaussian& gaussian : left) result.append(gaussian);
    return result;
  }

  [[nodiscard]] NumberedMedium read_file(const std::string& file) const {
    NumberedMedium read;
    const bool is_turned = y_down_ && up_.empty() && may_have_y_down(file) && has_splats(file);
    std::vector<std::string> warnings;
    std::vector<Gaussian> gaussians = read_with_ids(file, read.ids, {along(), colors_}, &warnings);
    print_warnings(warnings);
    for (Gaussian& gaussian : gaussians) {
      if (is_turned) turn_half(gaussian);
      if (up_ == "z") turn_z_up(gaussian);
      read.medium.append(gaussian);
    }
    return read;
  }

  // The scene with its animation, read once.
  const Scene& animation() {
    if (!scene_) {
      scene_ = read_scene(input_, files_);
      if (fps_) set_frame_rate(*scene_, *fps_);
      const double homogeneous = scene_->medium.homogeneous_density();
      if (homogeneous > 0.0) {
        print_warnings({"the homogeneous density, " + quoted_text(homogeneous) +
                        ", has no bounds and is not exported"});
      }
    }
    return *scene_;
  }

  // The time of a frame [s].
  double time_of(int frame) { return frame / frame_rate(animation()); }

  // The scene at a time [s].
  [[nodiscard]] Scene read_scene_at(double time) {
    Scene scene = evaluate_at(animation(), time);
    albedo_ = scene.optics.albedo;
    return scene;
  }

  // The medium at a time [s].
  [[nodiscard]] NumberedMedium read(double time) {
    if (lower_case_extension(input_) == ".brume") {
      Medium medium = read_scene_at(time).medium;
      std::vector<GaussianNumber> ids = written_ids(medium);
      return {std::move(medium), std::move(ids)};
    }
    files_.add_input(input_);
    return read_file(input_);
  }

  // A stage, whose volumes lie beside it: NAME_fog.vdb, with frames NAME_fog_0001.vdb.
  void write_stage() {
    if (lower_case_extension(input_) != ".brume") {
      throw InputError(input_, "", "found no scene; allowed for .usda: a .brume");
    }
    const bool is_sequence = !frames_.empty();
    const std::filesystem::path stage = output_;
    std::vector<std::optional<int>> codes{std::nullopt};
    if (is_sequence) {
      const std::vector<int> numbers = parse_frames(frames_);
      codes.assign(numbers.begin(), numbers.end());
    }
    const auto file_of = [&](std::optional<int> code) { return volume_of_stage(stage, code); };
    files_.add_output(output_);
    for (const auto& code : codes) files_.add_output(file_of(code).string());
    FileGroup group;
    std::vector<UsdFrame> frames;
    for (const auto& code : codes) {
      UsdFrame frame{code, read_scene_at(code ? time_of(*code) : time_), {}};
      frame.scene.medium = simplified(frame.scene.medium);
      if (splats_) frame.splats = frame.scene.medium.gaussians();
      if (frame.scene.medium.size() > 0) {
        const Grids grids = sampled_grids(frame.scene.medium, file_of(code).string());
        write_volume(file_of(code), grids.density, half_, grids.colors);
        replace_medium(frame, file_of(code), grids.colors);
      }
      frames.push_back(std::move(frame));
    }
    write_usd(stage, frames, frame_rate(animation()), along(),
              [this](const std::filesystem::path& texture) { files_.add_output(texture); });
    group.commit();
  }

  // Returns a function that writes the light of a scene's medium at a time [s].
  FrameLoop::Write writing_lit(double time, const std::string& output) {
    check_interrupted();
    Scene scene = read_scene_at(time);
    scene.medium = simplified(scene.medium);
    return lit_splats(scene, exposure_, along(), y_down_, output);
  }

  // Returns a function that writes a medium, or what is left of it.
  FrameLoop::Write writing(const NumberedMedium& whole, const std::string& output) {
    check_interrupted();
    const Medium medium = simplified(whole.medium);
    if (lower_case_extension(output) == ".vdb") {
      const auto grids = std::make_shared<const Grids>(sampled_grids(medium, output));
      return [grids, output, half = half_] {
        write_volume(output, grids->density, half, grids->colors);
      };
    }
    std::vector<Gaussian> gaussians = medium.gaussians();
    std::vector<GaussianNumber> ids;  // of merged Gaussians there are none
    if (!(simplify_ > 0.0)) ids = whole.ids;
    if (!splats_) {
      return [gaussians = std::move(gaussians), ids = std::move(ids), output] {
        write_gaussians(output, gaussians, ids);
      };
    }
    return [gaussians = std::move(gaussians), ids = std::move(ids), output,
            splats = SplatOutput{along(), albedo_, {}, y_down_}] {
      SplatOutput with_ids = splats;
      with_ids.ids = ids;
      write_splats(output, gaussians, with_ids);
    };
  }

  struct Grids {
    DensityGrid density;
    VolumeColors colors;
  };

  // Reports their size in advance. All frames use the voxel size of the first non-empty one.
  Grids sampled_grids(const Medium& medium, const std::string& output) {
    if (!(voxel_size_ > 0.0)) voxel_size_ = fitting_voxel_size(medium);
    const double size = voxel_size_ > 0.0 ? voxel_size_ : 1.0;  // nothing to sample
    const auto plan = MediumSampling::plan(medium, size, max_blocks);
    if (!plan) refuse(medium, size);
    print_note("voxels of " + quoted_text(size) + ", " + in_megabytes(plan->bytes()) +
               " of memory");
    const auto sampled = [&](auto sample) {
      const ProgressLine line("sampling " + output);
      return finished(sample(line.progress()));
    };
    DensityGrid density =
        sampled([&](const auto& progress) { return plan->sample(interruption(), progress); });
    VolumeColors colors = sampled([&](const auto& progress) {
      return plan->sample_colors(albedo_, interruption(), progress);
    });
    return {std::move(density), std::move(colors)};
  }

  [[noreturn]] void refuse(const Medium& medium, double size) const {
    const auto sufficient = sufficient_voxel_size(medium, size, max_blocks);
    throw InputError(input_, "medium",
                     "a grid with voxels of " + quoted_text(size) + " needs more than " +
                         in_megabytes(max_bytes) + "; allowed: a larger --voxel" +
                         (sufficient ? ", of " + quoted_text(*sufficient) + " or more" : ""));
  }

  std::string input_;
  std::string output_;
  double voxel_size_ = 0.0;
  bool half_ = false;
  bool splats_ = false;
  bool lit_ = false;
  bool web_ = false;
  bool y_down_ = false;
  bool colors_ = false;
  double exposure_ = 0.0;  // [stops]
  std::string along_;      // empty: mean
  std::string up_;         // empty: y, or as --y-down says
  double simplify_ = 0.0;  // 0: not
  double time_ = 0.0;
  std::string frames_;
  std::optional<double> fps_;  // absent: the scene's
  CommandFiles files_;
  std::optional<Scene> scene_;  // once read
  glm::dvec3 albedo_{1.0};      // the medium's
};

}  // namespace

std::unique_ptr<Command> make_export_command(CLI::App& app) {
  return std::make_unique<ExportCommand>(app);
}

}  // namespace brume
