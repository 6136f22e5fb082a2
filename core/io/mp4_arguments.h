#pragma once

#include <array>

namespace brume {

// How ffmpeg writes an MP4: as players expect it, with sides that are even. Colours are rounded,
// not cut off, and the quality is high enough for the dither of dim pictures.
inline constexpr std::array mp4_arguments{"-vf",        "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                          "-sws_flags", "accurate_rnd+full_chroma_int",
                                          "-pix_fmt",   "yuv420p",
                                          "-crf",       "14"};

}  // namespace brume
