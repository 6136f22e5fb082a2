#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "brume/error.h"
#include "brume/render.h"
#include "brume/request_options.h"
#include "render/request.h"
#include "tests/contains.h"
#include "tests/render/test_scenes.h"

namespace brume {
namespace {

constexpr Film small{48, 36};
const RenderRequest once{.film = small,
                         .airlight = AirlightMethod::sliced,
                         .scattering = Scattering::single,
                         .backend = Backend::cpu};

TEST(SceneRenderer, TellsErrorAndMethod) {
  const Scene scene = cloud_scene(20, 1.0);
  const Frame frame = *render(scene, {.film = small, .max_error = 0.05, .backend = Backend::cpu});
  ASSERT_TRUE(frame.error);
  EXPECT_LE(frame.error->rel_rmse, 0.05);
  EXPECT_TRUE(frame.statistics.airlight.starts_with("sliced:")) << frame.statistics.airlight;

  EXPECT_FALSE(render(scene, once)->error);
  RenderRequest measured = once;
  measured.error = ErrorMeasurement::full;
  const Frame sliced = *render(scene, measured);
  ASSERT_TRUE(sliced.error);
  EXPECT_EQ(sliced.airlight, render(scene, once)->airlight);
  measured.airlight = AirlightMethod::reference;
  EXPECT_FALSE(render(scene, measured)->error);
}

TEST(SceneRenderer, TheRequestOfAFrameMakesItAgain) {
  const Scene scene = cloud_scene(20, 1.0);
  const Frame frame = *render(scene, {.film = small, .max_error = 0.05, .backend = Backend::cpu});
  EXPECT_EQ(frame.request->airlight, AirlightMethod::sliced);
  const Frame again = *render(scene, *frame.request);
  EXPECT_FALSE(again.error) << "nothing is left to choose";
  EXPECT_EQ(again.beauty, frame.beauty);
  EXPECT_EQ(again.statistics.airlight, frame.statistics.airlight);
}

TEST(SceneRenderer, AutoMeasuresNoErrorWhereNoneIsAskedFor) {
  const Scene scene = cloud_scene(20, 1.0);
  RenderRequest request{.film = small, .max_error = 0.05, .error = ErrorMeasurement::none};
  request.backend = Backend::cpu;
  const Frame frame = *render(scene, request);
  EXPECT_FALSE(frame.error);
  EXPECT_TRUE(frame.statistics.airlight.starts_with("sliced:"));
}

TEST(SceneRenderer, GroupsAreAppliedOnceForManyFrames) {
  Scene scene = cloud_scene(20, 1.0);
  Gaussian grouped{{0.2, 0.1, 0.0}, 0.5, 1.0};
  grouped.group = 1;
  scene.medium.append(grouped);
  scene.groups.push_back({.id = 1, .name = "a", .density_factor = 0.5});
  scene.camera_keys.eye = {{.time = 0.0, .value = {0, 0, 5}}, {.time = 1.0, .value = {1, 0, 5}}};
  SceneRenderer renderer;
  RenderRequest request = once;
  EXPECT_GT(renderer.render(scene, request)->statistics.light_pairs, 0u);
  request.time = 0.5;
  const Frame second = *renderer.render(scene, request);
  EXPECT_EQ(second.beauty, render(scene, request)->beauty);
  EXPECT_EQ(second.statistics.light_pairs, 0u) << "the light's table is that of the first frame";
  scene.groups[0].density_factor = 2.0;
  EXPECT_EQ(renderer.render(scene, request)->beauty, render(scene, request)->beauty);
}

TEST(SceneRenderer, FramesDoNotDependOnThoseBefore) {
  SceneRenderer renderer;
  const Scene first = cloud_scene(20, 1.0, 1);
  const Scene second = cloud_scene(20, 1.0, 2);
  const Frame alone = *render(second, once);
  static_cast<void>(renderer.render(first, once));
  EXPECT_EQ(renderer.render(second, once)->beauty, alone.beauty);
}

TEST(SceneRenderer, RendersWhatWasWrittenToTheColumns) {
  Scene scene = cloud_scene(20, 1.0);
  SceneRenderer renderer;
  const Frame before = *renderer.render(scene, once);
  for (double& density : scene.medium.columns().densities) density *= 2.0;
  const Frame after = *renderer.render(scene, once);
  EXPECT_NE(before.airlight, after.airlight);
  EXPECT_EQ(after.airlight, render(scene, once)->airlight);
}

TEST(SceneRenderer, ShutterBlursWhatACameraWithKeysSees) {
  Scene scene;
  scene.camera = {{0, 0, 3}, {0, 0, 0}, {0, 1, 0}, 40.0};
  scene.camera_keys.target = {{.time = 0.0, .value = {0, 0, 0}}, {.time = 1.0, .value = {1, 0, 0}}};
  scene.lights.push_back({.position = {0, 0, 3}, .intensity = {20, 20, 20}});
  scene.surfaces.push_back(wall(0.0, 0.5));
  scene.playback = Playback{.frames_per_second = 2.0};
  RenderRequest request = once;
  request.time = 0.25;
  // Pixels of the middle row that are neither in nor out.
  const auto partial = [&] {
    const Frame frame = *render(scene, request);
    int count = 0;
    for (int x = 0; x < small.width; ++x) {
      const float alpha = frame.beauty[static_cast<std::size_t>(4 * (18 * small.width + x) + 3)];
      count += static_cast<int>(alpha > 0.05f && alpha < 0.95f);
    }
    return count;
  };
  const int sharp = partial();
  request.shutter = Shutter{0.0, 0.5};
  EXPECT_GE(partial(), sharp + 4);
  // Nothing moves in front of a camera that is given.
  request.camera = scene.camera;
  EXPECT_LE(partial(), sharp + 1);
}

TEST(SceneRenderer, GivesTheLayersAskedFor) {
  RenderRequest request = once;
  EXPECT_TRUE(render(cloud_scene(5, 1.0), request)->layers.channels.empty());
  request.layers.lights = true;
  const Frame frame = *render(cloud_scene(5, 1.0), request);
  EXPECT_EQ(frame.layers.channels.count("airlight.light_1.R"), 1u);
}

TEST(SceneRenderer, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(render(cloud_scene(20, 1.0), once, stop.get_token()));
  std::stop_source later;
  EXPECT_FALSE(render(cloud_scene(200, 3.0), {.film = Film{400, 300}, .backend = Backend::cpu},
                      later.get_token(), [&](double done) {
                        if (done > 0.1) later.request_stop();
                      }));
}

TEST(SceneRenderer, RefusesWhatCannotBeAsked) {
  const struct {
    const char* place;
    std::function<void(RenderRequest&)> spoil;
  } cases[] = {
      {"film.width",
       [](RenderRequest& r) {
         r.film = Film{0, 10};
       }},
      {"camera.vertical_fov", [](RenderRequest& r) { r.camera = Camera{.vertical_fov = 0.0}; }},
      {"time", [](RenderRequest& r) { r.time = std::nan(""); }},
      {"max_error", [](RenderRequest& r) { r.max_error = 0.0; }},
      {"slices", [](RenderRequest& r) { r.slices = 1; }},
      {"paths", [](RenderRequest& r) { r.paths = 0; }},
      {"samples", [](RenderRequest& r) { r.samples = 0; }},
      {"shutter",
       [](RenderRequest& r) {
         r.shutter = Shutter{0.5, 0.5};
       }},
      {"threads", [](RenderRequest& r) { r.threads = -1; }},
  };
  for (const auto& [place, spoil] : cases) {
    RenderRequest request = once;
    spoil(request);
    std::string text;
    try {
      static_cast<void>(render(Scene{}, request));
    } catch (const DomainError& error) {
      text = error.what();
    }
    EXPECT_TRUE(text.starts_with(std::string(place) + ": ")) << place << ": " << text;
  }
  Scene scene = cloud_scene(3, 1.0);
  scene.medium.columns().centers[1].x = std::nan("");
  EXPECT_THROW(static_cast<void>(render(scene, once)), DomainError);
}

const RequestOption& option(const std::string& name) {
  return *std::ranges::find_if(request_options(), [&](const auto& it) { return it.name == name; });
}

std::string set(RenderRequest& request, const std::string& name, const std::string& text) {
  return option(name).set(request, text, Film{400, 200});
}

TEST(RequestOptions, TellWhatTheyWereSetTo) {
  const std::vector<std::pair<const char*, const char*>> texts{
      {"time", "-2.5"},         {"slices", "12"},         {"airlight", "sliced:12"},
      {"airlight", "path:7"},   {"airlight", "path:9"},   {"airlight", "paper+mean+energy"},
      {"airlight", "auto"},     {"scattering", "single"}, {"seed", "4294967295"},
      {"denoise", "solved"},    {"error", "none"},        {"airlight-scale", "2"},
      {"paper-spread", "true"}, {"max-error", "0.001"},   {"tolerance", "1e-06"},
      {"samples", "5"},         {"shutter", "-0.5,0.25"}, {"shutter", "none"},
      {"deep-error", "0.02"},   {"backend", "gl"},        {"threads", "3"}};
  std::set<std::string> known;
  for (const auto& [name, text] : texts) {
    RenderRequest request;
    EXPECT_EQ(set(request, name, text), "") << name;
    EXPECT_EQ(option(name).get(request), text) << name;
    known.insert(name);
  }
  for (const RequestOption& it : request_options()) {
    EXPECT_TRUE(known.contains(it.name) || !it.get || it.type == RequestOption::Type::flag)
        << it.name;
  }
}

TEST(RequestOptions, RefuseOtherTexts) {
  RenderRequest request;
  std::vector<std::string> airlights{"",       "sliced:",           "sliced:3", "sliced+mean",
                                     "paper+", "paper:3",           "auto:3",   "Sliced",
                                     "Path:8", "paper+energy+mean", "march:8",  "path:1000001"};
  for (const char* number :
       {"", ":", ":0", ":-3", ":1e3", ":8x", ":nan", ":99999999999999999999"}) {
    airlights.push_back(std::string("path") + number);
  }
  for (const std::string& text : airlights) {
    EXPECT_TRUE(set(request, "airlight", text).starts_with("found " + text)) << text;
  }
  struct Refused {
    const char* option;
    const char* allowed;
    std::vector<std::string> texts;
  };
  const std::vector<Refused> all{
      {"airlight", "path:N with N from 1 to 1000000", {"path:8x"}},
      {"airlight-scale", "1, 2, 4", {"", "3", "1.0"}},
      {"denoise", "none, solved", {"", "Solved", "1"}},
      {"error", "none, quick, full", {"", "some", "Full", "0"}},
      {"layers",
       "airlight, transmittance, Z, lights",
       {"lamps", "lights,", "lights,lamps", "Lights", "lights, normal"}},
      {"region",
       "x0,y0,x1,y1",
       {"", "0,0,1", "0,0,1,1,", "0,0,1,1,1", "0,0,1,x", "0.5,0,0.5,1", "0,1,1,0", "-0.1,0,1,1",
        "0,0,1,1.1", "nan,0,1,1", "0 0 1 1"}},
      {"samples", "a whole number from 1 to 4096", {"0", "4097", "x", "1.5"}},
      {"seed", "a whole number from 0 to 4294967295", {"-1", "4294967296", "1.5", "x"}},
      {"shutter", "OPEN,CLOSE", {"", "x", "0", "0,0", "1,0", "0,3", "a,b", "0,1,2", "0,nan", ","}},
      {"size", "WIDTHxHEIGHT", {"0", "x10", "10x", "0x10", "10x16385", "10x10x10", "1e3x10"}}};
  for (const auto& [name, allowed, texts] : all) {
    for (const std::string& text : texts) {
      const std::string why = set(request, name, text);
      EXPECT_TRUE(contains(why, allowed)) << name << " " << text << ": " << why;
    }
  }
}

TEST(RequestOptions, ValuesThatNoTextGivesAreRefused) {
  for (const int scale : {-1, 0, 3}) {
    RenderRequest request;
    request.airlight_scale = scale;
    const auto problem = problem_of(request);
    ASSERT_TRUE(problem) << scale;
    EXPECT_EQ(problem->option, "airlight-scale");
  }
  RenderRequest request;
  request.backend = static_cast<Backend>(7);
  EXPECT_TRUE(problem_of(request));
}

TEST(RequestOptions, SizesAndRegionsAreOfTheFilm) {
  RenderRequest request;
  EXPECT_EQ(set(request, "size", "100"), "");
  EXPECT_EQ(*request.film, (Film{100, 50}));
  EXPECT_EQ(set(request, "region", "0.5,0,1,1"), "");
  EXPECT_EQ(request.film->width, 50);
  EXPECT_EQ(set(request, "size", "30x20"), "");
  EXPECT_EQ(*request.film, (Film{30, 20}));
}

}  // namespace

}  // namespace brume
