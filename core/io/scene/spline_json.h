#pragma once

#include <map>
#include <vector>

#include "brume/painted_spline.h"
#include "core/io/scene/json_reader.h"

namespace brume {

// Splines in scene files, but for their albedo and emission. Gaussians refer to them by name.

// Reads one that follows `splines`.
PaintedSpline read_spline(const JsonContext& context, JsonObject& object,
                          const std::vector<PaintedSpline>& splines);
// The spline that a Gaussian's member `spline` names; nullptr if it is missing.
PaintedSpline* read_spline_name(JsonObject& object, std::vector<PaintedSpline>& splines);

Json spline_to_json(const PaintedSpline& spline);
// The spline of each Gaussian that has one.
std::map<GaussianId, const PaintedSpline*> splines_of_gaussians(
    const std::vector<PaintedSpline>& splines);

}  // namespace brume
