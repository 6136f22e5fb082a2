#pragma once

#include <string>

#include "tests/render/test_scenes.h"

namespace brume {

// The light of a scene that so many paths per pixel see, which is expensive: airlight and beauty
// are stored for each test and call in tests/golden/traced.json, with their noise. Expects that a
// sixteenth of the paths see the same within their noise, and on the mean what they saw when it
// was stored. BRUME_TRACE=1 traces and stores them anew.
Frame traced_truth(const Scene& scene, int paths);

// Expects that sliced 24 of all orders is what paths see, of which there are enough to tell:
// airlight within 3% and their noise, no 2% brighter or darker, the picture no 3%. On a quarter of
// the usual nodes.
void expect_all_orders_match_paths(const Scene& scene, const std::string& name,
                                   const SourceGridSize& grid = {.nodes = 20'000});

}  // namespace brume
