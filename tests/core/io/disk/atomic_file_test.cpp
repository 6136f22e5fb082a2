#include "core/io/disk/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/core/io/input_error.h"
#include "tests/core/io/temporary_folder.h"

namespace brume {
namespace {

namespace fs = std::filesystem;

TEST(AtomicFile, ReplacesTheContent) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  write_atomically(file, "new");
  EXPECT_EQ(content_of(file), "new");
  EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(AtomicFile, PreservesTheOldFileWhenWritingFails) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
  EXPECT_THROW(write_atomically(file,
                                [](const fs::path& temporary) {
                                  std::ofstream(temporary) << "half of it";
                                  throw std::logic_error("stopped");
                                }),
               std::logic_error);
  EXPECT_EQ(content_of(file), "old");
  EXPECT_EQ(folder.entry_count(), 1u) << "the temporary file must be gone";
}

TEST(AtomicFile, PreservesPermissions) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.txt", "old");
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
TEST(AtomicFile, AbandonedFilesAreRemoved) {
  const TemporaryFolder folder;
  const fs::path abandoned = folder.write(".brume-1-0.tmp", "half");
  const fs::path other = folder.write(".brume-notes", "kept");
  write_atomically(folder / "a.txt", [&](const fs::path& temporary) {
    remove_abandoned_files(folder.path());
    EXPECT_TRUE(fs::exists(temporary));
    std::ofstream(temporary) << "whole";
  });
  EXPECT_EQ(content_of(folder / "a.txt"), "whole");
  EXPECT_FALSE(fs::exists(abandoned));
  EXPECT_TRUE(fs::exists(other));
  remove_abandoned_files(folder / "nowhere");
}

TEST(AtomicFile, WritesThroughALink) {
  const TemporaryFolder folder;
  const fs::path target = folder.write("inner/a.txt", "old");
  fs::create_symlink("inner/a.txt", folder / "link");
  write_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(target), "new");
}

TEST(AtomicFile, WritesThroughALinkToAFileThatIsNotThereYet) {
  const TemporaryFolder folder;
  fs::create_symlink("a.txt", folder / "link");
  write_atomically(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content_of(folder / "a.txt"), "new");
}

TEST(AtomicFile, RefusesWhatCannotBeWritten) {
  const TemporaryFolder folder;
  folder.write("plain", "");
  fs::create_directory(folder / "sub");
  fs::create_symlink("loop", folder / "loop");
  for (const char* name : {"missing/a.txt", "plain/a.txt", "sub", "loop"}) {
    SCOPED_TRACE(name);
    const std::string error = error_of([&] { write_atomically(folder / name, "x"); });
    EXPECT_TRUE(contains(error, (folder / name).string())) << error;
    EXPECT_TRUE(contains(error, "cannot be written")) << error;
  }
  EXPECT_TRUE(contains(error_of([&] { check_writable("/dev/null"); }), "regular file"));
}

// To open a pipe would be to wait for its other end.
TEST(AtomicFile, LeavesPipesWithNamesOfTemporaryFiles) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / ".brume-1.tmp").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((folder / ".brume-2.tmp").c_str(), 0600), 0);
  const int reader = ::open((folder / ".brume-2.tmp").c_str(), O_RDONLY | O_NONBLOCK);
  folder.write(".brume-3.tmp", "abandoned");
  remove_abandoned_files(folder.path());
  ::close(reader);
  EXPECT_EQ(folder.entry_count(), 2u);
}

TEST(AtomicFile, RefusesAFolderThatCannotBeWritten) {
  // Not even root makes files there.
  const std::string error = error_of([&] { write_atomically("/proc/brume-test", "x"); });
  EXPECT_TRUE(contains(error, "/proc/brume-test")) << error;
}

}  // namespace
}  // namespace brume
