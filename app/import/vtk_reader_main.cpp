// brume-vtk-points FILE OUT.ply MAX_GAUSSIANS MAX_BYTES MAX_SECONDS [ids]: converts the points of a
// VTK file to Gaussians, with ids on request, within limits of memory and CPU time. Exit code 0; 2
// with the file's error on standard output; anything else is a failure of VTK, described on
// standard error.

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "app/import/vtk_reader.h"
#include "brume/error.h"
#include "core/io/gaussians/gaussian_ply.h"
#include "core/io/import/parent_program.h"

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
  if (argc < 6) return EXIT_FAILURE;
  brume::end_with_parent();
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);  // threads take much address space each
  limit(RLIMIT_AS, address_space() + std::strtoull(argv[4], nullptr, 10));
  limit(RLIMIT_CPU, std::strtoull(argv[5], nullptr, 10));
  limit(RLIMIT_CORE, 0);
#ifdef M_PERTURB
  // Where an array ends too early VTK leaves memory as it was. Of 0x7f bytes are numbers that are
  // in no domain of a Gaussian.
  mallopt(M_PERTURB, 0x80);
#endif
  try {
    std::vector<brume::GaussianNumber> ids;
    const auto gaussians = brume::read_points_with_vtk(argv[1], argc > 6 ? &ids : nullptr,
                                                       std::strtoull(argv[3], nullptr, 10));
    brume::write_gaussians_ply(argv[2], gaussians, ids);
    return EXIT_SUCCESS;
  } catch (const brume::InputError& error) {
    std::puts(error.what());
    return 2;
  } catch (const std::exception&) {
    return EXIT_FAILURE;
  }
}
