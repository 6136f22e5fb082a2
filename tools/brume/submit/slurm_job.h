#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brume {

// A text as one word of a POSIX shell.
std::string shell_word(const std::string& text);

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

// The script of a job. Throws UsageError for what sbatch cannot read.
std::string slurm_script(const SlurmJob& job);

// Writes the script and submits it; its id. Throws UsageError where sbatch refuses, and while a job
// of that name is queued or running: no two make one file.
std::string submit(const SlurmJob& job);
// A command that runs when a job is done, if it succeeds; without a job at once.
std::string submit_after(const std::string& job, const std::string& name,
                         const std::vector<std::string>& command);

// How many tasks of a job are queued or running.
int unfinished_tasks(const std::string& job);

}  // namespace brume
