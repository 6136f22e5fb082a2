// Jobs of the Open Job Description, run as its specification says: template schema 2023-09
// (github.com/OpenJobDescription/openjd-specifications).

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>

#include "core/io/disk/file_bytes.h"
#include "tests/contains.h"
#include "tests/tools/command_line.h"

namespace brume {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// "1-9:2,12" as 1, 3, 5, 7, 9, 12; no ranges may overlap.
std::vector<int> values_of(const std::string& range) {
  std::vector<int> values;
  const std::regex element(R"((\d+)(?:-(\d+)(?::(\d+))?)?(,|$))");
  std::string::const_iterator at = range.begin();
  std::smatch found;
  while (at != range.end() && std::regex_search(at, range.end(), found, element,
                                                std::regex_constants::match_continuous)) {
    const int first = std::stoi(found[1]);
    const int last = found[2].matched ? std::stoi(found[2]) : first;
    const int step = found[3].matched ? std::stoi(found[3]) : 1;
    EXPECT_TRUE(values.empty() || values.back() < first) << range;
    for (int value = first; value <= last; value += step) values.push_back(value);
    at = found[0].second;
  }
  EXPECT_EQ(at, range.end()) << range;
  return values;
}

// An engine that knows of the schema what Brume needs, and refuses all else.
class Engine {
 public:
  explicit Engine(const fs::path& bundle)
      : job_(Json::parse(read_bytes(bundle / "template.json"))) {
    expect_keys(job_,
                {"specificationVersion", "extensions", "name", "parameterDefinitions", "steps"});
    EXPECT_EQ(job_["specificationVersion"], "jobtemplate-2023-09");
    EXPECT_EQ(job_["extensions"], Json({"TASK_CHUNKING"}));
    EXPECT_LE(job_["name"].get<std::string>().size(), 128u);
    for (const Json& parameter : job_["parameterDefinitions"]) {
      expect_keys(parameter,
                  {"name", "type", "objectType", "dataFlow", "description", "default", "minValue"});
      const std::string name = parameter["name"];
      EXPECT_TRUE(std::regex_match(name, std::regex("[A-Za-z_][A-Za-z0-9_]{0,63}"))) << name;
      if (parameter["type"] == "PATH") {
        EXPECT_FALSE(parameter.contains("default")) << "may not be absolute";
      } else {
        set(name, parameter["default"]);
      }
    }
    const Json values = Json::parse(read_bytes(bundle / "parameter_values.json"));
    for (const Json& value : values["parameterValues"]) set(value["name"], value["value"]);
    EXPECT_EQ(values_.size(), job_["parameterDefinitions"].size());
  }

  void set(const std::string& parameter, const Json& value) {
    values_["Param." + parameter] = value.is_string() ? value.get<std::string>() : value.dump();
  }

  // Runs all tasks, the last first; what they printed, by chunk.
  std::map<std::string, ProgramResult> run() {
    std::map<std::string, ProgramResult> results;
    const Json& step = job_["steps"][0];
    expect_keys(step, {"name", "parameterSpace", "script"});
    const Json& parameters = step["parameterSpace"]["taskParameterDefinitions"];
    EXPECT_EQ(parameters.size(), 1u);
    const Json& parameter = parameters[0];
    expect_keys(parameter, {"name", "type", "range", "chunks"});
    EXPECT_EQ(parameter["type"], "CHUNK[INT]");
    EXPECT_EQ(parameter["chunks"]["rangeConstraint"], "NONCONTIGUOUS");
    const std::size_t count = std::stoul(resolved(parameter["chunks"]["defaultTaskCount"]));
    std::vector<int> frames = values_of(resolved(parameter["range"]));
    while (!frames.empty()) {
      const std::size_t rest = (frames.size() - 1) / count * count;
      std::string chunk;
      for (std::size_t i = rest; i < frames.size(); ++i) {
        chunk += (chunk.empty() ? "" : ",") + std::to_string(frames[i]);
      }
      frames.resize(rest);
      values_["Task.Param." + parameter["name"].get<std::string>()] = chunk;
      results[chunk] = run_brume(command(step));
    }
    return results;
  }

  // That of a step's tasks, without the program.
  std::vector<std::string> command(const Json& step) {
    const Json& run = step["script"]["actions"]["onRun"];
    expect_keys(run, {"command", "args", "cancelation"});
    expect_keys(run["cancelation"], {"mode", "notifyPeriodInSeconds"});
    program_ = resolved(run["command"]);
    std::vector<std::string> arguments;
    for (const Json& argument : run["args"]) arguments.push_back(resolved(argument));
    return arguments;
  }

  [[nodiscard]] const Json& job() const { return job_; }
  [[nodiscard]] const std::string& program() const { return program_; }

 private:
  static void expect_keys(const Json& object, const std::set<std::string>& allowed) {
    for (const auto& [key, value] : object.items()) EXPECT_TRUE(allowed.contains(key)) << key;
  }

  std::string resolved(std::string text) const {
    for (std::size_t begin = 0; (begin = text.find("{{")) != std::string::npos;) {
      const std::size_t end = text.find("}}", begin);
      const auto value = values_.find(text.substr(begin + 2, end - begin - 2));
      if (value == values_.end()) throw std::runtime_error("nothing is known of " + text);
      text.replace(begin, end + 2 - begin, value->second);
    }
    return text;
  }

  Json job_;
  std::map<std::string, std::string> values_;
  std::string program_;
};

class JobBundle : public CommandLine {
 protected:
  fs::path bundle(std::vector<std::string> more) {
    const ProgramResult result =
        expect_done(joined({"submit", "openjd", scene_, "--airlight", "sliced", "--scattering",
                            "single", "--fps", "10", "--size", "16x12", "--backend", "cpu"},
                           more));
    errors_ = result.err;
    return Json::parse(result.out)["bundle"].get<std::string>();
  }

  std::string errors_;
};

TEST_F(JobBundle, TasksMakeTheFramesOfTheSequence) {
  fs::create_directory(folder_ / "farm");
  fs::create_directory(folder_ / "here");
  const fs::path folder =
      bundle({"--frames", "7,0-4x2,3", "-o", file("farm/f_%02d.exr"), "--chunk", "2"});
  EXPECT_EQ(folder, folder_ / "farm/f.openjd");
  EXPECT_EQ(errors_, "");
  Engine engine(folder);
  const auto results = engine.run();
  EXPECT_EQ(engine.program(), "brume");
  ASSERT_EQ(results.size(), 3u);
  for (const auto& [chunk, result] : results) {
    EXPECT_EQ(result.exit_code, 0) << chunk << result.err;
    EXPECT_TRUE(contains(result.out, "openjd_status: frame ", "\nopenjd_progress: 100\n"));
    EXPECT_FALSE(contains(result.out, "openjd_fail"));
  }
  run_brume({"render", scene_, "--airlight", "sliced", "--scattering", "single", "--fps", "10",
             "--size", "16x12", "--backend", "cpu", "--frames", "0,2,3,4,7", "-o",
             file("here/f_%02d.exr")});
  for (const char* frame : {"f_00.exr", "f_02.exr", "f_03.exr", "f_04.exr", "f_07.exr"}) {
    EXPECT_EQ(read_bytes(folder_ / "farm" / frame), read_bytes(folder_ / "here" / frame)) << frame;
  }
}

// A farm may copy the folder of the scene, and map both.
TEST_F(JobBundle, PathsAreParameters) {
  fs::create_directory(folder_ / "worker");
  fs::create_directory(folder_ / "frames");
  Engine engine(bundle({"--frames", "0-1", "-o", file("f_%d.png")}));
  fs::rename(folder_ / "a.brume", folder_ / "worker/a.brume");
  fs::rename(folder_ / "floor.obj", folder_ / "worker/floor.obj");
  engine.set("SceneFolder", file("worker"));
  engine.set("FrameFolder", file("frames"));
  engine.set("FramesPerTask", "5");
  EXPECT_EQ(engine.run().size(), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "frames/f_0.png"));
  EXPECT_TRUE(fs::exists(folder_ / "frames/f_1.png"));
}

TEST_F(JobBundle, TellsOfFramesThatFail) {
  Engine engine(bundle({"--frames", "0-2", "-o", file("f_%d.exr")}));
  fs::create_directory(folder_ / "f_1.exr");
  fs::create_directory(folder_ / "f_1.exr/full");
  const auto results = engine.run();
  ASSERT_EQ(results.size(), 1u);
  const ProgramResult& result = results.begin()->second;
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(contains(result.out, "openjd_fail: ")) << result.out << result.err;
}

TEST_F(JobBundle, VideosFollowTheirFrames) {
  Engine engine(bundle({"--frames", "3-5", "-o", file("f_%d.png"), "--video", file("film.mp4")}));
  const Json& step = engine.job()["steps"][1];
  EXPECT_EQ(step["dependencies"], Json::parse(R"([{"dependsOn": "Render"}])"));
  const std::vector<std::string> arguments = engine.command(step);
  EXPECT_EQ(engine.program(), "ffmpeg");
  EXPECT_EQ(arguments.back(), file("film.mp4"));
  EXPECT_TRUE(std::ranges::count(arguments, file("f_%d.png"))) << Json(arguments).dump();
}

TEST_F(JobBundle, WarnOfFilesThatAFarmWouldNotCopy) {
  fs::create_directory(folder_ / "scenes");
  std::string text = scene_text;
  text.replace(text.find("floor.obj"), 9, "../floor.obj");
  scene_ = folder_.write("scenes/b.brume", text);
  bundle({"--frames", "0", "-o", file("f_%d.exr")});
  EXPECT_TRUE(contains(errors_, "brume gather"));
}

TEST_F(JobBundle, RefuseWhatATemplateCannotSay) {
  const auto refused = [this](std::vector<std::string> more, const std::string& part) {
    expect_refused(joined({"submit", "openjd", scene_}, more), {part});
  };
  refused({"--frames", "0", "-o", file("{{Param.Frames}}_%d.exr")}, "without {{");
  refused({"--frames", "0", "-o", file("f_%d.exr"), "--watch"}, "of slurm");
  std::string frames;
  for (int i = 0; i < 400; ++i) frames += (i ? "," : "") + std::to_string(i * i);
  refused({"--frames", frames, "-o", file("f_%d.exr")}, "at most 1024 characters");
  refused({"--frames", "0", "-o", file("floor.obj/f_%d.exr")}, "floor.obj");
  EXPECT_EQ(run_brume({"submit", "cron", scene_, "--frames", "0", "-o", "f_%d.exr"}).exit_code, 2);
}

// Scripts for Slurm, whose programs are stand-ins here.

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
