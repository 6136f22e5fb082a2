#pragma once

#include <map>
#include <string>

#include "render/gl/resources.h"

namespace brume::gl {

// The compute programs of a context, compiled on first use.
class Programs {
 public:
  // Program of `name`.glsl. Throws Error with the compiler's log.
  const Program& operator[](const std::string& name) {
    const auto known = programs_.find(name);
    if (known != programs_.end()) return known->second;
    return programs_.emplace(name, Program(name + ".glsl")).first->second;
  }

 private:
  std::map<std::string, Program> programs_;
};

}  // namespace brume::gl
