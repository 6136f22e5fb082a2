#include "app/export/queue_list.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QGridLayout>
#include <QHeaderView>
#include <QMenu>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <utility>

#include "app/document/paths.h"
#include "app/document/text/number_text.h"
#include "app/export/render_queue.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/question.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

using State = RenderQueue::State;

constexpr int id_role = Qt::UserRole;
constexpr int priority_column = 1;
constexpr int state_column = 2;
constexpr int columns = 7;  // of buttons
constexpr const char* render_mime = "application/x-brume-render";

QString priority_text(int priority) {
  return priority > 0   ? QueueList::tr("high")
         : priority < 0 ? QueueList::tr("low")
                        : QueueList::tr("normal");
}

// Rows that are dragged to other places.
class QueueRows : public QTreeWidget {
 public:
  using Moved = std::function<void(int id, int row)>;  // before this row
  QueueRows(QWidget* parent, Moved moved) : QTreeWidget(parent), moved_(std::move(moved)) {
    setDragDropMode(DragDrop);
  }

 protected:
  [[nodiscard]] QStringList mimeTypes() const override { return {render_mime}; }
  [[nodiscard]] QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
    if (items.isEmpty()) return nullptr;
    auto* row = new QMimeData;
    row->setData(render_mime, QByteArray::number(items.front()->data(0, id_role).toInt()));
    return row;
  }
  // Later: it makes the rows anew, and the drop is not over yet.
  bool dropMimeData(QTreeWidgetItem* /*onto*/, int row, const QMimeData* dropped,
                    Qt::DropAction /*action*/) override {
    const int id = dropped->data(render_mime).toInt();
    QTimer::singleShot(0, this, [this, id, row] { moved_(id, row); });
    return true;
  }
  [[nodiscard]] Qt::DropActions supportedDropActions() const override { return Qt::CopyAction; }

 private:
  Moved moved_;
};

// Tells what a render has done and has to do yet.
QString details_text(const RenderQueue& queue, const RenderQueue::Item& item) {
  QStringList parts;
  if (const auto& range = item.request.range) {
    const std::set<int>& complete = item.request.complete;  // none of a video
    parts << QueueList::tr("%1 of %2 frames")
                 .arg(complete.empty() ? item.rendered : static_cast<int>(complete.size()))
                 .arg(range->last - range->first + 1);
  }
  if (item.rendered > 0) {
    parts << QueueList::tr("%1 per frame").arg(duration_text(item.milliseconds / item.rendered));
  }
  const bool is_unfinished = item.state == State::waiting || item.state == State::rendering;
  if (const auto seconds = queue.seconds_left(item); seconds && is_unfinished) {
    parts << QueueList::tr("%1 left").arg(estimated_time_text(*seconds));
  }
  if (!item.failed.empty()) {
    QStringList frames;
    for (const auto& [frame, why] : item.failed) frames << QString::number(frame);
    if (frames.size() > 8) frames = frames.mid(0, 8) << QStringLiteral("…");
    parts << QueueList::tr("failed: %1").arg(frames.join(", "));
  }
  if (!item.message.isEmpty()) parts << item.message;
  return parts.join(" · ");
}

QString state_text(const RenderQueue& queue, const RenderQueue::Item& item) {
  switch (item.state) {
    case State::waiting:
      return QueueList::tr("waiting");
    case State::rendering:
      if (const auto seconds = queue.seconds_left(item); seconds && item.request.range) {
        return QueueList::tr("%1 %, %2 left").arg(item.percent).arg(estimated_time_text(*seconds));
      }
      return QString("%1 %").arg(item.percent);
    case State::done:
      return QueueList::tr("done");
    case State::cancelled:
      return QueueList::tr("cancelled");
    case State::failed:
      return QueueList::tr("failed");
    case State::stopped:
      return QueueList::tr("stopped");
  }
  return {};
}

QString row_title(const RenderQueue::Item& item) {
  const FrameExportRequest& request = item.request;
  QString text = request.title;
  if (request.range) {
    text += QueueList::tr(", frames %1 to %2").arg(request.range->first).arg(request.range->last);
  }
  if (!request.file.empty()) text += " · " + to_qstring(request.file.filename());
  return text;
}

QString tool_tip(const RenderQueue& queue, const RenderQueue::Item& item) {
  QStringList lines{row_title(item)};
  if (!item.request.file.empty()) lines << to_qstring(item.request.file);
  if (const QString details = details_text(queue, item); !details.isEmpty()) lines << details;
  return plain_tool_tip(lines.join('\n'));
}

}  // namespace

QueueList::QueueList(RenderQueue& queue, QWidget* parent)
    : QWidget(parent),
      queue_(queue),
      list_(named(new QueueRows(this, [this](int id, int row) { move_to_row(id, row); }),
                  "render_queue")) {
  list_->setColumnCount(3);
  list_->setHeaderLabels({tr("Render queue"), tr("Priority"), QString()});
  list_->setRootIsDecorated(false);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(priority_column, QHeaderView::ResizeToContents);
  list_->setMinimumHeight(60);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setToolTip(
      tr("Renders go on while you edit, each of the scene as it was when it was added. "
         "Drag those that wait to where they are to be rendered"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 0, 6, 6);
  layout->addWidget(list_, 0, 0, 1, columns);
  empty_ =
      new PlainLabel(tr("Nothing to render. F12 renders what the scene's camera sees, Ctrl+F12 "
                        "the animation; both go on while you edit."),
                     list_);
  empty_->setObjectName("queue_empty");
  empty_->setWordWrap(true);
  empty_->setAlignment(Qt::AlignCenter);
  auto* above = new QVBoxLayout(list_);
  above->setContentsMargins(12, 28, 12, 4);
  above->addWidget(empty_);
  add_details(*layout);
  add_buttons(*layout);
  connect(&queue_, &RenderQueue::changed, this, &QueueList::rebuild);
  connect(&queue_, &RenderQueue::progressed, this, &QueueList::show_progress);
  connect(list_, &QTreeWidget::currentItemChanged, this, &QueueList::update_buttons);
  connect(list_, &QTreeWidget::itemDoubleClicked, this,
          [this] { Q_EMIT show_asked_for(current()); });
  connect(list_, &QTreeWidget::customContextMenuRequested, this, &QueueList::show_menu);
  rebuild();
}

void QueueList::add_details(QGridLayout& layout) {
  details_ = named(new PlainLabel(this), "queue_details");
  details_->setWordWrap(true);
  layout.addWidget(details_, 1, 0, 1, columns - 2);
  priority_ = named(new QComboBox(this), "queue_priority",
                    tr("Of those that wait, the first with the highest priority is rendered next"));
  for (const int priority : {1, 0, -1}) priority_->addItem(priority_text(priority), priority);
  layout.addWidget(priority_, 1, columns - 2, 1, 2, Qt::AlignTop);
  connect(priority_, &QComboBox::activated, this,
          [this] { queue_.set_priority(current(), priority_->currentData().toInt()); });
}

void QueueList::add_buttons(QGridLayout& layout) {
  int column = 0;
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto react) {
    auto* button = named(new QPushButton(text, this), name, tip);
    button->setMinimumWidth(20);
    connect(button, &QPushButton::clicked, this, react);
    layout.addWidget(button, 2, column++);
    return button;
  };
  show_ = add(tr("Show"), "queue_show", tr("Shows its last picture in the picture viewer"),
              [this] { Q_EMIT show_asked_for(current()); });
  folder_ = add(tr("Folder"), "queue_folder", tr("Opens the folder of its files"),
                [this] { open_folder(); });
  cancel_ = add(tr("Cancel"), "queue_cancel", tr("Ends it; complete pictures stay"),
                [this] { queue_.cancel(current()); });
  resume_ = add(tr("Resume"), "queue_resume",
                tr("Renders, of the same scene, what failed or was not rendered yet"),
                [this] { queue_.resume(current()); });
  remove_ = add(tr("Remove"), "queue_remove", tr("Takes it off the list; its files stay"),
                [this] { queue_.remove(current()); });
  sooner_ = add("↑", "queue_sooner", tr("Renders it before the one above"),
                [this] { queue_.move(current(), true); });
  later_ = add("↓", "queue_later", tr("Renders it after the one below"),
               [this] { queue_.move(current(), false); });
}

void QueueList::show_menu(const QPoint& position) {
  QTreeWidgetItem* row = list_->itemAt(position);
  if (!row) return;
  list_->setCurrentItem(row);
  const RenderQueue::Item* item = queue_.find(current());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (QPushButton* button : {show_, folder_, cancel_, resume_, remove_}) {
    menu->addAction(button->text(), button, &QPushButton::click)->setEnabled(button->isEnabled());
  }
  QMenu* priorities = menu->addMenu(tr("Priority"));
  for (const int priority : {1, 0, -1}) {
    QAction* action = priorities->addAction(
        priority_text(priority), this,
        [this, id = item->id, priority] { queue_.set_priority(id, priority); });
    action->setCheckable(true);
    action->setChecked(item->request.priority == priority);
  }
  menu->popup(list_->viewport()->mapToGlobal(position));
}

void QueueList::move_to_row(int id, int row) {
  const QTreeWidgetItem* next = list_->topLevelItem(row);
  queue_.move_before(id, next ? next->data(0, id_role).toInt() : 0);
}

int QueueList::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? item->data(0, id_role).toInt() : 0;
}

void QueueList::rebuild() {
  const int chosen = current();
  const QSignalBlocker blocker(list_);
  list_->clear();
  for (const RenderQueue::Item& item : queue_.items()) {
    const int priority = item.request.priority;
    auto* row = new QTreeWidgetItem({row_title(item)});
    row->setText(priority_column, priority == 0 ? QString() : priority_text(priority));
    row->setData(0, id_role, item.id);
    row->setToolTip(0, tool_tip(queue_, item));
    row->setFlags(row->flags()
                      .setFlag(Qt::ItemIsDragEnabled, item.state == State::waiting)
                      .setFlag(Qt::ItemIsDropEnabled, false));
    list_->addTopLevelItem(row);
    auto* bar = new QProgressBar(list_);
    bar->setValue(item.percent);
    bar->setFormat(state_text(queue_, item));
    bar->setToolTip(tool_tip(queue_, item));
    bar->setFixedWidth(130);
    list_->setItemWidget(row, state_column, bar);
    if (item.id == chosen || chosen == 0) list_->setCurrentItem(row);
  }
  if (!list_->currentItem() && list_->topLevelItemCount() > 0) {
    list_->setCurrentItem(list_->topLevelItem(list_->topLevelItemCount() - 1));
  }
  list_->resizeColumnToContents(state_column);
  empty_->setVisible(queue_.items().empty());
  show_time_left();
  update_buttons();
}

void QueueList::show_time_left() {
  const auto seconds = queue_.seconds_left();
  list_->headerItem()->setText(
      0, seconds ? tr("Render queue, %1 left").arg(estimated_time_text(*seconds))
                 : tr("Render queue"));
}

void QueueList::show_progress(int id, int percent) {
  show_time_left();
  show_details();
  const RenderQueue::Item* item = queue_.find(id);
  for (int k = 0; item && k < list_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* row = list_->topLevelItem(k);
    if (row->data(0, id_role).toInt() != id) continue;
    auto* bar = qobject_cast<QProgressBar*>(list_->itemWidget(row, state_column));
    bar->setValue(percent);
    bar->setFormat(state_text(queue_, *item));
    row->setToolTip(0, tool_tip(queue_, *item));
  }
}

void QueueList::update_buttons() {
  const RenderQueue::Item* item = queue_.find(current());
  const auto is = [item](State state) { return item && item->state == state; };
  show_->setEnabled(is(State::done) || is(State::rendering) || is(State::cancelled));
  folder_->setEnabled(item && !item->request.file.empty());
  cancel_->setEnabled(is(State::waiting) || is(State::rendering));
  for (QPushButton* button : {sooner_, later_}) button->setEnabled(is(State::waiting));
  resume_->setEnabled(item && item->can_resume());
  resume_->setText(is(State::failed) ? tr("Retry") : tr("Resume"));
  remove_->setEnabled(item);
  priority_->setEnabled(item);
  priority_->setCurrentIndex(priority_->findData(item ? item->request.priority : 0));
  show_details();
}

void QueueList::show_details() {
  const RenderQueue::Item* item = queue_.find(current());
  details_->setText(item ? details_text(queue_, *item) : QString());
}

void QueueList::open_folder() {
  const RenderQueue::Item* item = queue_.find(current());
  if (!item || item->request.file.empty()) return;
  QDesktopServices::openUrl(QUrl::fromLocalFile(to_qstring(item->request.file.parent_path())));
}

bool may_stop(const RenderQueue& queue, QWidget* window) {
  const int unfinished = queue.unfinished();
  if (unfinished == 0) return true;
  const QString text = QueueList::tr(
      "%n render(s) are not finished. Stop them? At the next start they are in the "
      "queue.",
      nullptr, unfinished);
  return ask(window, QueueList::tr("Unfinished Renders"), text,
             {{QMessageBox::Cancel, QueueList::tr("Keep Rendering")},
              {QMessageBox::Yes, QueueList::tr("Stop")}}) == QMessageBox::Yes;
}

}  // namespace brume
