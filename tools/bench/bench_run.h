#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/gl_renderer.h"
#include "tools/bench/report/bench_report.h"

namespace brume {

struct BenchOptions {
  bool quick = false;                         // two minutes on two cores
  int threads = 0;                            // 0: all
  Backend backend = Backend::auto_;           // auto_: OpenGL too where there is a GPU
  std::vector<std::filesystem::path> scenes;  // in place of the built-in ones, and of all else
  std::vector<OtherRendererRow> peers;        // of other programs, see read_other_renderers()
};

struct BenchScene {
  std::string name;
  Scene scene;
};

// The scenes that are measured unless others are given. Quick: without those of resources/scenes.
std::vector<BenchScene> built_in_scenes(bool quick);

// `log` gets the name of each measurement before it starts.
BenchReport run_bench(const BenchOptions& options,
                      const std::function<void(const std::string&)>& log);

}  // namespace brume
