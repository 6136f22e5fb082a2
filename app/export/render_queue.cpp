#include "app/export/render_queue.h"

#include <QDateTime>
#include <QThread>
#include <algorithm>
#include <utility>

#include "app/document/paths.h"
#include "app/files/numbered_file.h"
#include "core/io/disk/file_bytes.h"

namespace brume {
namespace {

// Threads of a render: views get the others while one edits.
int render_threads() {
  const int all = std::max(1, QThread::idealThreadCount());
  return std::max(1, all - std::max(1, all / 4));
}

bool is_numbered(const FrameExportRequest& request) {
  return request.range && lower_case_extension(request.file) != ".mp4";
}

bool writes(const FrameExportRequest& request, const std::filesystem::path& file) {
  if (!is_numbered(request)) return request.file == file;
  if (request.file.parent_path() != file.parent_path()) return false;
  const std::optional<int> frame = frame_number(request.file, file);
  return frame && request.range->first <= *frame && *frame <= request.range->last;
}

bool write_same_file(const FrameExportRequest& a, const FrameExportRequest& b) {
  if (a.file.empty() || b.file.empty()) return false;
  if (!is_numbered(a)) return writes(b, a.file);
  if (!is_numbered(b)) return writes(a, b.file);
  return a.file == b.file && a.range->first <= b.range->last && b.range->first <= a.range->last;
}

bool is_unfinished(const RenderQueue::Item& item) {
  return item.state == RenderQueue::State::waiting || item.state == RenderQueue::State::rendering;
}

// Files that are damaged stay as they are.
bool has_record(const RenderQueue::Item& item) {
  return is_unfinished(item) || (item.can_resume() && item.state != RenderQueue::State::cancelled);
}

}  // namespace

bool RenderQueue::Item::can_resume() const {
  const bool has_ended =
      state == State::failed || state == State::cancelled || state == State::stopped;
  return has_ended && (request.scene || !request.kept_scene.empty());
}

RenderQueue::RenderQueue(const std::filesystem::path& folder, QObject* parent)
    : QObject(parent), kept_(folder), export_(this) {
  take_left();
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
    if (Item* running = item(running_)) {
      running->request.complete.insert(frame);
      update(*running);
    }
  });
  connect(&export_, &FrameExport::frame_failed, this, [this](int frame, const QString& why) {
    if (Item* running = item(running_)) running->failed[frame] = why;
  });
  connect(&export_.job(), &BackgroundJob::progressed, this, [this](int percent) {
    Item* running = item(running_);
    if (!running) return;
    running->percent = percent;
    Q_EMIT progressed(running_, percent);
  });
}

void RenderQueue::take_left() {
  for (KeptRenders::Left& left : kept_.take()) {
    Item item{.id = ++last_id_,
              .request = std::move(left.render.request),
              .state = left.problem.isEmpty() ? State::stopped : State::failed,
              .message = left.problem,
              .kept = left.name,
              .place = left.render.place};
    item.request.request.threads = render_threads();
    if (!left.problem.isEmpty()) item.request.title = tr("Render of an earlier session");
    items_.push_back(std::move(item));
  }
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
  return static_cast<int>(std::ranges::count_if(items_, is_unfinished));
}

int RenderQueue::stopped() const {
  return static_cast<int>(std::ranges::count(items_, State::stopped, &Item::state));
}

bool RenderQueue::may_write(const FrameExportRequest& request) {
  const auto other = std::ranges::find_if(items_, [&request](const Item& it) {
    return is_unfinished(it) && write_same_file(it.request, request);
  });
  if (other == items_.end()) return true;
  Q_EMIT refused(tr("“%1” in the queue has yet to write %2. Name another file, or cancel that one.")
                     .arg(other->request.title, to_qstring(request.file.filename())));
  return false;
}

int RenderQueue::add(FrameExportRequest request) {
  if (!may_write(request)) return 0;
  request.request.threads = render_threads();
  double place = static_cast<double>(QDateTime::currentMSecsSinceEpoch());
  for (const Item& other : items_) place = std::max(place, other.place + 1.0);
  const QString kept = kept_.keep(request, place);
  items_.push_back({.id = ++last_id_, .request = std::move(request), .kept = kept, .place = place});
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
    kept_.drop_record(known->kept);
    Q_EMIT changed();
  }
}

void RenderQueue::remove(int id) {
  if (id == running_) {
    removes_running_ = true;
    export_.job().cancel();
    return;
  }
  erase(id);
  Q_EMIT changed();
}

void RenderQueue::erase(int id) {
  if (const Item* known = item(id)) kept_.remove(known->kept);
  std::erase_if(items_, [id](const Item& it) { return it.id == id; });
}

void RenderQueue::resume(int id) {
  Item* known = item(id);
  if (!known || !known->can_resume() || !may_write(known->request)) return;
  known->state = State::waiting;
  known->percent = 0;
  known->message.clear();
  known->milliseconds = 0.0;
  known->rendered = 0;
  known->failed.clear();
  update(*known);
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
  if (other) sooner ? move_before(id, other->id) : move_before(other->id, id);
}

void RenderQueue::move_before(int id, int other) {
  const auto moved = std::ranges::find(items_, id, &Item::id);
  const auto next = std::ranges::find(items_, other, &Item::id);
  if (moved == items_.end() || moved->state != State::waiting || id == other) return;
  std::vector<double> places;
  for (const Item& it : items_) places.push_back(it.place);
  if (next < moved) {
    std::rotate(next, moved, moved + 1);
  } else {
    std::rotate(moved, moved + 1, next);
  }
  for (std::size_t k = 0; k < items_.size(); ++k) {
    Item& it = items_[k];
    if (std::exchange(it.place, places[k]) == places[k]) continue;
    if (has_record(it)) update(it);
  }
  Q_EMIT changed();
}

void RenderQueue::set_priority(int id, int priority) {
  Item* known = item(id);
  if (!known || known->request.priority == priority) return;
  known->request.priority = priority;
  if (has_record(*known)) update(*known);
  Q_EMIT changed();
}

std::optional<double> RenderQueue::seconds_left(const Item& item) const {
  const Item* timed = item.rendered > 0 ? &item : find(running_);
  if (!timed || timed->rendered == 0) return std::nullopt;
  const auto& range = item.request.range;
  const int frames = range ? range->last - range->first + 1 : 1;
  // Videos and pictures without a file begin anew: only frames of this run count.
  const auto complete = static_cast<int>(item.request.complete.size());
  const int left = std::max(0, frames - std::max(complete, item.rendered));
  return 1e-3 * timed->milliseconds / timed->rendered * left;
}

std::optional<double> RenderQueue::seconds_left() const {
  std::optional<double> sum;
  for (const Item& item : items_) {
    if (!is_unfinished(item)) continue;
    if (const auto seconds = seconds_left(item)) sum = sum.value_or(0.0) + *seconds;
  }
  return sum;
}

void RenderQueue::start_next() {
  if (running_ != 0 || export_.job().is_running()) return;
  Item* next = nullptr;
  for (Item& it : items_) {
    const bool is_first = !next || it.request.priority > next->request.priority;
    if (it.state == State::waiting && is_first) next = &it;
  }
  if (!next) return;
  next->state = State::rendering;
  running_ = next->id;
  removes_running_ = false;
  export_.start(next->request);
}

void RenderQueue::end(State state, const QString& message) {
  if (Item* ended = item(running_)) {
    ended->state = state;
    ended->message = message;
    if (state == State::done) {
      ended->percent = 100;
      kept_.remove(ended->kept);
    } else if (state == State::cancelled) {
      kept_.drop_record(ended->kept);
    }
  }
  const int id = std::exchange(running_, 0);
  if (std::exchange(removes_running_, false)) {
    erase(id);
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
