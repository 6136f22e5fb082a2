#pragma once

#include <map>
#include <string>

#include "render/gl/resources.h"

namespace brume::gl {

// The shaders of a context, each compiled when it is first asked for.
class Programs {
 public:
  // `name`.glsl. Throws Error with what the compiler says.
  const Program& operator[](const std::string& name) {
    const auto known = programs_.find(name);
    if (known != programs_.end()) return known->second;
    return programs_.emplace(name, Program(name + ".glsl")).first->second;
  }

 private:
  std::map<std::string, Program> programs_;
};

}  // namespace brume::gl
