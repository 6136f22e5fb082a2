#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/number_domain.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"
#include "tools/brume/read_scene.h"
#include "tools/brume/submit/job_bundle.h"
#include "tools/brume/submit/slurm_submission.h"

namespace brume {
namespace {

class SubmitCommand final : public Command {
 public:
  explicit SubmitCommand(CLI::App& app) : options_(with_scheduler(app)) {
    app.add_option("--chunk", sequence_.chunk, "frames of a task")
        ->check(finite_in(1, 100'000))
        ->capture_default_str();
    app.add_option("--sbatch", slurm_.sbatch,
                   "an option of sbatch without its dashes, such as mem=4G; several times");
    app.add_option("--video", sequence_.video,
                   "an .mp4 of .png frames, made by ffmpeg when all are there")
        ->type_name("FILE");
    app.add_flag("--watch", slurm_.watches,
                 "wait for the frames, tell how many are done, and submit again what was lost");
    app.footer(
        "All options of brume render are those of the frames, which --skip-existing leaves "
        "alone where\nthey are current. slurm: the script and the logs of tasks lie beside the "
        "frames. openjd: a job\nbundle beside them is for whatever runs the Open Job Description.");
    sequence_.own_options = {"SCHEDULER", "chunk", "sbatch", "video", "watch"};
  }

  ExitCode run() override {
    options_.check();
    if (!options_.is_sequence()) throw UsageError("--frames is required: a farm makes sequences");
    sequence_.check_video();
    const bool is_slurm = scheduler_ == "slurm";
    if (!is_slurm && (slurm_.watches || !slurm_.sbatch.empty())) {
      throw UsageError("--watch and --sbatch are of slurm");
    }
    if (!options_.stats_file().empty()) {
      throw UsageError("--stats: all tasks would write it; allowed: for brume render");
    }
    sequence_.check_names();
    CommandFiles files = options_.outputs();
    std::vector<std::filesystem::path> missing;
    const SceneDocument document = read_document(options_.scene_file(), files, missing);
    sequence_.frames_per_second = options_.frame_rate(document.scene);
    if (is_slurm) {
      const FrameFingerprint fingerprint(
          document, options_.what_matters(document.scene, sequence_.own_options));
      return submit_to_slurm(sequence_, fingerprint, slurm_);
    }
    nlohmann::ordered_json result;
    result["bundle"] = write_job_bundle(sequence_, document).string();
    print_result(result.dump() + "\n");
    return done;
  }

 private:
  CLI::App& with_scheduler(CLI::App& app) {
    app.add_option("SCHEDULER", scheduler_, "whom it is handed to")
        ->type_name("TEXT:{slurm,openjd}")
        ->required()
        ->check(CLI::IsMember({"slurm", "openjd"}));
    return app;
  }

  std::string scheduler_;
  RenderOptions options_;
  SequenceJob sequence_{options_};
  SlurmOptions slurm_;
};

}  // namespace

std::unique_ptr<Command> make_submit_command(CLI::App& app) {
  return std::make_unique<SubmitCommand>(app);
}

}  // namespace brume
