#include "app/export/queue_list.h"

#include <QDesktopServices>
#include <QGridLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

#include "app/document/number_text.h"
#include "app/document/paths.h"
#include "app/export/render_queue.h"
#include "app/widgets/plain_text.h"
#include "app/widgets/question.h"
#include "app/widgets/rows.h"

namespace brume {
namespace {

using State = RenderQueue::State;

constexpr int id_role = Qt::UserRole;
constexpr int state_column = 1;

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

QString tool_tip(const RenderQueue::Item& item) {
  QString text = row_title(item);
  if (!item.request.file.empty()) text += '\n' + to_qstring(item.request.file);
  if (item.rendered > 0) {
    text += QueueList::tr("\n%1 per frame").arg(duration_text(item.milliseconds / item.rendered));
  }
  if (!item.message.isEmpty()) text += '\n' + item.message;
  return plain_tool_tip(text);
}

}  // namespace

QueueList::QueueList(RenderQueue& queue, QWidget* parent)
    : QWidget(parent), queue_(queue), list_(named(new QTreeWidget(this), "render_queue")) {
  list_->setColumnCount(2);
  list_->setHeaderLabels({tr("Render queue"), QString()});
  list_->setRootIsDecorated(false);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->setMinimumHeight(96);
  list_->setToolTip(
      tr("Renders go on while you edit, each of the scene as it was when it was added"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 0, 6, 6);
  layout->addWidget(list_, 0, 0, 1, 7);
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
  int column = 0;
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto react) {
    auto* button = named(new QPushButton(text, this), name, tip);
    button->setMinimumWidth(20);
    connect(button, &QPushButton::clicked, this, react);
    layout->addWidget(button, 1, column++);
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
  connect(&queue_, &RenderQueue::changed, this, &QueueList::rebuild);
  connect(&queue_, &RenderQueue::progressed, this, &QueueList::show_progress);
  connect(list_, &QTreeWidget::currentItemChanged, this, &QueueList::update_buttons);
  connect(list_, &QTreeWidget::itemDoubleClicked, this,
          [this] { Q_EMIT show_asked_for(current()); });
  rebuild();
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
    auto* row = new QTreeWidgetItem({row_title(item), QString()});
    row->setData(0, id_role, item.id);
    row->setToolTip(0, tool_tip(item));
    list_->addTopLevelItem(row);
    auto* bar = new QProgressBar(list_);
    bar->setValue(item.percent);
    bar->setFormat(state_text(queue_, item));
    bar->setToolTip(tool_tip(item));
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
  const RenderQueue::Item* item = queue_.find(id);
  for (int k = 0; item && k < list_->topLevelItemCount(); ++k) {
    QTreeWidgetItem* row = list_->topLevelItem(k);
    if (row->data(0, id_role).toInt() != id) continue;
    auto* bar = qobject_cast<QProgressBar*>(list_->itemWidget(row, state_column));
    bar->setValue(percent);
    bar->setFormat(state_text(queue_, *item));
    row->setToolTip(0, tool_tip(*item));
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
  remove_->setEnabled(item);
}

void QueueList::open_folder() {
  const RenderQueue::Item* item = queue_.find(current());
  if (!item || item->request.file.empty()) return;
  QDesktopServices::openUrl(QUrl::fromLocalFile(to_qstring(item->request.file.parent_path())));
}

bool may_stop(const RenderQueue& queue, QWidget* window) {
  const int unfinished = queue.unfinished();
  if (unfinished == 0) return true;
  const QString text =
      unfinished == 1
          ? QueueList::tr(
                "A render is not finished. Stop it? At the next start it is in the queue.")
          : QueueList::tr(
                "%1 renders are not finished. Stop them? At the next start they are in the "
                "queue.")
                .arg(unfinished);
  return ask(window, QueueList::tr("Unfinished renders"), text,
             {{QMessageBox::Cancel, QueueList::tr("Keep Rendering")},
              {QMessageBox::Yes, QueueList::tr("Stop")}}) == QMessageBox::Yes;
}

}  // namespace brume
