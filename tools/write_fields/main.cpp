// brume-write-fields FOLDER: writes the rows of resources/manual/scene-file.md and the classes of
// python/brume/__init__.pyi that follow from core/scene/fields, in the repository at FOLDER;
// brume-write-fields --check FOLDER: fails if they are others.

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/disk/atomic_file.h"
#include "core/scene/animation/animation.h"
#include "core/scene/fields/description.h"

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
std::string python_text(const glm::dvec3& v) {
  return '(' + joined(v, [](double value) { return python_text(value); }) + ')';
}
std::string python_text(const std::optional<double>&) {
  return "None";
}

std::string python_type(double) {
  return "float";
}
std::string python_type(const glm::dvec3&) {
  return "_Vec3";
}
std::string python_type(const std::optional<double>&) {
  return "Optional[float]";
}

// | camera.aperture | Radius of the lens [u]; a number >= 0 | 0 |
template <class F>
std::string manual_row(const std::string& object, const F& field) {
  std::string absent = field.info.is_required ? "required" : field.info.absent;
  if constexpr (!may_be_absent<typename F::Value>) {
    const typename F::Owner usual{};
    if (absent.empty()) absent = manual_text(field.of(usual));
  }
  return "| " + object + "." + field.info.name + " | " + description(field) + " | " + absent + " |";
}

// Puts the rows of all values of an object where the first of them is.
template <class Owner>
void write_rows(Lines& manual, const std::string& object) {
  Lines rows;
  auto place = manual.end();
  visit_fields<Owner>([&](const auto& field) {
    rows.push_back(manual_row(object, field));
    const std::string start = "| " + object + "." + field.info.name + " |";
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
template <class Owner>
void write_keys(Lines& manual, const std::string& object) {
  std::string values;
  visit_fields<Owner>([&]<class F>(const F& field) {
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
  const auto first = std::ranges::find(stub, members.front());
  const auto last = std::find(first, stub.end(), members.back());
  if (last == stub.end()) throw std::runtime_error("the stub has no class " + name);
  stub.insert(stub.erase(first, last + 1), members.begin(), members.end());
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
        write_keys<Environment>(lines, "environment");
      });
  const bool stub = rewrite(folder / "python/brume/__init__.pyi", only_checks,
                            [](Lines& lines) { write_class<Camera>(lines, "Camera"); });
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
