#include "tools/brume/submit/slurm_job.h"

#include <algorithm>
#include <utility>

#include "core/io/disk/atomic_file.h"
#include "core/io/text_scanner.h"
#include "tools/brume/command.h"
#include "tools/brume/other_program.h"
#include "tools/brume/submit/sequence_job.h"

namespace brume {
namespace {

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

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::filesystem::path SlurmJob::log(const std::string& id, const std::string& task) const {
  std::filesystem::path file = script;
  return file.replace_extension().string() + "_" + id + "_" + task + ".log";
}

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

std::string submit_after(const std::string& job, const std::string& name,
                         const std::vector<std::string>& command) {
  std::vector<std::string> arguments{"sbatch", "--parsable", "--job-name",
                                     name,     "--wrap",     shell_words(command)};
  if (!job.empty()) arguments.insert(arguments.end() - 2, "--dependency=afterok:" + job);
  return checked(arguments);
}

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

}  // namespace brume
