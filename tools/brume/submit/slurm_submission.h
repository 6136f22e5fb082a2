#pragma once

#include <string>
#include <vector>

#include "tools/brume/command.h"
#include "tools/brume/submit/sequence_job.h"

namespace brume {

struct SlurmOptions {
  std::vector<std::string> sbatch;  // options of sbatch without their dashes
  bool watches = false;             // waits, and submits again what was lost
};

// Submits what is not current of a sequence to Slurm, and prints what was done as JSON.
ExitCode submit_to_slurm(const SequenceJob& sequence, const FrameFingerprint& fingerprint,
                         const SlurmOptions& options);

}  // namespace brume
