// test_app SUITE [ARGUMENT...]: runs a suite with the arguments of Qt Test, such as the names of
// functions.

#include <QApplication>
#include <QSettings>
#include <cstdio>
#include <map>
#include <string>

#include "app/widgets/application.h"
#include "tests/app/test_window.h"

namespace brume {
namespace {

using Suites = std::map<std::string, int (*)(int, char**)>;

Suites& suites() {
  static Suites all;
  return all;
}

// With settings and a cache of its own: the user's stay untouched. Views show light scattered once,
// which takes a fraction of the time; ScatteringTest is about all orders.
int run_suite(int (*run)(int, char**), int argc, char** argv) {
  const QTemporaryDir settings;
  // Qt ends a test that takes five minutes; beside a full load some do.
  qputenv("QTEST_FUNCTION_TIMEOUT", "1200000");
  prepare_application_in(settings);
  QApplication application(argc, argv);
  set_up_application(application);
  QSettings().setValue("view/scattering", "single");
  return run(argc, argv);
}

}  // namespace

AppSuite::AppSuite(const char* name, int (*run)(int, char**)) {
  suites().emplace(name, run);
}

}  // namespace brume

int main(int argc, char** argv) {
  const auto found = argc > 1 ? brume::suites().find(argv[1]) : brume::suites().end();
  if (found == brume::suites().end()) {
    std::fprintf(stderr, "usage: test_app SUITE [ARGUMENT...]\nSuites:");
    for (const auto& [name, run] : brume::suites()) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  argv[1] = argv[0];
  return brume::run_suite(found->second, argc - 1, argv + 1);
}
