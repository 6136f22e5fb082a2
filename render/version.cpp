#include "brume/version.h"

#include <hwy/targets.h>

#include <cstdint>

namespace brume {

const char* version() {
  return BRUME_VERSION;
}

std::vector<std::pair<std::string, std::string>> build_information() {
  // The best of a processor's targets is their lowest bit.
  const std::int64_t targets = hwy::SupportedTargets();
  std::vector<std::pair<std::string, std::string>> lines{
      {"compiler", __VERSION__}, {"vector instructions", hwy::TargetName(targets & -targets)}};
  // "name version|name version"
  const std::string libraries = BRUME_LIBRARIES;
  for (std::size_t begin = 0; begin < libraries.size();) {
    const std::size_t end = libraries.find('|', begin);
    const std::string library = libraries.substr(begin, end - begin);
    const std::size_t space = library.find(' ');
    lines.emplace_back(library.substr(0, space), library.substr(space + 1));
    begin = end == std::string::npos ? libraries.size() : end + 1;
  }
  return lines;
}

}  // namespace brume
