// `brume bench` reports its measurements; a run of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "brume/error.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/mesh.h"
#include "render/renderer.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"
#include "tools/bench/measure/cache_gains.h"
#include "tools/bench/measure/measurement.h"
#include "tools/bench/measure/plan_decisions.h"
#include "tools/bench/report/bench_compare.h"
#include "tools/bench/report/bench_json.h"
#include "tools/bench/report/bench_pages.h"
#include "tools/bench/report/bench_tables.h"
#include "tools/bench/scenes/benchmark_meshes.h"
#include "tools/bench/scenes/benchmark_scenes.h"
#include "tools/bench/scenes/table_one_scenes.h"

namespace brume {
namespace {

using Json = nlohmann::json;

Measurement measured(double cpu, double error) {
  Measurement m;
  m.cpu_milliseconds = {cpu, 0.9 * cpu, 1.1 * cpu};
  m.error = {error, 0.9 * error, 1.1 * error, 100};
  return m;
}

TEST(Frontier, ContainsUndominatedSettings) {
  const std::vector<Measurement> all = {measured(10, 0.02), measured(5, 0.05), measured(12, 0.03),
                                        measured(20, 0.005), measured(5.5, 0.06)};
  EXPECT_EQ(frontier(all), (std::vector<std::size_t>{1, 0, 3}));
  EXPECT_EQ(cheapest_within(all, 0.1), 1u);
  EXPECT_EQ(cheapest_within(all, 0.0221), 0u);
  EXPECT_EQ(cheapest_within(all, 0.0219), 3u) << "the interval's upper end counts";
  EXPECT_EQ(cheapest_within(all, 0.001), std::nullopt);
}

TEST(Frontier, FitsExponents) {
  std::vector<CostPoint> points;
  for (const double n : {10.0, 30.0, 100.0, 1000.0}) points.push_back({n, 0.3 * std::pow(n, 1.2)});
  EXPECT_NEAR(fitted_exponent(points), 1.2, 1e-12);
}

std::string report(double cpu, double error) {
  const Json setting = {{"setting", "sliced 24"},
                        {"cpu_ms", {{"median", cpu}, {"min", 0.9 * cpu}, {"max", 1.1 * cpu}}},
                        {"error", {{"low", 0.9 * error}, {"high", 1.1 * error}}}};
  return Json{{"scenes", {{{"name", "a"}, {"size", {8, 8}}, {"settings", {setting}}}}},
              {"table_one", Json::array()}}
      .dump();
}

TEST(BenchCompare, ReportsRegressionsBeyondTheSpread) {
  const std::string old = report(10.0, 0.01);
  EXPECT_TRUE(compare_reports("old.json", old, report(12.0, 0.012)).empty());
  EXPECT_TRUE(compare_reports("old.json", old, report(5.0, 0.005)).empty());
  const auto slower = compare_reports("old.json", old, report(14.0, 0.01));
  ASSERT_EQ(slower.size(), 1u);
  EXPECT_EQ(slower[0], "a, sliced 24: slower, now at least 12.6 ms, before at most 11.0 ms");
  const auto worse = compare_reports("old.json", old, report(10.0, 0.02));
  ASSERT_EQ(worse.size(), 1u);
  EXPECT_EQ(worse[0], "a, sliced 24: less accurate, now at least 1.80%, before at most 1.10%");
  EXPECT_THROW(compare_reports("old.json", "{}", old), InputError);
  EXPECT_THROW(compare_reports("old.json", "no json", old), InputError);
}

TEST(BenchCompare, ComparesErrorRowsWithOldOnes) {
  for (const char* section : {"patches", "noise", "lamp_light", "arriving_light", "transfer"}) {
    const auto with_row = [&](const char* what, double error) {
      Json json = Json::parse(report(10.0, 0.01));
      json[section] = {{{"what", what}, {"error", {{"low", 0.9 * error}, {"high", 1.1 * error}}}}};
      return json.dump();
    };
    const std::string old = with_row("a ball", 0.01);
    EXPECT_TRUE(compare_reports("old.json", old, with_row("a ball", 0.012)).empty());
    EXPECT_TRUE(compare_reports("old.json", old, with_row("a floor", 0.02)).empty());
    EXPECT_TRUE(compare_reports("old.json", report(10.0, 0.01), old).empty());
    const auto worse = compare_reports("old.json", old, with_row("a ball", 0.02));
    ASSERT_EQ(worse.size(), 1u) << section;
    EXPECT_EQ(worse[0], "a ball: less accurate, now at least 1.80%, before at most 1.10%");
  }
}

// --compare reads what is written.
TEST(BenchCompare, RoundTripsReports) {
  const auto json = [](double error) {
    BenchReport written;
    const ErrorEstimate estimate{error, 0.9 * error, 1.1 * error, 9};
    for (auto rows : {&BenchReport::patches, &BenchReport::noise, &BenchReport::point_light,
                      &BenchReport::incident_light, &BenchReport::transfer}) {
      (written.*rows).push_back({"a ball", estimate, estimate});
    }
    return to_json(written);
  };
  EXPECT_EQ(compare_reports("old.json", json(0.01), json(0.02)).size(), 5u);
  EXPECT_TRUE(compare_reports("old.json", json(0.02), json(0.01)).empty());
}

// A cache of 30 lines that changes pictures.
CacheGain cached(const char* cache, const char* scene, double gain) {
  return {cache,
          scene,
          {30, "shadow_map"},
          {20.0, 19.0, 21.0},
          {22.0, 21.0, 23.0},
          {30.0, 28.0, 33.0},
          {gain, gain - 0.01, gain + 0.02},
          1e-6};
}

TEST(BenchCompare, ComparesFramesWithCaches) {
  const auto json = [](double cpu) {
    BenchReport written;
    written.caches = {cached("shadow maps", "statue", 0.3), cached("shadow maps", "box", 0.3)};
    written.caches[1].with_cpu_ms = {cpu, 0.9 * cpu, 1.1 * cpu};
    return to_json(written);
  };
  EXPECT_TRUE(compare_reports("old.json", json(10.0), json(12.0)).empty());
  EXPECT_TRUE(compare_reports("old.json", report(10.0, 0.01), json(12.0)).empty());
  const auto slower = compare_reports("old.json", json(10.0), json(14.0));
  ASSERT_EQ(slower.size(), 1u);
  EXPECT_EQ(slower[0], "box, shadow maps: slower, now at least 12.6 ms, before at most 11.0 ms");
}

// A cache has to give a quarter in one scene, or to be small and change nothing.
TEST(CacheTable, NamesCachesThatGiveTooLittle) {
  const auto says = [](const std::vector<CacheGain>& gains, const std::string& text) {
    return cache_table(gains).remark.find(text) != std::string::npos;
  };
  const CacheGain much = cached("a", "statue", 0.3);
  const CacheGain little = cached("a", "box", 0.1);
  CacheGain small = cached("b", "box", 0.1);
  small.code.lines = 19;
  small.change = 0.0;
  CacheGain changed = small;
  changed.scene = "statue";
  changed.change = 1e-6;
  EXPECT_TRUE(says({little, much}, "Too little: none.")) << "it is enough in one scene";
  EXPECT_TRUE(says({little, much}, "without effect: none."));
  EXPECT_TRUE(says({little, small}, "Too little: a."));
  EXPECT_TRUE(says({little, small}, "without effect: b."));
  EXPECT_TRUE(says({small, changed}, "Too little: b."));
}

TEST(Quartiles, InterpolateValues) {
  const Quartiles q = quartiles_of({4.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(q.median, 2.5);
  EXPECT_EQ(q.lower, 1.75);
  EXPECT_EQ(q.upper, 3.25);
  EXPECT_EQ(quartiles_of({7.0}).upper, 7.0);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(BenchTables, AppearInMarkdownAndHtml) {
  BenchReport report;
  SceneReport& scene = report.scenes.emplace_back();
  scene.name = "fog & mist";
  scene.settings.push_back(measured(10, 0.02));
  report.thickness.push_back(
      {0.1, 1.0, {0.031, 0.028, 0.036, 9}, {0.015, 0.014, 0.016, 9}, {0.0003, 0.0002, 0.0004, 9}});
  report.skies.push_back({30, 3.0, 0.6, {0.005, 0.004, 0.006, 9}, {0.007, 0.006, 0.008, 9}});
  const ErrorEstimate small{0.011, 0.01, 0.012, 9};
  const ErrorEstimate large{1.52, 0.96, 2.08, 9};
  report.patches.push_back({"turning fog", small, {}});
  report.glow.push_back({1.0, 0.62});
  report.scales.push_back({"statue", 4, 0.0964, 0.00704});
  report.all_orders.push_back(
      {"room", 2.9, 0.039, 0.044, 8, 950.0, 210.0, {1.02, 0.99, 1.1}, 61.0});
  report.light_kinds.push_back({"sun", 0.0042, {1.1, 0.9, 1.2}, {1.3, 1.2, 1.4}});
  report.noise_depths.push_back({2.0, {-0.0031, -0.0168, 0.0171}, {0.0, -0.02, 0.029}});
  report.noise.push_back({"torn fog", small, large});
  report.point_light.push_back({"lit ball", small, large});
  report.incident_light.push_back({"under a sky", small, large});
  report.transfer.push_back({"floor", small, large});
  report.transfer.push_back({"bowl", large, {}});
  report.curves.push_back({"lights", {{1.0, 2.0}, {10.0, 30.0}}, 1.2});
  report.thread_rows.push_back({1, {4.0, 3.0, 5.0}});
  report.fog_banks.push_back({1'000'000, 160'000, measured(30, 0.018), {2.5, 2.4, 2.7}});
  report.savings.push_back({Stage::noise, "its amplitude is 0", {1, 1, 1}, {2, 2, 2}, 1e-8});
  report.hard_cases.emplace_back().hard_case.breaks = "x < y";
  report.table_one.push_back({"statue", 101.0, measured(20, 0.01), {1.08, 1.01, 1.2}});
  report.caches = {cached("shadow maps", "statue", 0.3), cached("shadow maps", "box", 0.1)};
  const std::vector<ReportTable> tables = bench_tables(report);
  EXPECT_EQ(tables.size(), 20u);
  const std::string page = to_markdown(report);
  const std::string html = to_html(report);
  for (const ReportTable& table : tables) {
    if (!table.title.empty()) {
      EXPECT_EQ(count(page, "## " + table.title + "\n"), 1u) << table.title;
      EXPECT_EQ(count(html, "<h2>" + table.title + "</h2>"), 1u) << table.title;
    }
    EXPECT_FALSE(table.title.empty() && table.lead.empty());
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.heads.size()) << table.lead;
  }
  for (const char* row :
       {"turning fog | 1.1% (1 to 1.2)", "1 | 62%", "statue | 4 | 9.6% | 0.7%",
        "2 | -0.31% (-1.7 to +1.7) | +0% (-2 to +2.9)",
        "torn fog | 1.1% (1 to 1.2) | 152% (96 to 208)",
        "lit ball | 1.1% (1 to 1.2) | 152% (96 to 208)",
        "under a sky | 1.1% (1 to 1.2) | 152% (96 to 208)",
        "floor | 1.1% (1 to 1.2) | 152% (96 to 208)", "bowl | 152% (96 to 208) |",
        "shadow maps | box | 20.0 (19.0 to 21.0) | 22.0 (21.0 to 23.0) | 10% (9 to 12) | 30 | "
        "shadow_map | 1e-06"}) {
    EXPECT_EQ(count(page, std::string("\n| ") + row + " |\n"), 1u) << row;
  }
  EXPECT_TRUE(contains(page, " | 1.08 (1.01 to 1.20) |")) << "Table 1, all orders";
  EXPECT_EQ(count(html, "<td>1.1% (1 to 1.2)<td>152% (96 to 208)"), 4u);
  EXPECT_TRUE(
      contains(page, "| 0.1 | 1 | 3.1% (2.8 to 3.6) | 1.5% (1.4 to 1.6) | 0.03% (0.02 to 0.04) |"));
  EXPECT_EQ(count(html, "<td>3.1% (2.8 to 3.6)"), 1u);
  EXPECT_EQ(count(html, "x &lt; y"), 1u);
  EXPECT_EQ(count(html, "x < y"), 0u);
  EXPECT_EQ(count(html, "`"), 0u) << "code";
}

TEST(TableOne, ScenesHaveTheSizesThatThePaperStates) {
  for (const TableOneScene& kind : table_one_scenes) {
    const Scene scene = kind.make();
    std::size_t vertices = 0;
    for (const Surface& surface : scene.surfaces) vertices += surface.mesh->n_vertices();
    EXPECT_EQ(vertices, kind.vertices) << kind.name;
    EXPECT_EQ(scene.medium.size(), kind.gaussians) << kind.name;
  }
}

using BenchCommand = CommandLine;

TEST_F(BenchCommand, WritesAReport) {
  const ProgramResult result =
      expect_done({"bench", "--quick", scene_, "-o", file("report"), "--threads", "2"});
  EXPECT_TRUE(contains(result.out, "| a: 2 Gaussians |"));
  EXPECT_EQ(content_of(file("report.md")), result.out);
  EXPECT_TRUE(content_of(file("report.svg")).starts_with("<svg "));
  const Json json = Json::parse(content_of(file("report.json")));
  EXPECT_EQ(json["threads"], 2);
  ASSERT_EQ(json["scenes"].size(), 1u);
  const Json& settings = json["scenes"][0]["settings"];
  EXPECT_GT(settings.size(), 10u);
  double min_error = 1.0;
  for (const Json& setting : settings) {
    EXPECT_GT(setting["cpu_ms"]["min"].get<double>(), 0.0) << setting;
    EXPECT_LE(setting["cpu_ms"]["min"], setting["cpu_ms"]["median"]) << setting;
    EXPECT_LE(setting["error"]["low"], setting["error"]["high"]) << setting;
    min_error = std::min(min_error, setting["error"]["rel_rmse"].get<double>());
  }
  EXPECT_LT(min_error, 0.01);
  EXPECT_EQ(settings[0]["setting"], "paper");
  EXPECT_GT(settings[0]["error"]["rel_rmse"], 0.02);
  const std::string html = content_of(file("report.html"));
  EXPECT_TRUE(contains(html, "<svg", "data:image/png;base64,"));
  EXPECT_FALSE(contains(html, ">nan"));

  // A report is at least as good as itself.
  const std::string old = content_of(file("report.json"));
  EXPECT_TRUE(compare_reports("report.json", old, old).empty());
}

TEST_F(BenchCommand, PutsOtherProgramsBeside) {
  const Json row = {{"scene", "a"},          {"size", {24, 18}},       {"program", "Other"},
                    {"setting", "7 grains"}, {"cpu_seconds", 123.456}, {"rel_rmse", 0.019}};
  folder_.write("peers.json", Json{{"peers", {row}}}.dump());
  const ProgramResult result = expect_done(
      {"bench", "--quick", scene_, "-o", file("report"), "--peers", file("peers.json")});
  EXPECT_TRUE(contains(result.out, "| Other | 7 grains | 123.46 s | 1.9% |"));
  EXPECT_TRUE(contains(content_of(file("report.svg")), "Other"));
  const Json json = Json::parse(content_of(file("report.json")));
  EXPECT_EQ(json["scenes"][0]["peers"][0]["cpu_ms"], 123456.0);

  folder_.write("peers.json", R"({"peers": [{"scene": "a"}]})");
  expect_refused({"bench", "-o", file("report"), "--peers", file("peers.json")},
                 {"peers.json", "compare-peers"});
}

TEST_F(BenchCommand, SavesItsScenes) {
  const std::string folder = file("scenes");
  std::filesystem::create_directory(folder);
  // A name of a subcommand may be a name of a file.
  expect_done({"bench", "-o", "fit", "--save-scenes", folder});
  const Scene scene = load_scene(folder + "/cloud_300_depth_3.brume");
  EXPECT_EQ(scene.medium.size(), 300u);
  EXPECT_EQ(scene.film, (Film{200, 150}));
}

TEST_F(BenchCommand, RefusesBeforeLongWork) {
  expect_refused({"bench", "--quick"}, {"-o"});
  expect_refused({"bench", "-o", file("floor.obj/report")}, {"floor.obj"});
  expect_refused({"bench", "-o", file("report"), "--compare", scene_}, {scene_, "not a report"});
  // Reports that lack what shows only as two of them are compared.
  for (const char* report :
       {"", R"({"scenes": [], "table_one": [{"name": "box"}]})",
        R"({"scenes": [{"name": "a", "size": [24, 18], "settings": [{"setting": "paper"}]}],
            "table_one": []})",
        R"({"scenes": [], "table_one": [], "noise": [{"what": "n", "error": {"low": 1}}]})",
        R"({"scenes": [], "table_one": [{"name": "box", "cpu_ms": {"min": "1", "max": 2},
            "error": {"low": 0, "high": 1}}]})"}) {
    const std::string old = folder_.write("old.json", report);
    expect_refused({"bench", "--quick", scene_, "-o", file("report"), "--compare", old},
                   {old, "not a report"});
  }
}

// That a cache is displaced when `brume bench` measures frames without it, and nothing else.

// Everything that is cached: a glossy ball with radiance transfer in a cloud, under a sky and a
// light.
MovingView view_of_all() {
  MovingView view;
  view.name = "ball";
  Scene& scene = view.scene;
  scene = cloud(30, 1.0);
  scene.film = {32, 24};
  MeshBuilder ball;
  ball.ellipsoid({0.3, -0.4, 0.2}, glm::dvec3(0.5), 8);
  Surface& surface = scene.surfaces.emplace_back();
  surface.mesh = ball.finish();
  surface.transfer = Surface::Transfer::shadow;
  surface.material.type = Material::Type::phong;
  surface.material.specular = glm::dvec3(0.3);
  surface.material.exponent = 20.0;
  scene.environment.emplace().map = gradient_sky();
  const auto transfers = std::make_shared<TransferStore>();
  transfers->make(needed_transfers(scene), {});
  view.transfers = transfers;
  view.settings = sliced_settings({}, 8);
  return view;
}

// Enough Gaussians to be merged.
MovingView bank_view(bool in_motion) {
  MovingView view{"bank", fog_bank(30'000), nullptr, sliced_settings({}, 8)};
  view.scene.film = {32, 24};
  view.motion.has_own_medium = in_motion;
  return view;
}

TEST(CacheGains, HaveARowPerCache) {
  std::vector<CacheGain> gains;
  for (const MovingView& view : {view_of_all(), bank_view(false), bank_view(true)}) {
    for (CacheGain& gain : measure_caches(view, 1)) gains.push_back(std::move(gain));
  }
  std::set<std::string> names;
  for (const CacheGain& gain : gains) {
    names.insert(gain.cache);
    EXPECT_GT(gain.with_ms.median, 0.0) << gain.cache;
    EXPECT_GT(gain.with_cpu_ms.median, 0.0) << gain.cache;
    EXPECT_TRUE(std::isfinite(gain.gain.median)) << gain.cache;
    EXPECT_GT(gain.code.lines, 0) << gain.cache;
    if (gain.cache == "merged medium, where edits are followed") continue;
    EXPECT_EQ(gain.change, 0.0) << gain.cache;
  }
  EXPECT_EQ(names.size(), frame_caches().size());
}

TEST(CacheGains, LeaveOutCachesThatAreNotUsed) {
  MovingView view = view_of_all();
  view.scene.surfaces.clear();
  view.scene.environment.reset();
  for (const CacheGain& gain : measure_caches(view, 1)) {
    EXPECT_TRUE(gain.cache.find("medium") != std::string::npos ||
                gain.cache.find("optical depth") != std::string::npos)
        << gain.cache;
  }
}

// Optical depth tables are made again where they or what they are made from is displaced, and only
// there.
TEST(CacheGains, DisplaceTheirOwnCache) {
  const MovingView view = view_of_all();
  Renderer renderer(view.transfers);
  for (const FrameCache& cache : frame_caches()) {
    if (cache.method != AirlightMethod::sliced) continue;  // the others have none
    const Settings& settings = view.settings;
    const Scene& scene = view.scene;
    const auto pairs = [&] {
      return renderer.render(scene, scene.camera, scene.film, settings)->statistics.light_pairs;
    };
    static_cast<void>(pairs());
    EXPECT_EQ(pairs(), 0u) << cache.name;
    Scene other_scene = scene;
    Settings other_settings = settings;
    cache.displace(other_scene, other_settings);
    static_cast<void>(renderer.render(other_scene, scene.camera, scene.film, other_settings));
    const bool concerns_tables =
        cache.name == "index of the medium" || cache.stage == Stage::light_table;
    EXPECT_EQ(pairs() > 0, concerns_tables) << cache.name;
  }
}

}  // namespace

}  // namespace brume
