#include "tests/render/traced_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "render/renderer.h"

namespace brume {
namespace {

using Json = nlohmann::json;

// A layer as whole numbers, of which `max_number` is the brightest; noise is above their rounding.
// Three channels of `stride` values a pixel, or one where all are alike.
constexpr double max_number = 9999.0;

Json to_json(const std::vector<float>& layer, std::size_t stride) {
  float brightest = 0.0f;
  bool is_gray = true;
  for (std::size_t i = 0; i < layer.size(); i += stride) {
    brightest = std::max({brightest, layer[i], layer[i + 1], layer[i + 2]});
    is_gray = is_gray && layer[i] == layer[i + 1] && layer[i] == layer[i + 2];
  }
  Json numbers = Json::array();
  for (std::size_t i = 0; i < layer.size(); i += stride) {
    for (std::size_t c = 0; c < (is_gray ? 1u : 3u); ++c) {
      const float share = brightest > 0.0f ? layer[i + c] / brightest : 0.0f;
      numbers.push_back(std::lround(static_cast<double>(share) * max_number));
    }
  }
  return {{"brightest", brightest}, {"channels", is_gray ? 1 : 3}, {"numbers", numbers}};
}

// The colors of a layer, whose other values stay.
void set_colors(std::vector<float>& layer, std::size_t stride, const Json& json) {
  const std::vector<int> numbers = json.at("numbers");
  const float unit = json.at("brightest").get<float>() / static_cast<float>(max_number);
  const std::size_t channels = json.at("channels");
  ASSERT_EQ(numbers.size() / channels, layer.size() / stride);
  for (std::size_t i = 0; i < layer.size() / stride; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      layer[stride * i + c] = unit * static_cast<float>(numbers[channels * i + c % channels]);
    }
  }
}

// The name of this test and the number of the call within it, from 1 on where it is repeated.
std::string next_key() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  static std::pair<const testing::TestInfo*, testing::TimeInMillis> running;
  static int calls;
  if (running != std::pair(&test, test.result()->start_timestamp())) calls = 0;
  running = {&test, test.result()->start_timestamp()};
  return std::string(test.test_suite_name()) + "." + test.name() + " " + std::to_string(++calls);
}

Json read_truths() {
  std::ifstream file(BRUME_TRACED);
  return file ? Json::parse(file) : Json::object();
}

double mean_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<float> without_alpha(const std::vector<float>& beauty) {
  std::vector<float> colors;
  for (std::size_t i = 0; i < beauty.size(); ++i) {
    if (i % 4 != 3) colors.push_back(beauty[i]);
  }
  return colors;
}

// The mean that few paths of the same scene see.
Json to_means(const Frame& few) {
  return {{"airlight", static_cast<float>(mean_of(few.airlight))},
          {"beauty", static_cast<float>(mean_of(without_alpha(few.beauty)))}};
}

Frame few_paths(const Scene& scene, int paths) {
  return render_frame(scene, path_traced(std::max(paths / 16, 2)));
}

void store(const std::string& key, const Scene& scene, const Frame& frame) {
  const PathNoise& noise = *frame.statistics.path_noise;
  Json truths = read_truths();
  truths[key] = {{"paths", noise.paths},
                 {"airlight_variance", static_cast<float>(noise.airlight_variance)},
                 {"surface_variance", static_cast<float>(noise.surface_variance)},
                 {"few", to_means(few_paths(scene, noise.paths))},
                 {"airlight", to_json(frame.airlight, 3)},
                 {"beauty", to_json(frame.beauty, 4)}};
  std::ofstream file(BRUME_TRACED);
  const char* separator = "{\n";
  for (const auto& [name, truth] : truths.items()) {
    file << separator << Json(name) << ":" << truth;
    separator = ",\n";
  }
  file << "\n}\n";
}

// Few paths see the truth but for their noise, pixel by pixel; and on the mean what they saw when
// it was stored. Processors round differently, which turns some paths: a fraction of their noise.
void expect_same_within_noise(const std::vector<float>& few, const std::vector<float>& truth,
                              double noise, double stored_mean, const std::string& key) {
  if (!(noise > 0.0)) {
    EXPECT_EQ(few, truth) << key;
    return;
  }
  EXPECT_LT(difference(few, truth).relative_rmse, 2.0 * noise) << key;
  const double pixels = static_cast<double>(truth.size()) / 3.0;
  const double share = 1e-3 + 0.3 * noise / std::sqrt(pixels);
  EXPECT_NEAR(mean_of(few), stored_mean, share * mean_of(truth)) << key;
}

// The stored truth of this call, or what is traced.
Frame truth_of(const Scene& scene, const std::function<Frame()>& traced) {
  const std::string key = next_key();
  const bool traces = std::getenv("BRUME_TRACE") != nullptr;
  if (traces) store(key, scene, traced());
  static const Json truths = read_truths();
  const Json truth = (traces ? read_truths() : truths).value(key, Json());
  if (truth.is_null()) {
    throw std::runtime_error(key + " is not in " BRUME_TRACED "; BRUME_TRACE=1 stores it");
  }
  const PathNoise noise{truth.at("paths"), truth.at("airlight_variance"),
                        truth.at("surface_variance")};
  const Frame few = few_paths(scene, noise.paths);
  Frame frame = few;
  set_colors(frame.airlight, 3, truth.at("airlight"));
  set_colors(frame.beauty, 4, truth.at("beauty"));
  frame.statistics.path_noise = noise;
  // Rare bright paths are in the noise of many paths only.
  const int paths = few.statistics.path_noise->paths;
  const double ratio = std::sqrt(static_cast<double>(noise.paths) / paths);
  const RelativeNoise relative = *relative_noise(frame);
  const Json& means = truth.at("few");
  expect_same_within_noise(few.airlight, frame.airlight, ratio * relative.airlight,
                           means.at("airlight"), key);
  expect_same_within_noise(without_alpha(few.beauty), without_alpha(frame.beauty),
                           ratio * relative.picture, means.at("beauty"), key);
  return frame;
}

// Traces paths until three standard errors are below a bias, of the airlight and of the picture.
constexpr double max_airlight_bias = 0.02;
constexpr double max_picture_bias = 0.03;

bool tells(const Frame& frame) {
  const RelativeNoise noise = *relative_noise(frame);
  const double errors = 3.0 / std::sqrt(static_cast<double>(frame.depth.size()));
  return errors * noise.airlight < max_airlight_bias && errors * noise.picture < max_picture_bias;
}

Frame traced_until_it_tells(const Scene& scene) {
  Renderer renderer;  // goes on with the paths of the frame before
  for (int paths = 128;; paths *= 2) {
    Frame frame = render_frame(renderer, scene, path_traced(paths));
    if (tells(frame) || paths >= 4096) return frame;
  }
}

}  // namespace

Frame traced_truth(const Scene& scene, int paths) {
  return truth_of(scene, [&] { return render_frame(scene, path_traced(paths)); });
}

void expect_all_orders_match_paths(const Scene& scene, const std::string& name,
                                   const SourceGridSize& grid) {
  const Frame truth = truth_of(scene, [&] { return traced_until_it_tells(scene); });
  EXPECT_TRUE(tells(truth)) << name << " is too noisy";
  const Frame frame = render_frame(scene, all_orders(24, grid));
  const Difference airlight = difference(frame.airlight, truth.airlight);
  const double noise = relative_noise(truth)->airlight;
  EXPECT_LT(airlight.relative_rmse, std::hypot(0.03, 1.2 * noise)) << name;
  EXPECT_LT(std::abs(airlight.bias), max_airlight_bias) << name;
  EXPECT_LT(std::abs(difference(frame.beauty, truth.beauty).bias), max_picture_bias) << name;
}

}  // namespace brume
