// The list of the render queue: order, priorities, failed frames.

#include <QComboBox>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <memory>

#include "app/document/paths.h"
#include "core/io/disk/file_bytes.h"
#include "tests/app/listed_queue.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;
using QueueState = RenderQueue::State;

// Drags the current row to a place in the list, with the events of Qt.
void drop_row(QTreeWidget& tree, QPoint place) {
  const std::unique_ptr<QMimeData> data(tree.model()->mimeData({tree.currentIndex()}));
  if (!(tree.currentItem()->flags() & Qt::ItemIsDragEnabled)) return;
  drop_at(*tree.viewport(), place, *data);
  QCoreApplication::processEvents();
}

}  // namespace

class RenderQueueTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void no_two_renders_that_are_to_be_done_write_the_same_file() {
    const TemporaryFolder folder;
    ListedQueue listed(folder / "renders");
    RenderQueue& queue = listed.queue;
    QSignalSpy refused(&queue, &RenderQueue::refused);
    queue.add(endless_request());
    FrameExportRequest frames = tiny_request(folder / "f.png");
    frames.title = "Camera";
    frames.range = {1, 9, 30.0};
    QVERIFY(queue.add(frames) != 0);
    FrameExportRequest later = frames;
    later.range = {9, 12, 30.0};
    QCOMPARE(queue.add(later), 0);
    QCOMPARE(refused.size(), 1);
    QVERIFY2(refused[0][0].toString().contains("“Camera” in the queue has yet to write f.png"),
             qPrintable(refused[0][0].toString()));
    QCOMPARE(queue.add(tiny_request(folder / "f_0009.png")), 0);
    later.range = {10, 12, 30.0};
    QVERIFY(queue.add(later) != 0);
    QVERIFY(queue.add(tiny_request(folder / "f.png")) != 0);
    QVERIFY(queue.add(tiny_request()) != 0 && queue.add(tiny_request()) != 0);  // no files
    // Nor does one that is asked for again.
    listed.click(1, "queue_cancel");
    later.range = {9, 9, 30.0};
    QVERIFY(queue.add(later) != 0);
    click(listed.list, "queue_resume");
    QCOMPARE(queue.items()[1].state, QueueState::cancelled);
    QCOMPARE(refused.size(), 3);
    QCOMPARE(queue.items().size(), 7u);
  }

  void rows_are_dragged_to_other_places_and_priorities_come_first() {
    const TemporaryFolder folder;
    const auto titles = [](const RenderQueue& queue) {
      QStringList all;
      for (const RenderQueue::Item& item : queue.items()) all << item.request.title;
      return all.join(' ');
    };
    {
      ListedQueue listed(folder / "renders");
      for (const char* title : {"a", "b", "c", "d"}) {
        FrameExportRequest request = title[0] == 'a' ? endless_request() : tiny_request();
        request.title = title;
        listed.queue.add(request);
      }
      QTRY_COMPARE(files_in(folder / "renders", ".json").size(), 4u);
      const auto drag = [&](int row, int onto, int below) {
        listed.choose(row);
        const QRect place = listed.tree()->visualItemRect(listed.tree()->topLevelItem(onto));
        drop_row(*listed.tree(), QPoint(place.center().x(), place.center().y() + below));
      };
      const auto height = [&] {
        return listed.tree()->visualItemRect(listed.tree()->topLevelItem(0)).height();
      };
      drag(3, 1, 1 - height() / 2);
      QCOMPARE(titles(listed.queue), "a d b c");
      drag(1, 3, height() / 2 - 1);
      QCOMPARE(titles(listed.queue), "a b c d");
      drag(2, 1, 1 - height() / 2);
      QCOMPARE(titles(listed.queue), "a c b d");
      // The render that is going on stays where it is.
      drag(0, 3, height() / 2 - 1);
      QCOMPARE(titles(listed.queue), "a c b d");
      listed.choose(3);
      brume::choose(listed.list, "queue_priority", 0);
      QCOMPARE(listed.tree()->topLevelItem(3)->text(1), "high");
      listed.choose(1);
      QVERIFY(choose_from_menu(*listed.tree()->viewport(),
                               cell_position(*listed.tree(), listed.tree()->topLevelItem(1), 0),
                               "Priority/low"));
    }
    RenderQueue next(folder / "renders");
    QCOMPARE(titles(next), "a c b d");
    QCOMPARE(next.items()[1].request.priority, -1);
    QCOMPARE(next.items()[3].request.priority, 1);
    QStringList rendered;
    connect(&next, &RenderQueue::changed, this, [&] {
      for (const RenderQueue::Item& item : next.items()) {
        const QString& title = item.request.title;
        if (item.state == QueueState::rendering && !rendered.contains(title)) rendered << title;
      }
    });
    for (const RenderQueue::Item& item : std::vector(next.items())) next.resume(item.id);
    next.cancel(next.items()[0].id);
    QTRY_COMPARE(rendered.join(' '), "a d b c");
  }

  void waiting_renders_change_places() {
    const TemporaryFolder folder;
    ListedQueue listed(folder / "renders");
    const int first = listed.queue.add(endless_request());
    const int second = listed.queue.add(tiny_request());
    const int third = listed.queue.add(tiny_request());
    const auto order = [&] {
      std::vector<int> ids;
      for (const RenderQueue::Item& item : listed.queue.items()) ids.push_back(item.id);
      return ids;
    };
    listed.click(2, "queue_sooner");
    QCOMPARE(order(), (std::vector{first, third, second}));
    click(listed.list, "queue_sooner");  // the one above is rendered
    QCOMPARE(order(), (std::vector{first, third, second}));
    click(listed.list, "queue_later");
    QCOMPARE(order(), (std::vector{first, second, third}));
  }

  void waiting_renders_can_be_cancelled_repeated_and_removed() {
    const TemporaryFolder folder;
    ListedQueue listed(folder / "renders");
    const RenderQueue& queue = listed.queue;
    const int first = listed.queue.add(endless_request());
    const int second = listed.queue.add(tiny_request(folder / "next.png"));
    const int third = listed.queue.add(tiny_request(folder / "none/last.png"));
    QCOMPARE(queue.find(first)->state, QueueState::rendering);
    QCOMPARE(queue.find(second)->state, QueueState::waiting);
    QCOMPARE(listed.tree()->topLevelItemCount(), 3);
    listed.click(1, "queue_cancel");
    QCOMPARE(queue.find(second)->state, QueueState::cancelled);
    listed.click(0, "queue_remove");
    QTRY_VERIFY(!queue.find(first));
    // The others go on; what fails says why, and stays.
    QVERIFY(listed.wait_for(1, QueueState::failed));
    QVERIFY2(queue.find(third)->message.contains("last.png"),
             qPrintable(queue.find(third)->message));
    QVERIFY(!fs::exists(folder / "next.png"));
    listed.click(0, "queue_resume");
    QVERIFY(listed.wait_for(0, QueueState::done));
    QCOMPARE(QImage(to_qstring(folder / "next.png")).size(), QSize(32, 24));
    QCOMPARE(listed.tree()->topLevelItemCount(), 2);
  }

  // A full disk would cost all frames.
  void a_resumed_sequence_ends_where_its_first_frame_fails() {
    const TemporaryFolder folder;
    ListedQueue listed(folder / "renders");
    FrameExportRequest request = tiny_request(folder / "f.png");
    request.range = {1, 4, 30.0};
    request.complete = {1};
    write_text(folder / "f_0001.png", "there");
    fs::create_directory(folder / "f_0002.png");  // which cannot be replaced by a file
    listed.queue.add(request);
    QVERIFY(listed.wait_for(0, QueueState::failed));
    QCOMPARE(listed.queue.items()[0].request.complete, std::set{1});
    QVERIFY(!fs::exists(folder / "f_0004.png"));
  }

  void failed_and_removed_frames_are_told_and_rendered_again_and_only_these() {
    const TemporaryFolder folder;
    ListedQueue listed(folder / "renders");
    FrameExportRequest request = tiny_request(folder / "f.png");
    request.range = {1, 4, 30.0};
    fs::create_directory(folder / "f_0003.png");  // where no file can be written
    write_text(folder / "f_0003.png/x", "");
    listed.queue.add(request);
    QVERIFY(listed.wait_for(0, QueueState::failed));
    const auto details = [&] { return listed.list.findChild<QLabel*>("queue_details")->text(); };
    QVERIFY2(details().contains("3 of 4 frames") && details().contains("per frame") &&
                 details().contains("failed: 3"),
             qPrintable(details()));
    const RenderQueue::Item& item = listed.queue.items()[0];
    QCOMPARE(item.request.complete, (std::set{1, 2, 4}));
    auto* again = listed.list.findChild<QPushButton*>("queue_resume");
    QCOMPARE(again->text(), "Retry");
    const fs::path kept = folder / "f_0002.png";
    write_text(kept, "whole");
    fs::remove_all(folder / "f_0003.png");
    fs::remove(folder / "f_0004.png");
    click(listed.list, "queue_resume");
    QVERIFY(listed.wait_for(0, QueueState::done));
    QCOMPARE(item.rendered, 2);
    QVERIFY(fs::is_regular_file(folder / "f_0003.png"));
    QVERIFY(fs::is_regular_file(folder / "f_0004.png"));
    QCOMPARE(read_bytes(kept), "whole");
    QVERIFY2(!details().contains("failed"), qPrintable(details()));
    QCOMPARE(again->text(), "Resume");
  }
};

BRUME_APP_SUITE("render_queue", RenderQueueTest)
#include "render_queue_test.moc"
