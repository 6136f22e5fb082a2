#include "app/export/render_queue.h"

#include <QThread>
#include <algorithm>

namespace brume {
namespace {

// Threads of a render: views get the others while one edits.
int render_threads() {
  const int all = std::max(1, QThread::idealThreadCount());
  return std::max(1, all - std::max(1, all / 4));
}

}  // namespace

RenderQueue::RenderQueue(QObject* parent) : QObject(parent), export_(this) {
  connect(&export_, &FrameExport::finished, this, [this] { end(State::done); });
  connect(&export_, &FrameExport::cancelled, this, [this] { end(State::cancelled); });
  connect(&export_, &FrameExport::failed, this,
          [this](const QString& why) { end(State::failed, why); });
  connect(&export_, &FrameExport::rendered, this,
          [this](const ExportedFrame& frame) { Q_EMIT rendered(running_, frame); });
  connect(&export_.job(), &BackgroundJob::progressed, this, [this](int percent) {
    Item* running = item(running_);
    if (!running) return;
    running->percent = percent;
    Q_EMIT progressed(running_, percent);
  });
}

RenderQueue::Item* RenderQueue::item(int id) {
  const auto found = std::ranges::find(items_, id, &Item::id);
  return found == items_.end() ? nullptr : &*found;
}

const RenderQueue::Item* RenderQueue::find(int id) const {
  const auto found = std::ranges::find(items_, id, &Item::id);
  return found == items_.end() ? nullptr : &*found;
}

int RenderQueue::unfinished() const {
  return static_cast<int>(std::ranges::count_if(items_, [](const Item& it) {
    return it.state == State::waiting || it.state == State::rendering;
  }));
}

int RenderQueue::add(FrameExportRequest request) {
  request.request.threads = render_threads();
  items_.push_back({++last_id_, std::move(request), State::waiting, 0, {}});
  start_next();
  Q_EMIT changed();
  return last_id_;
}

void RenderQueue::cancel(int id) {
  Item* known = item(id);
  if (!known) return;
  if (id == running_) {
    export_.job().cancel();
  } else if (known->state == State::waiting) {
    known->state = State::cancelled;
    Q_EMIT changed();
  }
}

void RenderQueue::remove(int id) {
  if (id == running_) {
    removes_running_ = true;
    export_.job().cancel();
    return;
  }
  std::erase_if(items_, [id](const Item& it) { return it.id == id; });
  Q_EMIT changed();
}

void RenderQueue::repeat(int id) {
  Item* known = item(id);
  if (!known || (known->state != State::failed && known->state != State::cancelled)) return;
  known->state = State::waiting;
  known->percent = 0;
  known->message.clear();
  start_next();
  Q_EMIT changed();
}

void RenderQueue::start_next() {
  if (running_ != 0 || export_.job().is_running()) return;
  const auto next = std::ranges::find(items_, State::waiting, &Item::state);
  if (next == items_.end()) return;
  next->state = State::rendering;
  running_ = next->id;
  removes_running_ = false;
  export_.start(next->request);
}

void RenderQueue::end(State state, const QString& message) {
  if (Item* ended = item(running_)) {
    ended->state = state;
    ended->message = message;
    if (state == State::done) ended->percent = 100;
  }
  const int id = std::exchange(running_, 0);
  if (std::exchange(removes_running_, false)) {
    std::erase_if(items_, [id](const Item& it) { return it.id == id; });
  }
  // Once the job has told all of its end.
  QMetaObject::invokeMethod(
      this,
      [this] {
        start_next();
        Q_EMIT changed();
      },
      Qt::QueuedConnection);
  Q_EMIT changed();
}

}  // namespace brume
