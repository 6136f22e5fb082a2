#pragma once

#include <map>
#include <string>

#include "render/gl/resources.h"

namespace brume::gl {

// The compute programs of a context, compiled on first use.
class Programs {
 public:
  // Program of `name`.glsl, with `defined` words that it asks for, separated by spaces. Throws
  // Error with the compiler's log.
  const Program& operator[](const std::string& name) { return get(name, ""); }
  const Program& get(const std::string& name, const std::string& defined) {
    const std::string file = name + ".glsl " + defined;
    const auto known = programs_.find(file);
    if (known != programs_.end()) return known->second;
    return programs_.emplace(file, Program(file)).first->second;
  }

 private:
  std::map<std::string, Program> programs_;
};

}  // namespace brume::gl
