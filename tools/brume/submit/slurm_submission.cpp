#include "tools/brume/submit/slurm_submission.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "core/io/disk/atomic_file.h"
#include "core/io/disk/content_hash.h"
#include "core/io/text_scanner.h"
#include "tools/brume/interruption.h"
#include "tools/brume/progress_line.h"

extern char** environ;

namespace brume {
namespace fs = std::filesystem;
namespace {

struct ProgramOutput {
  int exit_code = 0;  // -1: ended by a signal
  std::string out;    // its standard output
};

// Runs a program, found as a shell finds it, to its end; its errors go to ours. Throws UsageError
// if there is none of that name.
ProgramOutput run_other_program(const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::system_error(errno, std::generic_category(), "a pipe cannot be created");
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  pid_t id = -1;
  const int error = ::posix_spawnp(&id, pointers[0], &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  ProgramOutput result;
  std::array<char, 4096> piece;
  for (ssize_t count = 1; error == 0 && count != 0;) {
    count = ::read(ends[0], piece.data(), piece.size());
    if (count < 0 && errno != EINTR) break;
    if (count > 0) result.out.append(piece.data(), static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  if (error != 0) {
    throw UsageError("the program " + arguments.front() +
                     " cannot be run: " + std::strerror(error));
  }
  int status = 0;
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

// A job array of Slurm: each task is a command for some frames.
struct SlurmJob {
  std::string name;                      // the same of all jobs that make the same files
  std::filesystem::path script;          // is written
  std::vector<std::string> command;      // without --frames
  std::vector<std::vector<int>> chunks;  // frames of each task; none twice
  std::vector<std::string> options;      // more of sbatch's
  // The log of a task; `id` is the job's.
  [[nodiscard]] std::filesystem::path log(const std::string& id, const std::string& task) const;
};

// A text as one word of a POSIX shell.
std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string shell_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

// The log of all tasks as a line of a script has it: a backslash quotes, even in quotes, and one
// in the name itself would keep Slurm from filling in %A and %a. %% is a percent.
std::string log_pattern(const SlurmJob& job) {
  const std::string script = job.script.string();
  if (script.find('\\') != std::string::npos) {
    throw UsageError("-o: found " + quoted_text(script) + "; allowed for Slurm: names without \\");
  }
  SlurmJob escaped = job;
  escaped.script = replaced(replaced(script, "%", "%%"), "\"", "\\\"");
  return "\"" + escaped.log("%A", "%a").string() + "\"";
}

std::string checked(const std::vector<std::string>& arguments) {
  ProgramOutput result = run_other_program(arguments);
  if (result.exit_code != 0) {
    throw UsageError(arguments.front() + " refused; what it said is above");
  }
  while (result.out.ends_with('\n')) result.out.pop_back();
  return std::move(result.out);
}

std::filesystem::path SlurmJob::log(const std::string& id, const std::string& task) const {
  std::filesystem::path file = script;
  return file.replace_extension().string() + "_" + id + "_" + task + ".log";
}

// The script of a job. Throws UsageError for what sbatch cannot read.
std::string slurm_script(const SlurmJob& job) {
  for (const std::string& option : job.options) check_line(option);
  std::string text = "#!/bin/sh\n#SBATCH --job-name=" + job.name + "\n#SBATCH --array=0-" +
                     std::to_string(job.chunks.size() - 1) +
                     "\n#SBATCH --output=" + log_pattern(job) + "\n#SBATCH --requeue\n" +
                     "#SBATCH --open-mode=append\n";
  for (const std::string& option : job.options) text += "#SBATCH --" + option + "\n";
  text += "case \"$SLURM_ARRAY_TASK_ID\" in\n";
  for (std::size_t i = 0; i < job.chunks.size(); ++i) {
    text += std::to_string(i) + ") frames=" + frames_text(job.chunks[i]) + " ;;\n";
  }
  return text + "esac\nexec " + shell_words(job.command) + " --frames \"$frames\"\n";
}

// Writes the script and submits it; its id. Throws UsageError where sbatch refuses, and while a job
// of that name is queued or running: no two make one file.
std::string submit(const SlurmJob& job) {
  const std::string running =
      checked({"squeue", "--noheader", "--name", job.name, "--format", "%A"});
  if (!running.empty()) {
    throw UsageError("the job " + running.substr(0, running.find('\n')) +
                     " makes the same files and is not finished; allowed: afterwards, or after "
                     "scancel");
  }
  write_atomically(job.script, slurm_script(job));
  const std::string id = checked({"sbatch", "--parsable", job.script.string()});
  return id.substr(0, id.find(';'));  // what follows is the cluster
}

// A command that runs when a job is done, if it succeeds; without a job at once.
std::string submit_after(const std::string& job, const std::string& name,
                         const std::vector<std::string>& command) {
  std::vector<std::string> arguments{"sbatch", "--parsable", "--job-name",
                                     name,     "--wrap",     shell_words(command)};
  if (!job.empty()) arguments.insert(arguments.end() - 2, "--dependency=afterok:" + job);
  return checked(arguments);
}

// How many tasks of a job are queued or running.
int unfinished_tasks(const std::string& job) {
  // A job that is long gone is an error of squeue.
  const ProgramOutput result = run_other_program(
      {"squeue", "--noheader", "--array", "--states=all", "--jobs", job, "--format", "%T"});
  if (result.exit_code != 0) return 0;
  int count = 0;
  for (std::size_t begin = 0; begin < result.out.size();) {
    const std::size_t end = std::min(result.out.find('\n', begin), result.out.size());
    const std::string state = result.out.substr(begin, end - begin);
    count += static_cast<int>(state == "PENDING" || state == "RUNNING" || state == "COMPLETING" ||
                              state == "CONFIGURING" || state == "SUSPENDED" ||
                              state == "REQUEUED" || state == "STOPPED");
    begin = end + 1;
  }
  return count;
}

constexpr int max_attempts = 5;

std::vector<std::vector<int>> chunks_of(const std::vector<int>& frames, std::size_t size) {
  std::vector<std::vector<int>> chunks;
  for (std::size_t i = 0; i < frames.size(); i += size) {
    chunks.emplace_back(
        frames.begin() + static_cast<std::ptrdiff_t>(i),
        frames.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, frames.size())));
  }
  return chunks;
}

// Eight digits that other texts do not have.
std::string short_hash(const std::string& text) {
  ContentHash hash;
  hash.add(std::span<const char>(text));
  std::string digits;
  for (int i = 0; i < 8; ++i) digits += "0123456789abcdef"[hash.value() >> 4 * i & 15];
  return digits;
}

SlurmJob new_job(const SequenceJob& sequence, const std::vector<std::string>& sbatch) {
  const fs::path output = sequence.output();
  SlurmJob job;
  job.name = "brume-" + sequence.stem() + "-" + short_hash(output.string());
  job.script = output.parent_path() / (sequence.stem() + ".sbatch");
  job.command = {fs::read_symlink("/proc/self/exe").string(), "render"};
  for (std::string& argument : sequence.options.arguments(sequence.own_options)) {
    job.command.push_back(std::move(argument));
  }
  job.command.push_back("--skip-existing");
  job.options = sbatch;
  return job;
}

// Until no task of a job is queued or running.
void watch(const SequenceJob& sequence, const FrameFingerprint& fingerprint,
           const std::string& id) {
  const std::vector<int> frames = sequence.options.frames();
  const ProgressLine line("job " + id);
  const auto progress = line.progress();
  while (unfinished_tasks(id) > 0) {
    check_interrupted();
    if (progress) {
      const auto rest = static_cast<double>(sequence.not_current(frames, fingerprint).size());
      progress(1.0 - rest / static_cast<double>(frames.size()));
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

// Frames of which the logs of a job tell an error, which is passed on.
std::set<int> frames_that_failed(const SlurmJob& job, const std::string& id) {
  std::set<int> frames;
  for (std::size_t task = 0; task < job.chunks.size(); ++task) {
    const fs::path file = job.log(id, std::to_string(task));
    std::error_code error;
    if (!fs::is_regular_file(file, error)) continue;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
      constexpr std::string_view begin = "brume: error: frame ";
      if (!line.starts_with(begin)) continue;
      frames.insert(std::atoi(line.c_str() + begin.size()));
      print_note(line.substr(std::string_view("brume: ").size()));
    }
  }
  return frames;
}

}  // namespace

ExitCode submit_to_slurm(const SequenceJob& sequence, const FrameFingerprint& fingerprint,
                         const SlurmOptions& options) {
  SlurmJob job = new_job(sequence, options.sbatch);
  const std::vector<int> all = sequence.options.frames();
  std::vector<int> wanted = sequence.not_current(all, fingerprint);
  std::vector<int> failed;
  nlohmann::ordered_json result{{"jobs", nlohmann::json::array()}};
  const auto submit_video = [&](const std::string& after) {
    if (sequence.video.empty()) return;
    result["video"] = submit_after(
        after, job.name + "-video",
        sequence.video_command(FramePattern::parse(sequence.output().string())->printf_text(),
                               fs::absolute(sequence.video).lexically_normal()));
  };
  for (int attempt = 0; attempt < max_attempts && !wanted.empty(); ++attempt) {
    job.chunks = chunks_of(wanted, sequence.chunk);
    const std::string id = submit(job);
    result["jobs"].push_back(id);
    if (!options.watches) {
      submit_video(id);
      result["submitted"] = wanted;
      print_result(result.dump() + "\n");
      return done;
    }
    watch(sequence, fingerprint, id);
    wanted = sequence.not_current(wanted, fingerprint);
    const std::set<int> told = frames_that_failed(job, id);
    std::erase_if(wanted, [&](int frame) {
      if (told.contains(frame)) failed.push_back(frame);
      return told.contains(frame);
    });
    if (!wanted.empty()) {
      print_note("frames " + frames_text(wanted) + " were lost with their tasks");
    }
  }
  result["done"] = all.size() - failed.size() - wanted.size();
  result["failed"] = failed;
  result["lost"] = wanted;
  const bool is_whole = failed.empty() && wanted.empty();
  if (is_whole) submit_video("");
  print_result(result.dump() + "\n");
  return is_whole ? done : check_failed;
}

}  // namespace brume
