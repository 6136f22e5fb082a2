#pragma once

#include <filesystem>

#include "core/io/scene/scene_document.h"
#include "tools/brume/submit/sequence_job.h"

namespace brume {

// Writes a job of the Open Job Description, the template schema 2023-09 with its extension
// TASK_CHUNKING (github.com/OpenJobDescription/openjd-specifications): a folder beside the frames
// with template.json, whose paths are parameters, and their values as AWS Deadline Cloud reads
// them, parameter_values.json. Its frames are those of the sequence, in any order. Returns the
// folder. Throws UsageError where an option cannot be part of a template, InputError where a file
// cannot be written.
std::filesystem::path write_job_bundle(const SequenceJob& sequence, const SceneDocument& document);

}  // namespace brume
