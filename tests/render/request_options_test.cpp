#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "brume/request_options.h"
#include "render/request.h"

namespace brume {
namespace {

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
      {"error", "none"},        {"airlight-scale", "2"},  {"paper-spread", "true"},
      {"max-error", "0.001"},   {"tolerance", "1e-06"},   {"samples", "5"},
      {"shutter", "-0.5,0.25"}, {"shutter", "none"},      {"deep-error", "0.02"},
      {"backend", "gl"},        {"threads", "3"}};
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
  for (const char* text : {"", "x", "1,2,3", "0,0"}) EXPECT_NE(set(request, "shutter", text), "");
  for (const char* text : {"", "3", "1.0"}) EXPECT_NE(set(request, "airlight-scale", text), "");
  for (const char* text : {"", "0,0,1", "0,0,1,1,", "0.5,0,0.5,1"}) {
    EXPECT_NE(set(request, "region", text), "") << text;
  }
  EXPECT_EQ(set(request, "samples", "0"), "found 0; allowed: a whole number from 1 to 4096");
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
