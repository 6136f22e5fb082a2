#pragma once

#include <string>
#include <vector>

namespace brume {

// A scene with one mistake. It refers to files that the test writes next to it.
struct MalformedCase {
  std::string name;
  std::string text;
  std::string place;                // where the mistake is: a JSON path, a line and column
  std::vector<std::string> said{};  // what was found, what is allowed, the file referred to
};

std::vector<MalformedCase> malformed_cases();
// Every key of every type of light with values of the wrong kind, length and size.
std::vector<MalformedCase> malformed_lights();
// Primitives, and the names and switches of surfaces, with such values.
std::vector<MalformedCase> malformed_primitives();
// Every key of a group, and keyframes of it, with such values; groups that are not there.
std::vector<MalformedCase> malformed_groups();
// Every key of a painted spline with such values; splines that are not there.
std::vector<MalformedCase> malformed_splines();

// Keyframes of a surface, and their tangents, with such values.
std::vector<MalformedCase> malformed_keys();

// The text of a scene with a camera, with one light, with a medium, an environment, one emitter,
// with this as its second surface, with an array of groups, of splines.
std::string scene_with_camera(const std::string& members);
std::string scene_with_light(const std::string& members);
std::string scene_with_medium(const std::string& members);
std::string scene_with_environment(const std::string& members);  // of its own file
std::string scene_with_sky(const std::string& members);
std::string scene_with_emitter(const std::string& members);
std::string scene_with_surface(const std::string& members);
std::string scene_with_groups(const std::string& groups);
std::string scene_with_splines(const std::string& splines);

// The scene they are made from; it needs good.obj.
std::string good_scene();

}  // namespace brume
