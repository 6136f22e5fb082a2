// Renders that a session does not finish are in the queue of the next one.

#include <QDirIterator>
#include <QDockWidget>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>

#include "app/document/paths.h"
#include "app/export/queue_list.h"
#include "app/export/render_queue.h"
#include "app/files/numbered_file.h"
#include "app/window/pages/start_page.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/image/image_file.h"
#include "render/request.h"
#include "tests/app/listed_queue.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;
using RenderState = RenderQueue::State;

constexpr const char* killed_folder = "BRUME_TEST_KILLED_FOLDER";

// The folder as it is once it has so many records, without the locks of those that live.
fs::path folder_after_crash(const fs::path& folder, std::size_t records) {
  if (!QTest::qWaitFor([&] { return files_in(folder, ".json").size() == records; }, patience)) {
    qFatal("no records");
  }
  const fs::path copy = folder.string() + "_left";
  fs::create_directory(copy);
  for (const char* extension : {".json", ".brume"}) {
    for (const fs::path& file : files_in(folder, extension)) {
      fs::copy_file(file, copy / file.filename());
    }
  }
  return copy;
}

}  // namespace

class KeptRendersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Runs in a process of its own, which the next test kills.
  void a_sequence_is_rendered_until_killed() {
    const QString folder = qEnvironmentVariable(killed_folder);
    if (folder.isEmpty()) return;
    RenderQueue queue(to_path(folder + "/renders"));
    FrameExportRequest request = tiny_request(to_path(folder + "/f.png"));
    request.range = {1, 100'000, 30.0};
    queue.add(request);
    QTest::qWait(patience);
  }

  void a_killed_sequence_goes_on_where_it_was() {
    const TemporaryFolder folder;
    QProcess other;
    start_test(other, {"kept_renders", "a_sequence_is_rendered_until_killed"}, killed_folder,
               to_qstring(folder.path()));
    const auto is_begun = [&] {
      const auto records = fs::exists(folder / "renders") ? files_in(folder / "renders", ".json")
                                                          : std::vector<fs::path>{};
      return !records.empty() &&
             read_bytes(records[0]).find("\"complete\":[1") != std::string::npos;
    };
    QTRY_VERIFY(is_begun());
    QVERIFY(RenderQueue(folder / "renders").items().empty());  // it is rendered there
    other.kill();
    QVERIFY(other.waitForFinished(patience));

    ListedQueue next(folder / "renders");
    QCOMPARE(next.queue.items().size(), 1u);
    const RenderQueue::Item& item = next.queue.items()[0];
    QCOMPARE(item.state, RenderState::stopped);
    const std::set<int> complete = item.request.complete;
    QVERIFY(complete.contains(1) && complete.size() < 100'000);
    QVERIFY(next.tree()->topLevelItem(0)->text(0).contains("frames 1 to 100000 · f.png"));
    const fs::path lacking = numbered_file(folder / "f.png", *complete.rbegin() + 2);
    for (const int frame : complete) write_text(numbered_file(folder / "f.png", frame), "whole");
    fs::remove(lacking);
    QTest::qWait(100);
    QVERIFY(!fs::exists(lacking));  // nothing starts by itself
    click(next.list, "queue_resume");
    QTRY_VERIFY(fs::exists(lacking));
    for (const int frame : complete) {
      QCOMPARE(read_bytes(numbered_file(folder / "f.png", frame)), "whole");
    }
    click(next.list, "queue_remove");
    QTRY_VERIFY(next.queue.items().empty());
    QTRY_VERIFY(fs::is_empty(folder / "renders"));
  }

  // Runs in a process of its own, which the next test kills.
  void a_window_is_laid_out_until_killed() {
    const QString folder = qEnvironmentVariable(killed_folder);
    if (folder.isEmpty()) return;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder);
    TestWindow window(tiny_scene());
    window->keep_layout();
    window->resize(780, 700);
    window->findChild<QDockWidget*>("outliner")->hide();
    window->findChild<QDockWidget*>("lighting")->setFloating(true);
    QTest::qWait(patience);
  }

  void the_layout_of_a_killed_window_comes_back() {
    const QTemporaryDir folder;
    QProcess other;
    start_test(other, {"kept_renders", "a_window_is_laid_out_until_killed"}, killed_folder,
               folder.path());
    const auto kept = [&](const char* key) {
      QDirIterator files(folder.path(), {"*.conf"}, QDir::Files, QDirIterator::Subdirectories);
      return files.hasNext() ? QSettings(files.next(), QSettings::NativeFormat).value(key)
                             : QVariant();
    };
    const auto is_laid_out = [&] {
      QMainWindow probe;
      probe.restoreGeometry(kept("window/geometry").toByteArray());
      return probe.size() == QSize(780, 700);
    };
    QTRY_VERIFY_WITH_TIMEOUT(is_laid_out(), patience);
    other.kill();
    QVERIFY(other.waitForFinished(patience));
    for (const char* key : {"window/geometry", "window/state"})
      QSettings().setValue(key, kept(key));
    MainWindow next;
    next.show();
    QCOMPARE(next.size(), QSize(780, 700));
    QVERIFY(next.findChild<QDockWidget*>("outliner")->isHidden());
    QVERIFY(next.findChild<QDockWidget*>("lighting")->isFloating());
    QVERIFY(!next.findChild<QDockWidget*>("medium")->isFloating());
    for (const char* key : {"window/geometry", "window/state"}) QSettings().remove(key);
  }

  void waiting_renders_come_back_in_order_with_all_that_was_chosen() {
    const TemporaryFolder folder;
    FrameExportRequest request = tiny_request(folder / "view.exr");
    request.title = "Frame 3";
    request.request.camera = Camera{.eye = {1.0, 0.5, 5.0}};
    request.request.film = film_region(Film{64, 48}, {0.25, 0.25}, {0.75, 1.0});
    request.request.layers.normal = true;
    request.request.layers.depth = false;
    request.request.seed = 7;
    request.request.samples = 3;
    trace_paths(request.request, 5, Denoising::none);
    {
      RenderQueue queue(folder / "renders");
      queue.add(endless_request());
      const int last = queue.add(tiny_request(folder / "last.png"));
      const int view = queue.add(request);
      queue.move(view, true);
      QVERIFY(queue.items().back().id == last);
      QTRY_COMPARE(files_in(folder / "renders", ".json").size(), 3u);
    }
    ListedQueue next(folder / "renders");
    QCOMPARE(next.queue.items().size(), 3u);
    QCOMPARE(next.queue.unfinished(), 0);
    QCOMPARE(next.queue.items()[2].request.file, folder / "last.png");
    QCOMPARE(next.queue.items()[1].request.title, "Frame 3");
    next.click(1, "queue_resume");
    QVERIFY(next.wait_for(1, RenderState::done));
    const Frame frame = *render(*request.scene, request.request);
    const ImageLayers image = read_exr(folder / "view.exr");
    QCOMPARE(image.width, 32);
    QCOMPARE(image.height, 36);
    QVERIFY(image.channels.contains("normal.X") && !image.channels.contains("Z"));
    QCOMPARE(image.metadata.at("brume:airlight"), "path:5");
    QCOMPARE(image.channels.at("G")[700], frame.beauty[4 * 700 + 1]);
  }

  void what_is_done_cancelled_or_removed_does_not_come_back() {
    const TemporaryFolder folder;
    {
      ListedQueue listed(folder / "renders");
      listed.queue.add(tiny_request(folder / "done.png"));
      QVERIFY(listed.wait_for(0, RenderState::done));
      listed.queue.add(endless_request());
      for (const char* file : {"a.png", "b.png", "c.png"}) {
        listed.queue.add(tiny_request(folder / file));
      }
      listed.click(2, "queue_cancel");
      listed.click(3, "queue_remove");
      // Cancelled, and then asked for again.
      listed.click(3, "queue_cancel");
      click(listed.list, "queue_resume");
      listed.click(1, "queue_cancel");
      QTRY_COMPARE(listed.queue.items()[1].state, RenderState::cancelled);
      QVERIFY(listed.wait_for(3, RenderState::done));
      listed.queue.add(endless_request());
    }
    QCOMPARE(files_in(folder / "renders", ".json").size(), 1u);
    QCOMPARE(files_in(folder / "renders", ".brume").size(), 1u);
    RenderQueue next(folder / "renders");
    QCOMPARE(next.items().size(), 1u);
    QVERIFY(next.items()[0].request.file.empty());
  }

  void damaged_files_are_told_and_can_be_removed() {
    const TemporaryFolder folder;
    fs::path left;
    {
      RenderQueue queue(folder / "renders");
      for (int k = 0; k < 3; ++k) queue.add(endless_request());
      left = folder_after_crash(folder / "renders", 3);
    }
    std::vector<fs::path> records = files_in(left, ".json");
    std::ranges::sort(records);
    write_text(records[0], "{\"format\": \"brume-render\", \"vers");
    std::string text = read_bytes(records[1]);
    text.replace(text.find("path:100000"), 11, "magic");
    write_text(records[1], text);
    fs::path scene = records[2];
    write_text(scene.replace_extension(".brume"), "{");
    write_text(left / "scene_alone.brume", "{}");

    ListedQueue next(left);
    QCOMPARE(next.queue.items().size(), 3u);
    QVERIFY(!fs::exists(left / "scene_alone.brume"));
    const auto row_with = [&](const QString& message) {
      int row = 0;
      while (row < 3 && !next.queue.items()[row].message.contains(message)) ++row;
      return row;
    };
    const int damaged = row_with(to_qstring(records[0].filename()));
    const int strange = row_with("found magic; allowed: auto");
    QVERIFY(damaged < 3 && strange < 3);
    for (const int row : {damaged, strange}) {
      next.choose(row);
      QCOMPARE(next.queue.items()[row].state, RenderState::failed);
      QVERIFY(!next.list.findChild<QPushButton*>("queue_resume")->isEnabled());
    }
    const int sceneless = 3 - damaged - strange;
    QCOMPARE(next.queue.items()[sceneless].state, RenderState::stopped);
    next.click(sceneless, "queue_resume");
    QVERIFY(next.wait_for(sceneless, RenderState::failed));
    QVERIFY(next.queue.items()[sceneless].message.contains(to_qstring(scene.filename())));
    for (int k = 0; k < 3; ++k) {
      next.click(0, "queue_remove");
    }
    QTRY_VERIFY(fs::is_empty(left));
  }

  void closing_the_window_stops_a_render_and_keeps_it() {
    {
      TestWindow window(tiny_scene());
      choose(window, "output_method", 1);
      enter(window, "output_paths", "100000");
      enter(window, "film_width", "2000");
      window.key(Qt::Key_F12);
      auto& queue = *window->findChild<RenderQueue*>();
      window.key(Qt::Key_F12);
      QCOMPARE(queue.items().size(), 2u);
      window->document().undo_stack().setIndex(0);
      QString question;
      answer(QMessageBox::Cancel, &question);
      QVERIFY(!window->close());
      QVERIFY2(question.contains("2 renders"), qPrintable(question));
      queue.remove(queue.items()[1].id);
      QCOMPARE(queue.items().size(), 1u);
      answer(QMessageBox::Yes, &question);
      QVERIFY(window->close());
      QVERIFY2(question.contains("At the next start"), qPrintable(question));
    }
    {
      MainWindow window;
      window.show();
      auto& page = *window.findChild<StartPage*>();
      page.open();
      QVERIFY(page.isVisible());
      click(window, "show_queue");
      QVERIFY(!page.isVisible());
      QVERIFY(window.findChild<QTreeWidget*>("render_queue")->isVisible());
    }
    TestWindow window(tiny_scene());
    auto* list = window->findChild<QTreeWidget*>("render_queue");
    QCOMPARE(list->topLevelItemCount(), 1);
    QCOMPARE(list->topLevelItem(0)->text(0), "Camera, frame 0");
    const auto& queue = *window->findChild<RenderQueue*>();
    QCOMPARE(queue.items()[0].state, RenderState::stopped);
    click(window, "queue_resume");
    QCOMPARE(queue.items()[0].state, RenderState::rendering);
    click(window, "queue_remove");
    QTRY_VERIFY(queue.items().empty());
  }
};

BRUME_APP_SUITE("kept_renders", KeptRendersTest)
#include "kept_renders_test.moc"
