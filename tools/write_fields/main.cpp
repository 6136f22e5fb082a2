// brume-write-fields FOLDER: writes the rows of resources/manual/scene-file.md and the classes of
// python/brume/__init__.pyi that follow from core/scene/fields, in the repository at FOLDER;
// brume-write-fields --check FOLDER: fails if they are others.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "core/scene/animation/animation.h"
#include "core/scene/fields/copies_fields.h"
#include "core/scene/fields/description.h"
#include "core/scene/fields/surface_fields.h"

namespace brume {
namespace {

using Lines = std::vector<std::string>;

std::string joined(const glm::dvec3& v, auto&& text_of) {
  return text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z);
}

std::string manual_text(double value) {
  return quoted_text(value);
}
std::string manual_text(bool value) {
  return value ? "true" : "false";
}
std::string manual_text(std::int64_t value) {
  return std::to_string(value);
}
std::string manual_text(const glm::dvec2& v) {
  return '[' + quoted_text(v.x) + ", " + quoted_text(v.y) + ']';
}
std::string manual_text(const glm::dvec3& v) {
  return '[' + joined(v, quoted_text) + ']';
}

std::string python_text(double value) {
  const std::string text = quoted_text(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}
std::string python_text(bool value) {
  return value ? "True" : "False";
}
std::string python_text(const glm::dvec3& v) {
  return '(' + joined(v, [](double value) { return python_text(value); }) + ')';
}
std::string python_text(const std::optional<double>&) {
  return "None";
}

std::string python_type(double) {
  return "float";
}
std::string python_type(bool) {
  return "bool";
}
std::string python_type(const glm::dvec3&) {
  return "_Vec3";
}
std::string python_type(const std::optional<double>&) {
  return "Optional[float]";
}

// "camera.aperture"
std::string place_of(const std::string& object, const FieldInfo& info) {
  return object.empty() ? info.name : object + "." + info.name;
}

// | camera.aperture | Radius of the lens [u]; a number >= 0 | 0 |
template <class F>
std::string manual_row(const std::string& object, const F& field, const typename F::Owner& usual,
                       const std::string& kinds) {
  std::string absent = field.info.is_required ? "required" : field.info.absent;
  if constexpr (!may_be_absent<typename F::Value>) {
    if (absent.empty()) absent = manual_text(field.of(usual));
  }
  return "| " + place_of(object, field.info) + " | " + kinds + description(field) + " | " + absent +
         " |";
}

// Puts the rows of all values of an object where the first of them is. `visit_all(visit)` calls
// visit(field, object with usual values, what kinds of objects have it).
void write_rows(Lines& manual, const std::string& object, auto&& visit_all) {
  Lines rows;
  auto place = manual.end();
  visit_all([&](const auto& field, const auto& usual, const std::string& kinds) {
    rows.push_back(manual_row(object, field, usual, kinds));
    const std::string start = "| " + place_of(object, field.info) + " |";
    const auto found = std::ranges::find_if(
        manual, [&start](const std::string& line) { return line.starts_with(start); });
    if (found == manual.end()) return;
    const auto index = found - manual.begin();
    const bool is_first = place == manual.end();
    const auto first = is_first ? index : place - manual.begin();
    manual.erase(found);
    place = manual.begin() + first;
  });
  if (place == manual.end()) throw std::runtime_error("the manual has no row of " + object);
  manual.insert(place, rows.begin(), rows.end());
}

// | camera | eye, target, focus_distance if it has one |
void write_keys(Lines& manual, const std::string& object, auto&& visit_all) {
  std::string values;
  visit_all([&]<class F>(const F& field, const auto&, const std::string&) {
    if (!F::can_have_keys) return;
    if (!values.empty()) values += ", ";
    values += field.info.name;
    if (may_be_absent<typename F::Value>) values += " if it has one";
  });
  const auto title = std::ranges::find(manual, "| object | values that can have keyframes |");
  const auto row = std::find_if(title, manual.end(), [&object](const std::string& line) {
    return line.starts_with("| " + object + " |");
  });
  if (row == manual.end()) throw std::runtime_error("the manual has no keyframes of " + object);
  *row = "| " + object + " | " + values + " |";
}

template <class Owner>
void visit_values(auto&& visit) {
  visit_fields<Owner>([&](const auto& field) { visit(field, Owner(), std::string()); });
}
template <class Owner>
void write_rows(Lines& manual, const std::string& object) {
  write_rows(manual, object, [](auto&& visit) { visit_values<Owner>(visit); });
}
template <class Owner>
void write_keys(Lines& manual, const std::string& object) {
  write_keys(manual, object, [](auto&& visit) { visit_values<Owner>(visit); });
}

// "spot, directional: " for what only these kinds of lights have.
std::string kinds_with(std::string_view value) {
  Lines names;
  visit_light_kinds([&]<class Kind>(const LightKindInfo& info, const Kind&) {
    visit_fields<Kind>([&](const auto& field) {
      if (field.info.name == value) names.emplace_back(info.name);
    });
  });
  if (names.size() == light_kinds.size()) return {};
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? text : text + ": ";
}

void visit_light_values(auto&& visit) {
  visit_light_fields([&](const auto& field, const Light& light) {
    visit(field, light, kinds_with(field.info.name));
  });
}

// Puts lines in place of those from their first to their last.
void replace(Lines& stub, const Lines& lines) {
  const auto first = std::ranges::find(stub, lines.front());
  const auto last = std::find(first, stub.end(), lines.back());
  if (last == stub.end()) throw std::runtime_error("the stub has no " + lines.front());
  stub.insert(stub.erase(first, last + 1), lines.begin(), lines.end());
}

// The members of a class, and its constructor.
template <class Owner>
void write_class(Lines& stub, const std::string& name) {
  Lines members{"class " + name + ":"};
  const Owner usual{};
  Lines constructor{"    def __init__(", "        self,"};
  visit_fields<Owner>([&](const auto& field) {
    const auto value = field.of(usual);
    const std::string member = std::string(field.info.name) + ": " + python_type(value);
    members.push_back("    " + member);
    constructor.push_back("        " + member + " = " + python_text(value) + ",");
  });
  constructor.emplace_back("    ) -> None: ...");
  members.insert(members.end(), constructor.begin(), constructor.end());
  replace(stub, members);
}

// The members of lights, and the function that makes each kind.
void write_light_class(Lines& stub) {
  Lines members{"class Light:", "    name: str", "    position: _Vec3", "    intensity: _Vec3"};
  visit_light_fields([&](const auto& field, const Light& light) {
    if (is_strength(field) || std::string_view(field.info.name) == "position") return;
    members.push_back("    " + std::string(field.info.name) + ": " + python_type(field.of(light)));
  });
  members.insert(members.end(), {"    @property", "    def kind(self) -> str: ..."});
  visit_light_kinds([&]<class Kind>(const LightKindInfo& info, const Kind& kind) {
    members.insert(members.end(), {"    @staticmethod", std::string("    def ") + info.name + "("});
    const Light usual{.kind = kind};
    visit_fields<Kind>([&](const auto& field) {
      const auto value = field.of(usual);
      members.push_back("        " + std::string(field.info.name) + ": " + python_type(value) +
                        (field.info.is_required ? "," : " = " + python_text(value) + ","));
    });
    members.emplace_back("    ) -> Light: ...");
  });
  members.emplace_back("    def clear_keys(self) -> None: ...");
  replace(stub, members);
}

// Returns whether it was another text.
bool rewrite(const std::filesystem::path& file, bool only_checks, auto&& change) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot be opened: " + file.string());
  Lines lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const Lines before = lines;
  change(lines);
  if (lines == before) return false;
  if (only_checks) {
    const auto [now, wanted] = std::ranges::mismatch(before, lines);
    std::cerr << file.string() << " is not what brume-write-fields writes:\n"
              << (now == before.end() ? "" : *now) << "\ninstead of\n"
              << (wanted == lines.end() ? "" : *wanted) << '\n';
  } else {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    write_atomically(file, text);
  }
  return true;
}

bool rewrite_all(const std::filesystem::path& folder, bool only_checks) {
  const bool manual =
      rewrite(folder / "resources/manual/scene-file.md", only_checks, [](Lines& lines) {
        write_rows<Camera>(lines, "camera");
        write_keys<Camera>(lines, "camera");
        write_rows<MediumOptics>(lines, "medium");
        write_rows<Noise>(lines, "noise");
        write_keys<Noise>(lines, "medium.noise");
        write_rows<Group>(lines, "group");
        write_keys<Group>(lines, "each group");
        write_rows<Emitter>(lines, "emitter");
        write_keys<Emitter>(lines, "each emitter");
        write_rows<Environment>(lines, "environment");
        write_rows<Sky>(lines, "sky");
        write_rows<Material>(lines, "material");
        write_rows<MetallicRoughness>(lines, "");
        write_rows<Surface>(lines, "");
        write_rows<Scatter>(lines, "copies");
        write_keys<Environment>(lines, "environment");
        write_keys<Sky>(lines, "environment.sky");
        const auto visit_lights = [](auto&& visit) { visit_light_values(visit); };
        write_rows(lines, "light", visit_lights);
        write_keys(lines, "each light", visit_lights);
      });
  const bool stub = rewrite(folder / "python/brume/__init__.pyi", only_checks, [](Lines& lines) {
    write_class<Camera>(lines, "Camera");
    write_class<Sky>(lines, "Sky");
    write_light_class(lines);
  });
  return manual || stub;
}

}  // namespace
}  // namespace brume

int main(int argc, char** argv) {
  const bool only_checks = argc == 3 && argv[1] == std::string_view("--check");
  if ((argc != 2 && !only_checks) || *argv[argc - 1] == '-') {
    std::cerr << "usage: brume-write-fields [--check] FOLDER\n";
    return 2;
  }
  try {
    const bool differs = brume::rewrite_all(argv[argc - 1], only_checks);
    return differs && only_checks ? 1 : 0;
  } catch (const std::exception& error) {
    std::cerr << "brume-write-fields: " << error.what() << '\n';
    return 2;
  }
}
