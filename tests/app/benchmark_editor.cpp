// Main-thread time of what designers do all the time, at 10,000 and 100,000 Gaussians: no display
// needed (QT_QPA_PLATFORM=offscreen). Prints milliseconds of CPU time of the main thread, from an
// event until everything that follows from it in that thread is done, painting included; frames are
// rendered in other threads.

#include <QAbstractScrollArea>
#include <QLineEdit>
#include <QScrollBar>
#include <QTreeWidget>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string_view>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "app/widgets/application.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/test_window.h"
#include "tests/random.h"

using namespace brume;

namespace {

// CPU time, since the machine may be busy with other things.
double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// Knows the longest time that one event held up the others.
class MeteredApplication : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override {
    if (depth_++ > 0) {
      const bool result = QApplication::notify(receiver, event);
      --depth_;
      return result;
    }
    const double start = thread_milliseconds();
    const QString name = receiver->metaObject()->className();
    const bool result = QApplication::notify(receiver, event);
    const double taken = thread_milliseconds() - start;
    --depth_;
    add_sample(taken, name);
    return result;
  }

  void add_sample(double milliseconds, const QString& from) {
    if (milliseconds <= longest) return;
    longest = milliseconds;
    whose = from;
  }

  double longest = 0.0;
  QString whose;

 private:
  int depth_ = 0;
};

Scene cloud(int count) {
  Scene scene = small_scene();
  scene.medium = {};
  Random random(1);
  for (int k = 0; k < count; ++k) {
    const glm::dvec3 center = random.point(1.8);
    const double radius = random.uniform(0.01, 0.04);
    scene.medium.append({center, radius, random.uniform(0.1, 2.0)});
  }
  return scene;
}

class Benchmark {
 public:
  explicit Benchmark(MeteredApplication& application) : application_(application) {}

  void run(int count) {
    std::printf("\n%d Gaussians%*s median    worst    longest block\n", count, 12, "");
    save_document(cloud(count), to_path(folder_.filePath("cloud.brume")));
    MainWindow window;
    open(window, "cloud.brume");

    Viewport& view = window.viewport();
    Document& document = window.document();
    const auto position = [&](int k) {
      return QPoint(view.width() / 4 + 11 * k, view.height() / 2 + (k % 5) * 9);
    };
    measure("pick: what is under the mouse", 20,
            [&](int k) { QTest::mouseMove(&view, position(k)); });
    measure("pick: click that selects", 10,
            [&](int k) { QTest::mouseClick(&view, Qt::LeftButton, {}, position(k)); });
    auto* table = window.findChild<GaussianPanel*>()->table();
    QScrollBar* bar = table->verticalScrollBar();
    measure("scroll the table", 40, [&](int k) { bar->setValue(bar->maximum() / 40 * k); });
    measure("inspector: select 1000 others", 10, [&](int k) {
      std::vector<GaussianId> ids;
      for (int i = 0; i < 1000; ++i) {
        const auto at = static_cast<std::size_t>((k * 37 + i * 7) % count);
        ids.push_back(document.medium().ids()[at]);
      }
      select_gaussians(document, ids);
    });
    auto* filter = window.findChild<QLineEdit*>("gaussian_filter");
    measure("filter the table", 6, [&](int k) {
      filter->setText(QString("density > 0.%1, radius < 0.03, id > 5").arg(k));
    });
    measure("select what is shown", 4, [&](int k) {
      k % 2 == 0 ? QTest::keyClick(filter, Qt::Key_Return) : select_gaussians(document, {});
    });
    filter->clear();
    measure("inspector: select all, then none", 6,
            [&](int k) { k % 2 == 0 ? select_all(document) : select_gaussians(document, {}); });
    select_all(document);
    settle();
    measure("set the radius of all", 3, [&](int k) {
      set_attribute(document, document.selection(), GaussianAttribute::radius, 0.02 + 0.001 * k);
    });
    measure("undo that", 3, [&](int) { document.undo_stack().undo(); });
    select_gaussians(document, {});
    table->sortByColumn(3, Qt::AscendingOrder);
    settle();
    invoke(window, "tool.paintbrush");
    settle();
    measure("paintbrush: where it would paint", 20,
            [&](int k) { QTest::mouseMove(&view, position(k)); });
    stroke(window, "paintbrush", "paintbrush: a step of a stroke");
    measure("undo the stroke", 1, [&](int) { document.undo_stack().undo(); });
    stroke(window, "eraser", "eraser: a step of a stroke");
    measure("undo the stroke", 1, [&](int) { document.undo_stack().undo(); });
    measure("sort the table by a column", 2,
            [&](int k) { table->sortByColumn(k, Qt::AscendingOrder); });
    window.document().undo_stack().clear();
  }

  // The same Gaussians in ten groups.
  void run_groups(int count) {
    std::printf("\n%d Gaussians in ten groups%*s median    worst    longest block\n", count, 1, "");
    Scene scene = cloud(count);
    Medium medium;
    for (std::size_t i = 0; i < scene.medium.size(); ++i) {
      Gaussian gaussian = scene.medium.gaussian(i);
      gaussian.group = static_cast<GroupId>(i % 10 + 1);
      medium.append(gaussian);
    }
    scene.medium = medium;
    for (GroupId id = 1; id <= 10; ++id) {
      scene.groups.push_back({.id = id, .name = "g" + std::to_string(id)});
    }
    save_document(scene, to_path(folder_.filePath("groups.brume")));
    MainWindow window;
    open(window, "groups.brume");

    auto* tree = window.findChild<QTreeWidget*>("outliner_tree");
    const auto click = [tree](int row, int column) {
      QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                        cell_position(*tree, tree->topLevelItem(0)->child(row + 1), column));
    };
    measure("eye of a group", 10, [&](int k) { click(k / 2, 1); });
    measure("lock of a group", 10, [&](int k) { click(k / 2, 2); });
    measure("select a group", 10, [&](int k) { click(k, 0); });
    auto* title = window.findChild<QWidget*>("group_density_factor_title");
    QTest::mousePress(title, Qt::LeftButton, {}, {2, 2});
    measure("drag a factor of a group", 20,
            [&](int k) { move_mouse(*title, QPointF(6 + 4 * k, 2)); });
    QTest::mouseRelease(title, Qt::LeftButton, {}, {90, 2});
    stroke(window, "paintbrush", "paintbrush into a group: a step");
    measure("undo the stroke", 1, [&](int) { window.document().undo_stack().undo(); });
    stroke(window, "eraser", "eraser: a step");
    measure("undo the stroke", 1, [&](int) { window.document().undo_stack().undo(); });
    measure("group the selection", 3, [&](int k) {
      click(k, 0);
      invoke(window, "select.group");
    });
    measure("ungroup the selection", 3, [&](int k) {
      click(k, 0);
      invoke(window, "select.ungroup");
    });
    measure("undo these", 6, [&](int) { window.document().undo_stack().undo(); });
    click(3, 0);
    measure("delete a group", 1, [&](int) { QTest::keyClick(tree, Qt::Key_Delete); });
    measure("undo that", 1, [&](int) { window.document().undo_stack().undo(); });
    window.document().undo_stack().clear();
  }

 private:
  void open(MainWindow& window, const char* name) {
    window.show();
    begin();
    show_scene(window, to_path(folder_.filePath(name)));
    QTest::qWait(1500);
    report("open (from the file to the first frames)");
  }

  void stroke(MainWindow& window, const char* name, const char* title) {
    ToolBox& tools = window.tools();
    tools.activate(name);
    Viewport& view = window.viewport();
    const QPoint start = view.rect().center() - QPoint(100, 0);
    QTest::mousePress(&view, Qt::LeftButton, {}, start);
    settle();
    measure(title, 20, [&](int k) { move_mouse(view, start + QPoint(10 * k, 4 * (k % 3))); });
    QTest::mouseRelease(&view, Qt::LeftButton, {}, start);
    settle();
    tools.activate(0);
  }

  // Until what has come so far is worked off.
  void settle() {
    for (int k = 0; k < 3; ++k) QTest::qWait(20);
  }

  void begin() {
    settle();
    application_.longest = 0.0;
    times_.clear();
  }

  template <class Act>
  void measure(const char* title, int times, Act act) {
    begin();
    for (int k = 0; k < times; ++k) {
      const double start = thread_milliseconds();
      act(k);
      application_.add_sample(thread_milliseconds() - start, "the act itself");
      QTest::qWait(30);
      times_.push_back(thread_milliseconds() - start);
    }
    report(title);
  }

  void report(const char* title) {
    std::sort(times_.begin(), times_.end());
    if (times_.empty()) {
      std::printf("  %-40s                  ", title);
    } else {
      std::printf("  %-40s %7.1f  %7.1f  ", title, times_[times_.size() / 2], times_.back());
    }
    std::printf("%7.1f  %s\n", application_.longest, qPrintable(application_.whose));
    std::fflush(stdout);
  }

  MeteredApplication& application_;
  QTemporaryDir folder_;
  std::vector<double> times_;
};

}  // namespace

int main(int argc, char** argv) {
  const QTemporaryDir settings;
  prepare_application_in(settings);
  MeteredApplication application(argc, argv);
  set_up_application(application);
  std::printf("CPU time of the main thread [ms]\n");
  Benchmark benchmark(application);
  if (argc > 1 && std::string_view(argv[1]) == "groups") {
    benchmark.run_groups(100'000);
    return 0;
  }
  if (argc > 1) {
    benchmark.run(std::clamp(std::atoi(argv[1]), 1'000, 1'000'000));
    return 0;
  }
  for (const int count : {10'000, 100'000}) benchmark.run(count);
  benchmark.run_groups(100'000);
  return 0;
}
