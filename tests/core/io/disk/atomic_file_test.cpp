#include "core/io/disk/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include "brume/error.h"
#include "core/io/disk/temporary_files.h"
#include "tests/core/io/folder_test.h"
#include "tests/core/io/input_error.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

using AtomicFile = FolderTest;

TEST_F(AtomicFile, ReplacesTheContent) {
  const fs::path file = folder_.write("a.txt", "old");
  write_atomically(file, "new");
  EXPECT_EQ(content_of(file), "new");
  EXPECT_EQ(folder_.entry_count(), 1u);
}

TEST_F(AtomicFile, PreservesTheOldFileWhenWritingFails) {
  const fs::path file = folder_.write("a.txt", "old");
  EXPECT_THROW(write_atomically(file,
                                [](const fs::path& temporary) {
                                  std::ofstream(temporary) << "half of it";
                                  throw std::logic_error("stopped");
                                }),
               std::logic_error);
  EXPECT_EQ(content_of(file), "old");
  EXPECT_EQ(folder_.entry_count(), 1u) << "the temporary file must be gone";
}

TEST_F(AtomicFile, PreservesPermissions) {
  const fs::path file = folder_.write("a.txt", "old");
  const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read;
  fs::permissions(file, mode);
  write_atomically(file, "new");
  EXPECT_EQ(fs::status(file).permissions(), mode);
}

TEST(FileGroup, ReplacesAllFilesTogether) {
  const TemporaryFolder folder;
  const fs::path first = folder.write("a/first.txt", "old");
  const fs::path second = folder.write("b/second.txt", "old");
  fs::permissions(second, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("b/second.txt", folder / "link");
  {
    FileGroup group;
    write_atomically(first, "new");
    write_atomically(folder / "link", "new");
    EXPECT_EQ(content_of(first), "old");
    EXPECT_EQ(content_of(second), "old");
    group.commit();
  }
  EXPECT_EQ(content_of(first), "new");
  EXPECT_EQ(content_of(second), "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(fs::status(second).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(folder.entry_count(), 5u) << "nothing else is left";
  write_atomically(first, "newer");
  EXPECT_EQ(content_of(first), "newer");
}

TEST(FileGroup, ReplacesNoneWhereOneFails) {
  const TemporaryFolder folder;
  const fs::path first = folder.write("first.txt", "old");
  EXPECT_THROW(
      {
        FileGroup group;
        write_atomically(first, "new");
        write_atomically(folder / "second.txt",
                         [](const fs::path&) { throw std::logic_error("stopped"); });
        group.commit();
      },
      std::logic_error);
  EXPECT_EQ(content_of(first), "old");
  EXPECT_EQ(folder.entry_count(), 1u);
}

// Leftovers of a killed program, but no file that is being written.
TEST_F(AtomicFile, AbandonedFilesAreRemoved) {
  const fs::path abandoned = folder_.write(".brume-1-0.tmp", "half");
  const fs::path other = folder_.write(".brume-notes", "kept");
  write_atomically(folder_ / "a.txt", [&](const fs::path& temporary) {
    remove_abandoned_files(folder_.path());
    EXPECT_TRUE(fs::exists(temporary));
    std::ofstream(temporary) << "whole";
  });
  EXPECT_EQ(content_of(folder_ / "a.txt"), "whole");
  EXPECT_FALSE(fs::exists(abandoned));
  EXPECT_TRUE(fs::exists(other));
  remove_abandoned_files(folder_ / "nowhere");
}

TEST_F(AtomicFile, WritesThroughALink) {
  const fs::path target = folder_.write("inner/a.txt", "old");
  fs::create_symlink("inner/a.txt", folder_ / "link");
  write_atomically(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(target), "new");
}

TEST_F(AtomicFile, WritesThroughALinkToAFileThatIsNotThereYet) {
  fs::create_symlink("a.txt", folder_ / "link");
  write_atomically(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "a.txt"), "new");
}

TEST_F(AtomicFile, RefusesWhatCannotBeWritten) {
  folder_.write("plain", "");
  fs::create_directory(folder_ / "sub");
  fs::create_symlink("loop", folder_ / "loop");
  for (const char* name : {"missing/a.txt", "plain/a.txt", "sub", "loop"}) {
    SCOPED_TRACE(name);
    expect_error([&] { write_atomically(folder_ / name, "x"); },
                 {(folder_ / name).string(), "cannot be written"});
  }
  expect_error([&] { check_writable("/dev/null"); }, "regular file");
}

// To open a pipe would be to wait for its other end.
TEST_F(AtomicFile, LeavesPipesWithNamesOfTemporaryFiles) {
  ASSERT_EQ(::mkfifo((folder_ / ".brume-1.tmp").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((folder_ / ".brume-2.tmp").c_str(), 0600), 0);
  const int reader = ::open((folder_ / ".brume-2.tmp").c_str(), O_RDONLY | O_NONBLOCK);
  folder_.write(".brume-3.tmp", "abandoned");
  remove_abandoned_files(folder_.path());
  ::close(reader);
  EXPECT_EQ(folder_.entry_count(), 2u);
}

TEST_F(AtomicFile, RefusesAFolderThatCannotBeWritten) {
  // Not even root makes files there.
  expect_error([&] { write_atomically("/proc/brume-test", "x"); }, "/proc/brume-test");
}

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
