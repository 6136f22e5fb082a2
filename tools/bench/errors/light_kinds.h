#pragma once

#include <string>
#include <vector>

#include "tools/bench/measure/measurement.h"

namespace brume {

// One light of each kind in place of a point light: in a cloud of depth 3.
struct LightKindRow {
  std::string kind;
  double error = 0.0;   // of the airlight, relative RMSE against the reference
  Spread camera_ratio;  // frame times of a moved camera over a point light's
  Spread edit_ratio;    // the same of frames before each of which the light was moved
};
std::vector<LightKindRow> measure_light_kinds(bool quick);

}  // namespace brume
