#include "core/io/disk/temporary_files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

#include "brume/error.h"

namespace brume {
namespace {

enum class State { free, changing, named };

struct Slot {
  std::atomic<State> state = State::free;
  std::array<char, PATH_MAX> path{};
};

// A handler may neither wait nor allocate. Far more than are ever written at once; what finds no
// slot is written in any case.
std::array<Slot, 64> slots;
static_assert(std::atomic<State>::is_always_lock_free);

constexpr int max_depth = 8;  // of folders

// The entries that the system call getdents64 writes.
struct Entry {
  ino64_t inode;
  off64_t offset;
  unsigned short size;
  unsigned char type;
  char name[1];
};

// Like rm -r, with nothing but calls that a handler may make. NOLINTBEGIN(misc-no-recursion)
void remove_at(int folder, const char* name, int depth) {
  if (::unlinkat(folder, name, 0) == 0 || depth == max_depth) return;
  const int fd = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (fd < 0) return;
  alignas(Entry) char entries[2048];
  for (;;) {
    const long size = ::syscall(SYS_getdents64, fd, entries, sizeof entries);
    if (size <= 0) break;
    for (long offset = 0; offset < size;) {
      const auto* entry = reinterpret_cast<const Entry*>(entries + offset);
      const char* entry_name = entries + offset + offsetof(Entry, name);
      offset += entry->size;
      if (std::strcmp(entry_name, ".") == 0 || std::strcmp(entry_name, "..") == 0) continue;
      remove_at(fd, entry_name, depth + 1);
    }
  }
  ::close(fd);
  ::unlinkat(folder, name, AT_REMOVEDIR);
}
// NOLINTEND(misc-no-recursion)

extern "C" void remove_and_end(int signal) {
  for (const Slot& slot : slots) {
    if (slot.state.load(std::memory_order_acquire) != State::named) continue;
    remove_at(AT_FDCWD, slot.path.data(), 0);
  }
  // The handler was for one time: the signal comes again when this one returns.
  ::raise(signal);
}

}  // namespace

TemporaryName::TemporaryName(const std::filesystem::path& path) {
  const std::string& text = path.native();
  for (std::size_t k = 0; k < slots.size() && text.size() < PATH_MAX; ++k) {
    State expected = State::free;
    if (!slots[k].state.compare_exchange_strong(expected, State::changing)) continue;
    std::memcpy(slots[k].path.data(), text.c_str(), text.size() + 1);
    slots[k].state.store(State::named, std::memory_order_release);
    slot_ = static_cast<int>(k);
    return;
  }
}

TemporaryName::~TemporaryName() {
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state.store(State::free);
}

TemporaryName::TemporaryName(TemporaryName&& other) noexcept
    : slot_(std::exchange(other.slot_, -1)) {}

TemporaryName& TemporaryName::operator=(TemporaryName&& other) noexcept {
  std::swap(slot_, other.slot_);
  return *this;
}

void remove_temporary_files_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    ::sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;  // as nohup wants it
    struct sigaction action {};
    action.sa_handler = remove_and_end;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

namespace fs = std::filesystem;

StagingFolder::StagingFolder(const fs::path& parent, const fs::path& user) {
  static std::atomic<unsigned> counter = 0;
  std::error_code error;
  do {
    path_ = fs::weakly_canonical(parent, error) /
            (".brume-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
  } while (!error && fs::exists(path_));
  name_ = TemporaryName(path_);
  if (!error) fs::create_directory(path_, error);
  if (error) throw InputError(user, "", "cannot be created: " + error.message());
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace brume
