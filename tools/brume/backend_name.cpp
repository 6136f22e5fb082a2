#include "tools/brume/backend_name.h"

#include "core/io/text_scanner.h"
#include "tools/brume/command.h"

namespace brume {

Backend parse_backend(const std::string& name) {
  if (name == "auto") return Backend::auto_;
  if (name == "cpu") return Backend::cpu;
  if (name == "gl") return Backend::gl;
  throw UsageError("--backend: found " + quoted_text(name) + "; allowed: auto, cpu, gl");
}

}  // namespace brume
