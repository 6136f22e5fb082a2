#pragma once

namespace brume {

// Ends this program with the one that started it and reads its standard output: a reader of files
// that nobody waits for must not run on. The thread that started it must wait for it.
void end_with_parent();

}  // namespace brume
