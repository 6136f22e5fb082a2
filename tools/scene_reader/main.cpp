// brume-scene-reader FILE MAX_BYTES MAX_SECONDS: reads an OBJ or FBX scene within limits of memory
// and time, for core/io/import/reader_program, and writes it to standard output as
// core/io/import/raw_scene_bytes has it. Exit code 0; 2 with the file's error on standard output;
// anything else is a failure of the library.

#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>

#include "brume/error.h"
#include "core/io/import/parent_program.h"
#include "core/io/import/raw_scene_bytes.h"
#include "tools/scene_reader/assimp_reader.h"

int main(int argc, char* argv[]) {
  if (argc != 4) return EXIT_FAILURE;
  const auto seconds = std::strtoull(argv[3], nullptr, 10);
  brume::limit_to_parent(std::strtoull(argv[2], nullptr, 10), seconds);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_FSIZE, &none);              // it writes no file
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
