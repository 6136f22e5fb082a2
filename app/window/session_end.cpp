#include "app/window/session_end.h"

#include <fcntl.h>
#include <unistd.h>

#include <QEvent>
#include <QGuiApplication>
#include <QSocketNotifier>
#include <QWindow>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace brume {
namespace {

struct Signal {
  int number;
  struct sigaction former {};
  bool is_handled = false;
};
std::array signals{Signal{SIGHUP}, Signal{SIGINT}, Signal{SIGTERM}};
std::array<int, 2> pipe_ends{-1, -1};

// The event loop does the work: a handler may not.
extern "C" void pass_on(int number) {
  const int error = errno;
  const auto* signal = std::ranges::find(signals, number, &Signal::number);
  ::sigaction(number, &signal->former, nullptr);
  const auto byte = static_cast<unsigned char>(number);
  [[maybe_unused]] const ssize_t written = ::write(pipe_ends[1], &byte, 1);
  errno = error;
}

void handle(Signal& signal) {
  ::sigaction(signal.number, nullptr, &signal.former);
  signal.is_handled = signal.former.sa_handler != SIG_IGN;  // as nohup wants it
  if (!signal.is_handled) return;
  struct sigaction action {};
  action.sa_handler = pass_on;
  action.sa_flags = SA_RESTART;
  ::sigemptyset(&action.sa_mask);
  ::sigaction(signal.number, &action, nullptr);
}

}  // namespace

SessionEnd::SessionEnd(QObject* parent) : QObject(parent) {
  qGuiApp->installEventFilter(this);
  connect(qGuiApp, &QGuiApplication::commitDataRequest, this, &SessionEnd::announced,
          Qt::DirectConnection);
  if (::pipe2(pipe_ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
  auto* notifier = new QSocketNotifier(pipe_ends[0], QSocketNotifier::Read, this);
  connect(notifier, &QSocketNotifier::activated, this, &SessionEnd::read_signal);
  std::ranges::for_each(signals, handle);
}

SessionEnd::~SessionEnd() {
  for (Signal& signal : signals) {
    if (signal.is_handled) ::sigaction(signal.number, &signal.former, nullptr);
    signal.is_handled = false;
  }
  for (const int end : pipe_ends) {
    if (end >= 0) ::close(end);
  }
}

void SessionEnd::read_signal() {
  unsigned char number = 0;
  if (::read(pipe_ends[0], &number, 1) != 1) return;
  Q_EMIT announced();
  Q_EMIT ended(number);
}

// The desktop quits the program when its session has ended: too late for a question. Qt does after
// the last window has been closed.
bool SessionEnd::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Quit || watched != qGuiApp ||
      std::ranges::none_of(QGuiApplication::topLevelWindows(), &QWindow::isVisible)) {
    return QObject::eventFilter(watched, event);
  }
  Q_EMIT announced();
  Q_EMIT ended(0);
  return true;
}

}  // namespace brume
