#include <iostream>

#include "core/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "tools/bench/bench_compare.h"
#include "tools/bench/bench_html.h"
#include "tools/bench/bench_json.h"
#include "tools/bench/bench_run.h"
#include "tools/brume/command.h"
#include "tools/brume/finite_in.h"

namespace brume {
namespace {

class BenchCommand final : public Command {
 public:
  explicit BenchCommand(CLI::App& app) {
    app.add_option("SCENE", scenes_, "scenes, .brume, in place of the built-in ones");
    app.add_option("-o,--output", output_, "NAME.json and NAME.html are written")->required();
    app.add_flag("--quick", quick_, "fewer settings and frames: two minutes on two cores");
    app.add_option("--threads", threads_, "worker threads, by default all there are")
        ->check(finite_in(1, 1024));
    app.add_option("--compare", compare_,
                   "an older NAME.json: says what got slower or less accurate, and fails if so");
  }

  ExitCode run() override {
    const std::string json_file = output_ + ".json";
    const std::string html_file = output_ + ".html";
    check_writable(json_file);
    check_writable(html_file);
    std::string old;
    if (!compare_.empty()) {
      old = read_bytes(compare_);
      compare_reports(compare_, old, R"({"scenes": [], "table_one": []})");  // before long work
    }
    BenchOptions options{quick_, threads_, {scenes_.begin(), scenes_.end()}};
    const BenchReport report = run_bench(
        options, [](const std::string& what) { std::cerr << "brume: " << what << std::endl; });
    const std::string json = to_json(report);
    write_atomically(json_file, json);
    write_atomically(html_file, to_html(report, quick_ ? "brume bench --quick" : "brume bench"));
    print_result(table(report));
    if (old.empty()) return done;
    const std::vector<std::string> worse = compare_reports(compare_, old, json);
    for (const std::string& line : worse) print_result(line + '\n');
    if (worse.empty()) print_result("nothing is slower or less accurate beyond the spread\n");
    return worse.empty() ? done : check_failed;
  }

 private:
  // For each scene and error the fastest setting.
  static std::string table(const BenchReport& report) {
    std::string text;
    const auto line = [&](const char* format, auto... arguments) {
      char buffer[256];
      std::snprintf(buffer, sizeof buffer, format, arguments...);
      text += buffer;
    };
    for (const SceneReport& scene : report.scenes) {
      line("%s: %zu Gaussians, reference %.0f ms CPU\n", scene.name.c_str(), scene.gaussians,
           scene.reference_cpu_milliseconds);
      for (const double level : bench_error_levels) {
        const auto best = cheapest_within(scene.settings, level);
        if (best) {
          const Measurement& m = scene.settings[*best];
          line("  %5.1f%%  %-18s %9.2f ms CPU (%.2f to %.2f)  %.2f%%\n", 100.0 * level,
               m.setting.c_str(), m.cpu_milliseconds.median, m.cpu_milliseconds.least,
               m.cpu_milliseconds.greatest, 100.0 * m.error.rel_rmse);
        } else {
          line("  %5.1f%%  none\n", 100.0 * level);
        }
      }
    }
    for (const CostCurve& curve : report.curves) {
      line("CPU time over %s: power %.2f\n", curve.over.c_str(), curve.exponent);
    }
    for (const TableOneRow& row : report.table_one) {
      line("Table 1, %s: %.1f frames per second (paper: %.0f), %s, %.2f%%\n", row.name.c_str(),
           1e3 / row.measurement.milliseconds.median, row.paper_fps,
           row.measurement.setting.c_str(), 100.0 * row.measurement.error.rel_rmse);
    }
    return text;
  }

  std::vector<std::string> scenes_;
  std::string output_;
  bool quick_ = false;
  int threads_ = 0;
  std::string compare_;
};

}  // namespace

std::unique_ptr<Command> make_bench_command(CLI::App& app) {
  return std::make_unique<BenchCommand>(app);
}

}  // namespace brume
