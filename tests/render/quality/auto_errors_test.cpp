// What auto says of its pictures, held against all their pixels.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "render/quality/auto_quality.h"
#include "render/reference/reference_pixels.h"
#include "render/renderer.h"
#include "tests/render/random_scene.h"

namespace brume {
namespace {

constexpr double bound = 0.02;

// Half of them anything that is valid, half of them fog as somebody might make it. None has an
// environment: its reference takes a tenth of a second a pixel.
Scene scene_of(unsigned seed) {
  Scene scene = seed % 2 == 0 ? random_fog_scene(seed) : random_scene(seed);
  // Three times as many pixels as a sample takes, few enough for all of them to be computed; and
  // one pixel of 432 is 4.8% of their rms, so that a single one may break the bound.
  scene.film = {24, 18};
  scene.environment.reset();
  return scene;
}

// Of all pixels; 0 where nothing is lit and nothing shown.
double true_error(const Scene& scene, const Frame& frame) {
  std::vector<std::size_t> all(frame.depth.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<glm::dvec3> truth =
      ReferencePixels(scene, scene.camera, frame.film, 1e-3).airlight(all, {});
  double error = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < frame.airlight.size(); ++i) {
    const double t = truth[i / 3][static_cast<int>(i % 3)];
    const double d = static_cast<double>(frame.airlight[i]) - t;
    error += d * d;
    sum += t * t;
  }
  return error > 0.0 ? std::sqrt(error / sum) : 0.0;
}

struct Tally {
  int lit = 0;
  int held = 0;
  int unsaid = 0;        // said to keep the bound, and do not
  int black_cached = 0;  // show light where all is black, and said to keep the bound
  std::vector<std::string> failures;
};

// Far more light than there is: by how much says nothing.
constexpr double as_good_as_black = 1e3;

Tally tally_auto(unsigned first, unsigned count) {
  Tally tally;
  std::mutex mutex;
  tbb::parallel_for(first, first + count, [&](unsigned seed) {
    const Scene scene = scene_of(seed);
    Settings settings;
    settings.threads = 1;  // scenes run side by side
    settings.airlight_scale = 4;
    settings.max_error = bound;
    Renderer renderer;
    const RequestedFrame made =
        *render_requested(renderer, scene, scene.camera, scene.film, settings);
    const double truth = true_error(scene, made.frame);
    if (truth == 0.0) return;  // black
    const bool keeps = made.error->high <= bound;
    const std::scoped_lock lock(mutex);
    if (truth > as_good_as_black) {
      tally.black_cached += keeps ? 1 : 0;
      return;
    }
    const bool held = made.error->low <= truth && truth <= made.error->high;
    const bool unsaid = keeps && truth > bound;
    ++tally.lit;
    tally.held += held ? 1 : 0;
    tally.unsaid += unsaid ? 1 : 0;
    if (held) return;
    std::ostringstream text;
    text << (unsaid ? "unsaid" : "missed") << " in " << seed << ": " << truth << " not in "
         << made.error->low << " to " << made.error->high;
    tally.failures.push_back(text.str());
  });
  std::ranges::sort(tally.failures);
  return tally;
}

// The interval is one of 95%. Not every picture that breaks the bound can be met by a sample, but
// one in a hundred is the most that anybody should have to bear. Other scenes than these were
// looked at when the sample was made.
TEST(AutoErrors, IntervalsHoldOnRandomScenes) {
  const Tally tally = tally_auto(1001, 500);
  for (const std::string& failure : tally.failures) std::cout << failure << '\n';
  std::cout << tally.held << " of " << tally.lit << " hold, " << tally.unsaid << " unsaid\n";
  EXPECT_GE(tally.lit, 300);
  EXPECT_GE(tally.held, 0.95 * tally.lit);
  EXPECT_LE(tally.unsaid, 0.01 * tally.lit);
  EXPECT_EQ(tally.black_cached, 0);
}

}  // namespace
}  // namespace brume
