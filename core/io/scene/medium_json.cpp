#include "core/io/scene/medium_json.h"

#include <algorithm>

#include "brume/limits.h"
#include "core/io/scene/fields_json.h"
#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "core/scene/fields/group_fields.h"
#include "core/scene/group_effects.h"

namespace brume {
namespace {

std::string read_name(JsonObject& object, const std::vector<Group>& groups) {
  std::string name = object.name({});
  if (std::ranges::find(groups, name, &Group::name) != groups.end()) {
    object.fail("name",
                "found " + quoted_text(name) + " again; allowed: a name that no other group has");
  }
  return name;
}

}  // namespace

Group read_group(JsonObject& object, const std::vector<Group>& groups) {
  Group group;
  group.id = static_cast<GroupId>(groups.size() + 1);
  group.name = read_name(object, groups);
  static_cast<void>(object.find("parent"));  // known, but read later
  read_fields(object, group);
  return group;
}

void read_parents(JsonContext& context, const Json::array_t& elements, const JsonPath& path,
                  std::vector<Group>& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    JsonObject object(context, elements[i], path.element(i));
    groups[i].parent = read_group_name(object, "parent", groups);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group* parent = find_group(groups, groups[i].parent);
    if (!parent || (parent != &groups[i] && parent->parent == 0)) continue;
    context.fail(path.element(i).member("parent"),
                 "found " + quoted_text(parent->name) +
                     "; allowed: another group that is in no group itself");
  }
}

GroupId read_group_name(JsonObject& object, const char* key, const std::vector<Group>& groups) {
  if (object.find(key) == nullptr) return 0;
  const std::string name = object.text(key, {});
  const auto found = std::ranges::find(groups, name, &Group::name);
  if (found == groups.end()) {
    object.fail(key, "found " + quoted_text(name) + "; allowed: the name of one of medium.groups");
  }
  return found->id;
}

Json group_to_json(const Group& group, const std::vector<Group>& groups) {
  Json json{{"name", group.name}};
  if (const Group* parent = find_group(groups, group.parent)) json["parent"] = parent->name;
  write_fields(json, group, group.keys);
  return json;
}

namespace {

constexpr const char* mirror_names[] = {"mirror_x", "mirror_y", "mirror_z"};

std::vector<glm::dvec3> read_points(const JsonContext& context, JsonObject& object) {
  static_cast<void>(object.required("points"));
  const Json::array_t& elements = object.array("points", limits::spline_points);
  if (elements.empty()) object.fail("points", "found no point; allowed: 1 to 1024 points");
  const JsonPath path = object.path_of("points");
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::vector<double> p =
        read_numbers(context, elements[i], path.element(i), 3, domain::coordinate);
    points.emplace_back(p[0], p[1], p[2]);
  }
  return points;
}

// Radius and density are required, as those of a Gaussian.
Paintbrush read_brush(JsonObject& object) {
  Paintbrush brush;
  brush.radius = object.number("radius", domain::length, {});
  brush.density = object.number("density", domain::density, {});
  brush.spacing = object.number("spacing", domain::brush_spacing, brush.spacing);
  brush.scatter = object.number("scatter", domain::brush_scatter, brush.scatter);
  brush.falloff = object.number("falloff", domain::unit, brush.falloff);
  brush.flow = object.number("flow", domain::unit, brush.flow);
  brush.jitter = object.number("jitter", domain::unit, brush.jitter);
  brush.stretch = object.number("stretch", domain::brush_stretch, brush.stretch);
  return brush;
}

}  // namespace

PaintedSpline read_spline(const JsonContext& context, JsonObject& object,
                          const std::vector<PaintedSpline>& splines) {
  PaintedSpline spline;
  spline.id = static_cast<SplineId>(splines.size() + 1);
  spline.name = object.name({});
  if (std::ranges::find(splines, spline.name, &PaintedSpline::name) != splines.end()) {
    object.fail("name", "found " + quoted_text(spline.name) +
                            " again; allowed: a name that no other spline has");
  }
  spline.points = read_points(context, object);
  spline.brush = read_brush(object);
  spline.seed = object.integer("seed", INT64_MIN, INT64_MAX, spline.seed);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    spline.mirrors.axes[axis] = object.boolean(mirror_names[axis], false);
  }
  spline.mirrors.center = object.vector("mirror_center", domain::coordinate, spline.mirrors.center);
  return spline;
}

PaintedSpline* read_spline_name(JsonObject& object, std::vector<PaintedSpline>& splines) {
  if (object.find("spline") == nullptr) return nullptr;
  const std::string name = object.text("spline", {});
  const auto found = std::ranges::find(splines, name, &PaintedSpline::name);
  if (found == splines.end()) {
    object.fail("spline",
                "found " + quoted_text(name) + "; allowed: the name of one of medium.splines");
  }
  return &*found;
}

Json spline_to_json(const PaintedSpline& spline) {
  Json json{{"name", spline.name}};
  Json& points = json["points"] = Json::array();
  for (const glm::dvec3& point : spline.points) points.push_back(to_json(point));
  const Paintbrush& brush = spline.brush;
  json["radius"] = brush.radius;
  json["density"] = brush.density;
  json["spacing"] = brush.spacing;
  json["scatter"] = brush.scatter;
  json["falloff"] = brush.falloff;
  json["flow"] = brush.flow;
  json["jitter"] = brush.jitter;
  if (brush.stretch != 1.0) json["stretch"] = brush.stretch;
  json["seed"] = spline.seed;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (spline.mirrors.axes[axis]) json[mirror_names[axis]] = true;
  }
  if (spline.mirrors.center != glm::dvec3(0.0)) {
    json["mirror_center"] = to_json(spline.mirrors.center);
  }
  return json;
}

std::map<GaussianId, const PaintedSpline*> splines_of_gaussians(
    const std::vector<PaintedSpline>& splines) {
  std::map<GaussianId, const PaintedSpline*> result;
  for (const PaintedSpline& spline : splines) {
    for (const GaussianId id : spline.gaussians) result[id] = &spline;
  }
  return result;
}

}  // namespace brume
