#pragma once

#include <cstdint>

namespace brume {

// Ends this program with the one that started it and reads its standard output: a reader of files
// that nobody waits for must not run on. The thread that started it must wait for it. From then on
// it may take this much memory beyond its libraries [bytes], and so much CPU time [s].
void limit_to_parent(std::uint64_t max_bytes, std::uint64_t max_seconds);

}  // namespace brume
