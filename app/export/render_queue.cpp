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
  connect(&export_, &FrameExport::rendered, this, [this](const ExportedFrame& frame) {
    if (Item* running = item(running_)) {
      running->milliseconds += frame.milliseconds;
      ++running->rendered;
    }
    Q_EMIT rendered(running_, frame);
  });
  connect(&export_, &FrameExport::written, this, [this](int frame) {
    if (Item* running = item(running_)) running->request.complete.insert(frame);
  });
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
  items_.push_back({++last_id_, std::move(request), State::waiting, 0, {}, 0.0, 0});
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

void RenderQueue::resume(int id) {
  Item* known = item(id);
  if (!known || (known->state != State::failed && known->state != State::cancelled)) return;
  known->state = State::waiting;
  known->percent = 0;
  known->message.clear();
  known->milliseconds = 0.0;
  known->rendered = 0;
  start_next();
  Q_EMIT changed();
}

RenderQueue::Item* RenderQueue::waiting_beside(int id, bool sooner) {
  Item* beside = nullptr;
  bool is_past = false;
  for (Item& other : items_) {
    const bool is_this = other.id == id;
    if (is_this && sooner) return beside;
    if (other.state == State::waiting && !is_this) {
      if (is_past) return &other;
      if (sooner) beside = &other;
    }
    is_past = is_past || is_this;
  }
  return nullptr;
}

void RenderQueue::move(int id, bool sooner) {
  Item* moved = item(id);
  if (!moved || moved->state != State::waiting) return;
  Item* other = waiting_beside(id, sooner);
  if (!other) return;
  std::swap(*moved, *other);
  Q_EMIT changed();
}

std::optional<double> RenderQueue::seconds_left(const Item& item) const {
  const Item* timed = item.rendered > 0 ? &item : find(running_);
  if (!timed || timed->rendered == 0) return std::nullopt;
  const auto& range = item.request.range;
  const int frames = range ? range->last - range->first + 1 : 1;
  // Of videos and pictures without a file only those of this run are known.
  const auto complete = static_cast<int>(item.request.complete.size());
  const int left = std::max(0, frames - std::max(complete, item.rendered));
  return 1e-3 * timed->milliseconds / timed->rendered * left;
}

std::optional<double> RenderQueue::seconds_left() const {
  std::optional<double> sum;
  for (const Item& item : items_) {
    if (item.state != State::waiting && item.state != State::rendering) continue;
    if (const auto seconds = seconds_left(item)) sum = sum.value_or(0.0) + *seconds;
  }
  return sum;
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
