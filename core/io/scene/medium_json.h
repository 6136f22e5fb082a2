#pragma once

#include <map>
#include <vector>

#include "brume/group.h"
#include "brume/painted_spline.h"
#include "core/io/scene/json_reader.h"
#include "core/io/scene/keys_json.h"

namespace brume {

// Groups in scene files, but for their keyframes. They refer to each other by name.

// Reads one that follows `groups`, but for its parent, which may come later.
Group read_group(JsonObject& object, const std::vector<Group>& groups);
// The parents of groups read from these elements of an array at `path`.
void read_parents(JsonContext& context, const Json::array_t& elements, const JsonPath& path,
                  std::vector<Group>& groups);
// The id of the group that member `key` names; 0 if it is missing.
GroupId read_group_name(JsonObject& object, const char* key, const std::vector<Group>& groups);

Json group_to_json(const Group& group, const std::vector<Group>& groups);

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
