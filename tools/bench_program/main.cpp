// brume-bench: what `brume bench` starts, with the arguments of that, under the name of that
// program.

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "core/io/disk/atomic_file.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/scene/scene_file.h"
#include "tools/bench/bench_run.h"
#include "tools/bench/report/bench_compare.h"
#include "tools/bench/report/bench_json.h"
#include "tools/bench/report/bench_pages.h"
#include "tools/bench/report/plots.h"
#include "tools/brume/command_files.h"
#include "tools/brume/program.h"
#include "tools/brume/request_arguments.h"

namespace brume {
namespace {

// The command for the report, without names that only this machine has.
std::string shown_command(bool quick, bool of_scenes, bool with_peers) {
  std::string command = "brume bench";
  if (quick) command += " --quick";
  if (of_scenes) command += " SCENE...";
  if (with_peers) command += " --peers peers.json";
  return command + " -o speed";
}

class BenchCommand final : public Command {
 public:
  explicit BenchCommand(CLI::App& app) {
    app.add_option("SCENE", scenes_, "scenes (.brume) instead of the built-in ones")
        ->type_name("FILE");
    app.add_option("-o,--output", output_, "writes NAME.md, NAME.json, NAME.html and NAME.svg");
    app.add_flag("--quick", quick_, "fewer settings and frames: two minutes on two cores");
    app.add_option("--threads", threads_, "worker threads; default: all")
        ->check(finite_in(1, 1024));
    app.add_option("--backend", backend_,
                   "measure OpenGL too: gl; cpu: do not; auto: if a GPU answers")
        ->type_name("TEXT:{auto,cpu,gl}")
        ->capture_default_str();
    app.add_option("--peers", peers_, "results of other renderers, from tools/compare-peers")
        ->type_name("FILE");
    app.add_option("--plot", plotted_, "the scene shown in NAME.svg; default: the first");
    app.add_option(
           "--compare", compare_,
           "compare with an older NAME.json; exit with 1 if anything is slower or less accurate")
        ->type_name("FILE");
    app.add_option("--save-scenes", folder_,
                   "only write the built-in scenes into this folder, as .brume")
        ->type_name("FOLDER");
  }

  ExitCode run() override {
    if (!folder_.empty()) return save_scenes();
    if (output_.empty()) throw UsageError("-o NAME is required");
    const auto file = [&](const char* extension) { return output_ + extension; };
    CommandFiles files;
    for (const char* extension : {".md", ".json", ".html", ".svg"}) {
      files.add_output(file(extension));
    }
    for (const std::string& input : inputs()) files.add_input(input);
    std::string old;
    if (!compare_.empty()) {
      old = read_bytes(compare_);
      check_report(compare_, old);  // before long work
    }
    RenderRequest request;
    set_option(request, "backend", backend_);
    BenchOptions options{.quick = quick_,
                         .threads = threads_,
                         .backend = request.backend,
                         .scenes = {scenes_.begin(), scenes_.end()},
                         .peers = {}};
    if (!peers_.empty()) options.peers = read_other_renderers(peers_);
    std::optional<tbb::global_control> bound;
    if (threads_ > 0) {
      bound.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(threads_));
    }
    for (const std::string& scene : scenes_)
      read_scene(scene, files);  // malformed ones fail before measuring, too
    BenchReport report = run_bench(options, print_note);
    report.command = shown_command(quick_, !scenes_.empty(), !peers_.empty());
    const std::string json = to_json(report);
    const std::string page = to_markdown(report);
    write_atomically(file(".json"), json);
    write_atomically(file(".html"), to_html(report));
    write_atomically(file(".md"), page);
    write_atomically(file(".svg"), frontier_plot(plotted(report), true));
    print_result(page);
    if (old.empty()) return done;
    const std::vector<std::string> worse = compare_reports(compare_, old, json);
    for (const std::string& line : worse) print_result(line + '\n');
    if (worse.empty()) print_result("nothing is slower or less accurate beyond the spread\n");
    return worse.empty() ? done : check_failed;
  }

 private:
  [[nodiscard]] std::vector<std::string> inputs() const {
    std::vector<std::string> files = scenes_;
    for (const std::string& file : {peers_, compare_}) {
      if (!file.empty()) files.push_back(file);
    }
    return files;
  }

  [[nodiscard]] const SceneReport& plotted(const BenchReport& report) const {
    const auto found = std::ranges::find(report.scenes, plotted_, &SceneReport::name);
    return found == report.scenes.end() ? report.scenes.front() : *found;
  }

  [[nodiscard]] ExitCode save_scenes() const {
    CommandFiles files;
    files.make_folder(folder_);
    for (const BenchScene& bench : built_in_scenes(quick_)) {
      // Data that is in no file cannot be referenced.
      if (!bench.scene.surfaces.empty() || bench.scene.environment) continue;
      save_document(bench.scene, std::filesystem::path(folder_) / (bench.name + ".brume"));
      print_result(bench.name + ".brume\n");
    }
    return done;
  }

  std::vector<std::string> scenes_;
  std::string output_;
  bool quick_ = false;
  int threads_ = 0;
  std::string backend_ = "auto";
  std::string peers_;
  std::string plotted_;
  std::string compare_;
  std::string folder_;
};

}  // namespace

}  // namespace brume

int main(int argc, char** argv) {
  using namespace brume;
  const std::array<Subcommand, 1> commands{{{"bench", bench_description, [](CLI::App& app) {
                                               return std::make_unique<BenchCommand>(app);
                                             }}}};
  return run_program(argc, argv, commands);
}
