#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "core/io/disk/file_bytes.h"
#include "core/io/scene/usd_file.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {

// The prim of a name, from its first to its last line.
inline std::string prim(const std::string& stage, const std::string& name) {
  const std::size_t at = stage.find("\"" + name + "\"\n");
  if (at == std::string::npos) return {};
  const std::size_t begin = stage.rfind('\n', at) + 1;
  const std::string margin(stage.find_first_not_of(' ', begin) - begin, ' ');
  const std::size_t end = stage.find("\n" + margin + "}\n", at);
  return stage.substr(begin, end - begin);
}

// The numbers of an attribute, whatever brackets they are in.
inline std::vector<double> numbers(const std::string& prim, const std::string& attribute) {
  const std::size_t at = prim.find(attribute + " = ");
  if (at == std::string::npos) return {};
  const std::size_t begin = at + attribute.size() + 3;
  const std::string line = prim.substr(begin, prim.find('\n', begin) - begin);
  const std::regex number(R"([-+]?[0-9.]+(e[-+]?[0-9]+)?)");
  std::vector<double> values;
  for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i) {
    values.push_back(std::stod(i->str()));
  }
  return values;
}

class UsdFile : public ::testing::Test {
 protected:
  UsdFile() {
    scene_.camera = {{1.0, 2.0, 5.0}, {1.0, 2.0, 0.0}, {0.0, 1.0, 0.0}, 60.0};
    scene_.film = {200, 100};
  }

  [[nodiscard]] std::string stage(const std::vector<UsdFrame>& frames) const {
    write_usd(folder_ / "a.usda", frames, 24.0);
    return read_bytes(folder_ / "a.usda");
  }
  [[nodiscard]] std::string stage() const { return stage({{{}, scene_, {}}}); }

  TemporaryFolder folder_;
  Scene scene_;
};

}  // namespace brume
