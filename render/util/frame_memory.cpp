#include "render/util/frame_memory.h"

#include <cstdlib>  // __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace brume {

void keep_frame_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // an array of 2 million pixels
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace brume
