#include <gtest/gtest.h>

#include "tests/tools/run_program.h"

namespace brume {
namespace {

// The script that keeps the layers apart, run on a tree of five small files.
class Layers : public ::testing::Test {
 protected:
  Layers() {
    std::filesystem::create_directory(folder_ / "tests");
    std::filesystem::copy_file(BRUME_LAYERS_SCRIPT, folder_ / "tests/check_layers.sh");
    write("include/brume/a.h", "#include <string>\n");
    write("core/a.h", "#include <vector>\n");
    write("render/a.h", "#include \"core/a.h\"\n#include <GL/gl.h>\n");
    write("tools/a.cpp", "#include \"render/a.h\"\n");
    write("app/a.cpp", "#include <QWidget>\n#include \"app/tools/select.h\"\n");
  }

  void write(const char* file, const char* text) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    folder_.write(file, text);
  }

  [[nodiscard]] bool passes() const {
    const std::string script = quoted((folder_ / "tests/check_layers.sh").string());
    return std::system(("bash " + script + " >/dev/null 2>&1").c_str()) == 0;
  }

  TemporaryFolder folder_;
};

TEST_F(Layers, PassWhereArrowsPointDown) {
  EXPECT_TRUE(passes());
}

TEST_F(Layers, FailWhereAnArrowPointsUp) {
  for (const auto& [file, text] : std::vector<std::pair<const char*, const char*>>{
           {"core/b.cpp", "#include \"render/a.h\"\n"},
           {"core/b.hpp", "#include \"render/a.h\"\n"},
           {"core/b.cpp", "#include \"../render/a.h\"\n"},
           {"core/io/b.cpp", "  #  include \"../../render/a.h\"\n"},
           {"render/b.cpp", "#include \"core/../app/a.h\"\n"},
           {"include/brume/b.h", "#include \"core/a.h\"\n"},
           {"include/brume/b.h", "#include <nlohmann/json.hpp>\n"},
           {"tools/b.h", "#include <QWidget>\n"},
           {"tools/b.h", "#include <vtkNew.h>\n"},
           {"app/b.h", "#include \"tools/a.h\"\n"},
           {"render/cpu/b.h", "#include \"render/gl/a.h\"\n"},
           {"render/geometry/b.h", "#include \"render/settings.h\"\n"},
           {"app/viewport/b.h", "#include \"app/tools/select.h\"\n"}}) {
    SCOPED_TRACE(std::string(file) + ": " + text);
    write(file, text);
    EXPECT_FALSE(passes());
    std::filesystem::remove(folder_ / file);
  }
  EXPECT_TRUE(passes());
}

TEST_F(Layers, FailWhereAFolderIsMissing) {
  for (const char* name : {"include", "core", "render", "tools", "app"}) {
    std::filesystem::rename(folder_ / name, folder_ / "elsewhere");
    EXPECT_FALSE(passes()) << name;
    std::filesystem::rename(folder_ / "elsewhere", folder_ / name);
  }
}

}  // namespace
}  // namespace brume
