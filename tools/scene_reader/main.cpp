// brume-scene-reader FILE MAX_BYTES MAX_SECONDS: reads an OBJ or FBX scene within limits of memory
// and time, for core/io/import/reader_program, and writes it to standard output as
// core/io/import/raw_scene_bytes has it. Exit code 0; 2 with the file's error on standard output;
// anything else is a failure of the library.

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>

#include "brume/error.h"
#include "core/io/import/parent_program.h"
#include "core/io/import/raw_scene_bytes.h"
#include "tools/scene_reader/assimp_reader.h"

namespace {

void limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

// The libraries take this much of the address space.
rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc != 4) return EXIT_FAILURE;
  brume::end_with_parent();
  const auto seconds = std::strtoull(argv[3], nullptr, 10);
  limit(RLIMIT_AS, address_space() + std::strtoull(argv[2], nullptr, 10));
  limit(RLIMIT_CPU, seconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);                      // it writes no file
  alarm(static_cast<unsigned>(20 * seconds));  // should it wait for something; others may be busy
  try {
    const brume::RawScene scene = brume::read_with_assimp(argv[1]);
    std::ios::sync_with_stdio(false);
    brume::write_raw_scene(std::cout, scene);
    std::cout.flush();
    return std::cout ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const brume::InputError& error) {
    std::cout << error.what();
    return 2;
  } catch (const std::exception&) {
    return EXIT_FAILURE;
  }
}
