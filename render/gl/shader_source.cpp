#include "render/gl/shader_source.h"

#include <set>
#include <sstream>

#include "render/gl/resources.h"
#include "render/gl/sh_turns.h"
#include "render/gl/shader_constants.h"
#include "render/gl/shader_structs.h"

namespace brume::gl {
namespace {

void append_text(const std::string& text, std::set<std::string>& seen, std::ostream& out);

void append(const std::string& name, std::set<std::string>& seen, std::ostream& out) {
  if (!seen.insert(name).second) return;
  if (name == "constants.glsl") {
    append_text(shader_constants(), seen, out);
    return;
  }
  if (name == "structs.glsl") {
    out << shader_structs();
    return;
  }
  if (name == "sh_turns.glsl") {
    out << sh_turns();
    return;
  }
  const char* text = embedded_shader(name);
  if (!text) throw Error("there is no shader " + name);
  append_text(text, seen, out);
}

void append_text(const std::string& text, std::set<std::string>& seen, std::ostream& out) {
  constexpr std::string_view include = "#include \"";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(include)) {
      append(line.substr(include.size(), line.rfind('"') - include.size()), seen, out);
    } else {
      out << line << '\n';
    }
  }
}

}  // namespace

std::string shader_source(const std::string& name) {
  std::istringstream words(name);
  std::string file;
  words >> file;
  std::string text;
  for (std::string defined; words >> defined;) text += "#define " + defined + "\n";
  return complete_shader(text + "#include \"" + file + "\"\n");
}

std::string complete_shader(const std::string& text) {
  std::ostringstream out;
  out << "#version 450 core\n";
  std::set<std::string> seen;
  append_text(text, seen, out);
  return out.str();
}

}  // namespace brume::gl
