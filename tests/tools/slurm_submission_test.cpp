// Scripts for Slurm, whose programs are stand-ins here.

#include <nlohmann/json.hpp>

#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class SlurmSubmission : public CommandLine {
 protected:
  SlurmSubmission() {
    write_program("squeue", "exit 0");
    // The task ends at once; `log_` has what it says.
    write_program("sbatch",
                  "for script; do :; done; log=${script%.sbatch}_17_0.log\n"
                  "cp '" +
                      file("log") + "' \"$log\"; echo 17");
    folder_.write("log", "");
  }

  void write_program(const char* name, const std::string& text) const {
    const fs::path program = folder_.write(name, "#!/bin/sh\n" + text + "\n");
    fs::permissions(program, fs::perms::owner_all);
  }
  ProgramResult submit(std::vector<std::string> more) const {
    return run_brume(joined({"submit", "slurm", scene_, "--airlight", "paper"}, more),
                     {.before = "PATH=" + quoted(folder_.path().string()) + ":$PATH "});
  }
  // The file that an #SBATCH line asks for, as sbatch reads such lines and Slurm its patterns.
  static std::string log_of(const std::string& script, const std::string& task) {
    const std::string begin = "#SBATCH --output=";
    std::size_t place = script.find(begin);
    EXPECT_NE(place, std::string::npos) << script;
    std::string pattern;
    char quote = '\0';
    for (place += begin.size(); script[place] != '\n'; ++place) {
      const char c = script[place];
      if (c == '\\') {
        pattern += script[++place];
      } else if (quote == '\0' && (c == '"' || c == '\'')) {
        quote = c;
      } else if (c == quote) {
        quote = '\0';
      } else {
        EXPECT_TRUE(quote != '\0' || (c != ' ' && c != '#')) << script;
        pattern += c;
      }
    }
    EXPECT_EQ(pattern.find('\\'), std::string::npos) << "Slurm fills in nothing then";
    std::string log;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
      if (pattern[i] != '%') {
        log += pattern[i];
        continue;
      }
      const char what = pattern[++i];
      EXPECT_TRUE(what == '%' || what == 'A' || what == 'a') << pattern;
      log += what == '%' ? "%" : what == 'A' ? "17" : task;
    }
    return log;
  }
};

TEST_F(SlurmSubmission, LogsLieBesideFramesInAnyFolder) {
  for (const std::string folder :
       {"plain", "a b", "50%", "%A_%a", "%j", "it's", "\"quoted\"", "a#b", "$HOME`x`", "ä"}) {
    SCOPED_TRACE(folder);
    const ProgramResult result =
        submit({"--frames", "1-2", "-o", file((folder + "/f_%d.exr").c_str())});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(Json::parse(result.out)["jobs"], Json({"17"}));
    const std::string script = content_of(folder_ / (folder + "/f.sbatch"));
    EXPECT_EQ(log_of(script, "0"), file((folder + "/f_17_0.log").c_str()));
  }
}

TEST_F(SlurmSubmission, FramesThatFailedAreNotLost) {
  folder_.write("log", "brume: error: frame 2: no such file\n");
  const ProgramResult result = submit({"--frames", "2", "--watch", "-o", file("%A%a/f_%d.exr")});
  EXPECT_EQ(result.exit_code, 1);
  const Json told = Json::parse(result.out);
  EXPECT_EQ(told["jobs"].size(), 1u);
  EXPECT_EQ(told["failed"], Json({2}));
  EXPECT_EQ(told["lost"], Json::array());
}

TEST_F(SlurmSubmission, RefusesWhatAScriptCannotSay) {
  const std::size_t entries = folder_.entry_count();
  const auto refused = [this](std::vector<std::string> more) {
    const ProgramResult result = submit(std::move(more));
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_TRUE(contains(result.err, "allowed"));
  };
  refused({"--frames", "1", "-o", file("out\ntouch INJECTED\n#/f_%d.exr")});
  refused({"--frames", "1", "-o", file("a\tb/f_%d.exr")});
  refused({"--frames", "1", "-o", file("a\x7f/f_%d.exr")});
  refused({"--frames", "1", "-o", file("a\\b/f_%d.exr")});
  refused({"--frames", "1", "-o", file("f_%d.exr"), "--camera", "a\rb"});
  refused({"--frames", "1", "-o", file("f_%d.exr"), "--sbatch", "mem=4G\nx"});
  EXPECT_EQ(folder_.entry_count(), entries);
  expect_refused({"submit", "openjd", scene_, "--frames", "1", "-o", file("a\nb/f_%d.exr")},
                 {"control characters"});
  expect_refused({"submit", "openjd", scene_, "--frames", "1", "-o", file("5%/f_%d.png"), "--video",
                  file("film.mp4")},
                 {"without %"});
}

TEST_F(SlurmSubmission, VideosFindFramesInFoldersWithPercents) {
  write_program("sbatch", "echo \"$@\" >>'" + file("calls") + "'; echo 17");
  const ProgramResult result =
      submit({"--frames", "1-2", "-o", file("5%d/%%_%d.png"), "--video", file("film.mp4")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string calls = content_of(folder_ / "calls");
  EXPECT_TRUE(contains(calls, file("5%%d/%%_%d.png")));
}

}  // namespace
}  // namespace brume
