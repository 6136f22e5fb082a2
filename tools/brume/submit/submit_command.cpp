#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "core/io/scene/scene_document.h"
#include "core/io/scene/scene_files.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "tools/brume/command.h"
#include "tools/brume/command_files.h"
#include "tools/brume/request_arguments.h"
#include "tools/brume/submit/sequence_job.h"
#include "tools/brume/submit/slurm_submission.h"

namespace brume {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t max_text = 1024;  // of a parameter, by the schema

// A folder or file, which a farm maps to where it has it.
class Paths {
 public:
  // The text for it in a template.
  std::string add(const char* name, const char* description, const char* type, const char* flow,
                  const fs::path& path) {
    definitions.push_back({{"name", name},
                           {"type", "PATH"},
                           {"objectType", type},
                           {"dataFlow", flow},
                           {"description", description}});
    values.push_back({{"name", name}, {"value", path.string()}});
    return std::string("{{Param.") + name + "}}";
  }

  Json definitions = Json::array();
  Json values = Json::array();
};

fs::path absolute_path(const fs::path& path) {
  return fs::absolute(path).lexically_normal();
}

void check_literal(const std::string& text) {
  if (text.find("{{") == std::string::npos) return;
  throw UsageError("found " + quoted_text(text) +
                   "; allowed in a template: names and values without {{");
}

void warn_of_files_elsewhere(const SceneDocument& document, const fs::path& folder) {
  const std::vector<fs::path> files = files_outside(document, folder);
  if (files.empty()) return;
  print_warnings({"a farm that copies files copies the folder of the scene only, without " +
                  files.front().string() + "; brume gather puts all into one folder"});
}

// Stops a task so that it leaves no part of a frame.
Json cancelation() {
  return {{"mode", "NOTIFY_THEN_TERMINATE"}, {"notifyPeriodInSeconds", 10}};
}

Json action(std::vector<std::string> command) {
  Json run;
  run["command"] = command.front();
  command.erase(command.begin());
  run["args"] = std::move(command);
  run["cancelation"] = cancelation();
  return {{"actions", {{"onRun", std::move(run)}}}};
}

// That of a task, whose paths are parameters.
std::vector<std::string> render_command(const SequenceJob& sequence, const fs::path& scene,
                                        const fs::path& output, Paths& paths) {
  const std::string scene_folder =
      paths.add("SceneFolder", "the scene and its files", "DIRECTORY", "IN", scene.parent_path());
  const std::string frame_folder =
      paths.add("FrameFolder", "the frames", "DIRECTORY", "OUT", output.parent_path());
  std::vector<std::string> command{"{{Param.Brume}}", "render"};
  for (const std::string& argument : sequence.options.arguments(sequence.own_options)) {
    check_literal(argument);
    if (argument == scene) {
      command.push_back(scene_folder + "/" + scene.filename().string());
    } else if (argument == output) {
      command.push_back(frame_folder + "/" + output.filename().string());
    } else if (argument == sequence.options.color_config_file()) {
      command.push_back(
          paths.add("ColorConfig", "the OpenColorIO configuration", "FILE", "IN", argument));
    } else {
      command.push_back(argument);
    }
  }
  command.insert(command.end(),
                 {"--frames", "{{Task.Param.Frame}}", "--skip-existing", "--progress", "openjd"});
  return command;
}

// Writes a job of the Open Job Description, the template schema 2023-09 with its extension
// TASK_CHUNKING (github.com/OpenJobDescription/openjd-specifications): a folder beside the frames
// with template.json, whose paths are parameters, and their values as AWS Deadline Cloud reads
// them, parameter_values.json. Its frames are those of the sequence, in any order. Returns the
// folder. Throws UsageError where an option cannot be part of a template, InputError where a file
// cannot be written.
fs::path write_job_bundle(const SequenceJob& sequence, const SceneDocument& document) {
  const fs::path scene = absolute_path(sequence.options.scene_file());
  const fs::path output = sequence.output();
  warn_of_files_elsewhere(document, scene.parent_path());

  std::vector<int> frames = sequence.options.frames();
  std::ranges::sort(frames);
  const std::string range = frames_text(frames, ':');
  if (range.size() > max_text) {
    throw UsageError("--frames: found " + quoted_text(range) +
                     "; allowed in a template: what takes at most " + std::to_string(max_text) +
                     " characters");
  }

  Paths paths;
  std::vector<std::string> command = render_command(sequence, scene, output, paths);
  const Json frame{
      {"name", "Frame"},
      {"type", "CHUNK[INT]"},
      {"range", "{{Param.Frames}}"},
      {"chunks",
       {{"defaultTaskCount", "{{Param.FramesPerTask}}"}, {"rangeConstraint", "NONCONTIGUOUS"}}}};
  Json render{{"name", "Render"},
              {"parameterSpace", {{"taskParameterDefinitions", Json::array({frame})}}},
              {"script", action(std::move(command))}};
  Json steps = Json::array({std::move(render)});
  if (!sequence.video.empty()) {
    // A folder that a farm maps is not escaped.
    if (output.parent_path().string().find('%') != std::string::npos) {
      throw UsageError("--video: found " + quoted_text(output.string()) +
                       "; allowed: frames in a folder without %");
    }
    const std::string file =
        paths.add("Video", "the film of the frames", "FILE", "OUT", absolute_path(sequence.video));
    steps.push_back(
        {{"name", "Video"},
         {"dependencies", Json::array({{{"dependsOn", "Render"}}})},
         {"script", action(sequence.video_command(
                        "{{Param.FrameFolder}}/" +
                            FramePattern::parse(output.filename().string())->printf_text(),
                        file))}});
  }
  Json definitions = std::move(paths.definitions);
  definitions.push_back(
      {{"name", "Frames"}, {"type", "STRING"}, {"description", "as 1-9:2,12"}, {"default", range}});
  definitions.push_back(
      {{"name", "FramesPerTask"}, {"type", "INT"}, {"minValue", 1}, {"default", sequence.chunk}});
  definitions.push_back({{"name", "Brume"},
                         {"type", "STRING"},
                         {"description", "the program, as workers find it"},
                         {"default", "brume"}});
  const Json job{{"specificationVersion", "jobtemplate-2023-09"},
                 {"extensions", Json::array({"TASK_CHUNKING"})},
                 {"name", "Brume " + sequence.stem()},
                 {"parameterDefinitions", std::move(definitions)},
                 {"steps", std::move(steps)}};

  const fs::path folder = output.parent_path() / (sequence.stem() + ".openjd");
  std::error_code error;
  fs::create_directory(folder, error);  // what cannot be written there says why
  write_atomically(folder / "template.json", job.dump(2) + "\n");
  Json values;
  values["parameterValues"] = std::move(paths.values);
  write_atomically(folder / "parameter_values.json", values.dump(2) + "\n");
  return folder;
}

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
    const SceneDocument document = read_document(options_.scene_file(), files, &missing);
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
