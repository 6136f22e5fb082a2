#include "core/io/disk/temporary_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "brume/error.h"
#include "core/io/disk/atomic_file.h"
#include "tests/core/io/folder_test.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

// How a separate process that does `work` ends, with the handlers of the programs.
int status_of(const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    remove_temporary_files_on_signals();
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

// The status of a program that began with a signal's disposition and gets it in the middle of a
// file.
int status_of_writing(const fs::path& file, int signal, void (*disposition)(int)) {
  return status_of([&] {
    ::signal(signal, disposition);
    remove_temporary_files_on_signals();
    write_atomically(file, [signal](const fs::path& temporary) {
      std::ofstream(temporary) << "half of it";
      ::raise(signal);
    });
  });
}

using TemporaryFiles = FolderTest;

TEST_F(TemporaryFiles, AreRemovedOnSignals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(signal);
    const TemporaryFolder folder;
    const fs::path file = folder.write("a.txt", "old");
    const int status = status_of_writing(file, signal, SIG_DFL);  // what runs us may ignore it
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal) << "a shell must see what ended the program";
    EXPECT_EQ(content_of(file), "old");
    EXPECT_EQ(folder.entry_count(), 1u);
  }
}

TEST_F(TemporaryFiles, AreRemovedWithTheirFolders) {
  const fs::path outside = folder_.write("outside.txt", "stays");
  const int status = status_of([&] {
    const TemporaryName name(folder_ / "made");
    folder_.write("made/files/inner/a.txt", "a");
    for (int k = 0; k < 200; ++k) folder_.write("made/b" + std::to_string(k), "b");
    fs::create_symlink(outside, folder_ / "made/link");
    fs::create_directory_symlink(folder_.path(), folder_ / "made/up");
    ::raise(SIGTERM);
  });
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(fs::exists(folder_ / "made"));
  EXPECT_EQ(content_of(outside), "stays");
}

TEST_F(TemporaryFiles, RemainWhereTheSignalIsIgnored) {
  const fs::path file = folder_.write("a.txt", "old");
  const int status = status_of_writing(file, SIGHUP, SIG_IGN);  // as nohup does
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(content_of(file), "half of it");
}

TEST_F(TemporaryFiles, FinishedFilesStay) {
  status_of([&] {
    for (int k = 0; k < 200; ++k) write_atomically(folder_ / "a.txt", "new");
    ::raise(SIGTERM);
  });
  EXPECT_EQ(content_of(folder_ / "a.txt"), "new");
}

TEST_F(TemporaryFiles, FilesBeyondTheLimitAreAnError) {
  const fs::path file = folder_.write("a.txt", "old");
  const int status = status_of([&] {
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_atomically(file, std::string(100'000, 'x'));
    } catch (const InputError&) {
      ::_exit(2);
    }
  });
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2);
  EXPECT_EQ(content_of(file), "old");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

}  // namespace
}  // namespace brume
