// All orders of scattering: chosen, shown, path-traced.

#include <QAction>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QDockWidget>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QTreeWidget>
#include <algorithm>

#include "app/commands/gaussians/edit_medium.h"
#include "app/viewport/legend.h"
#include "app/viewport/view_grid.h"
#include "app/window/pages/message_bar.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// A window whose picture has few pixels to trace paths for.
constexpr QSize small(600, 400);

// A cloud of optical depth 7, whose light is scattered more than once for the most part.
Scene dense_scene() {
  Scene scene = small_scene();
  scene.film = {40, 30};
  scene.medium.append({{0.0, 0.0, 0.0}, 0.8, 5.0});
  return scene;
}

double brightness(const Frame& frame) {
  double sum = 0.0;
  for (const float value : frame.airlight) sum += static_cast<double>(value);
  return sum / static_cast<double>(frame.airlight.size());
}

// rms(a - b) / rms(b).
double rms_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double gap = static_cast<double>(a[i] - b[i]);
    squares += gap * gap;
    sum += static_cast<double>(b[i] * b[i]);
  }
  return std::sqrt(squares / sum);
}

// With the keyboard, as a user would.
void choose_scattering(TestWindow& window, const QString& text) {
  window->findChild<QDockWidget*>("medium")->raise();
  auto* box = window->findChild<QComboBox*>("scattering");
  QTRY_VERIFY(box->isVisible());
  const int requested = box->findText(text);
  QVERIFY(requested >= 0);
  box->setFocus();
  while (box->currentIndex() != requested) {
    QTest::keyClick(box, box->currentIndex() < requested ? Qt::Key_Down : Qt::Key_Up);
  }
}

bool matches(const QString& text, const char* pattern) {
  return QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(text).hasMatch();
}

void look_from_aside(TestWindow& window) {
  Camera camera = window->viewport().camera();
  camera.eye.x += 0.2;
  window->viewport().camera_controller().set_camera(camera);
}

}  // namespace

class ScatteringTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QSettings().remove("view/scattering"); }

  void all_orders_are_the_default_and_brighter_than_once() {
    TestWindow window(dense_scene(), small);
    const FrameScheduler& frames = window->viewport().frames();
    QCOMPARE(window->findChild<QComboBox*>("scattering")->currentText(), "All orders");
    const auto shown_brightness = [&] { return brightness(frames.shown()->frame); };
    const double all = shown_brightness();
    QVERIFY(matches(label_text(*window, "panel_scattering"),
                    "all orders, converged to .* % in \\d+ sweeps"));
    const auto* stages = window->findChild<QTreeWidget*>("stages");
    QCOMPARE(stages->findItems("multiple scattering", Qt::MatchExactly).size(), 1);

    choose_scattering(window, "Once");
    QTRY_VERIFY(frames.is_settled());
    const double once = shown_brightness();
    QVERIFY2(all > 1.2 * once, qPrintable(QString("%1 %2").arg(all).arg(once)));
    QCOMPARE(label_text(*window, "panel_scattering"), "once");
    QVERIFY(stages->findItems("multiple scattering", Qt::MatchExactly).isEmpty());
    QVERIFY(!window->document().is_modified());

    choose_scattering(window, "All orders");
    QTRY_VERIFY(frames.is_settled());
    QVERIFY(shown_brightness() > 1.2 * once);
  }

  void the_choice_is_of_all_views_and_remembered() {
    {
      TestWindow window;
      choose_scattering(window, "Once");
    }
    TestWindow window;
    QCOMPARE(window->findChild<QComboBox*>("scattering")->currentText(), "Once");
    window->views().show_four(true);
    for (const Viewport* pane : window->views().panes()) {
      QVERIFY(pane->frames().quality().scattering() == Scattering::single);
    }
    choose_scattering(window, "All orders");
    for (const Viewport* pane : window->views().panes()) {
      QVERIFY(pane->frames().quality().scattering() == Scattering::multiple);
    }
  }

  void a_preset_is_one_step() {
    Desk desk;
    Document& document = desk.document();
    desk.findChild<QAction*>("preset_black_smoke")->trigger();
    const MediumOptics smoke = document.scene().optics;
    QVERIFY(smoke.albedo.x < 0.5 && smoke.anisotropy > 0.0);
    QCOMPARE(last_step(document), "Set medium to black smoke");
    desk.findChild<QAction*>("preset_black_smoke")->trigger();  // as it is
    QCOMPARE(step_count(document), 1);
    desk.findChild<QAction*>("preset_water_fog")->trigger();
    QVERIFY(document.scene().optics.albedo.x > 0.99);
    QCOMPARE(step_count(document), 2);
    document.undo_stack().undo();
    QVERIFY(document.scene().optics == smoke);
  }

  void few_sweeps_in_motion_and_convergence_at_rest() {
    TestWindow window(dense_scene(), small);
    const FrameScheduler& frames = window->viewport().frames();
    std::vector<int> in_motion;
    connect(&frames, &FrameScheduler::frame_shown, this, [&] {
      const auto& solved = frames.shown()->frame.statistics.scattering;
      if (frames.shown()->request.moving && solved) in_motion.push_back(solved->sweeps);
    });
    // Again if a frame came so late that it was one at rest.
    const QDeadlineTimer deadline(patience);
    for (int k = 1; in_motion.empty() && !deadline.hasExpired(); ++k) {
      const double density = 5.0 + 0.01 * (k % 100);
      const std::vector<GaussianId> cloud{window->document().medium().ids().back()};
      set_attribute(window->document(), cloud, GaussianAttribute::density, density);
      QTest::qWait(100);
    }
    QVERIFY(!in_motion.empty());
    QVERIFY(std::ranges::max(in_motion) <= 2);
    QTRY_VERIFY(frames.is_settled());
    const auto& solved = frames.shown()->frame.statistics.scattering;
    QVERIFY(solved);
    QVERIFY(solved->residual <= ScatteringLimits{}.tolerance);
  }

  void path_tracing_refines_until_a_change() {
    TestWindow window(dense_scene(), small);
    FrameScheduler& frames = window->viewport().frames();
    const auto* legend = window->viewport().findChild<Legend*>();
    std::vector<std::pair<std::uint64_t, int>> shown;  // state and paths, of whole pictures
    connect(&frames, &FrameScheduler::frame_shown, this, [&] {
      const FrameRequest& request = frames.shown()->request;
      if (request.settings.airlight == AirlightMethod::path && frames.shown()->divisor == 1) {
        shown.emplace_back(request.serial, request.settings.paths);
      }
    });
    const auto reaches = [&](int paths) {
      return QTest::qWaitFor([&] { return !shown.empty() && shown.back().second >= paths; },
                             patience);
    };
    frames.set_mode(ViewMode::path_traced);
    QVERIFY(reaches(2));
    QVERIFY(frames.is_measured());
    const char* paths = "\\d+ paths, noise .* %";
    QCOMPARE(label_text(*window, "error"), "refining");
    QVERIFY(window->findChild<QLabel*>("error")->toolTip().contains(" paths, noise "));
    QVERIFY(matches(label_text(*window, "panel_error"), paths));
    QVERIFY(label_text(*window, "panel_scattering").startsWith("all orders, "));
    QVERIFY(label_text(*window, "quality").startsWith("path tracing"));
    QVERIFY(legend->isVisible());
    QVERIFY(legend->scale().title.startsWith("Path traced, "));

    look_from_aside(window);
    QVERIFY(!frames.is_settled());
    shown.clear();
    QVERIFY(reaches(2));
    const auto state = shown.back().first;
    std::erase_if(shown, [&](const auto& frame) { return frame.first != state; });
    for (std::size_t k = 0; k < shown.size(); ++k) QCOMPARE(shown[k].second, 1 << k);
    const std::vector<float> beauty_of_paths = frames.shown()->frame.beauty;
    const double traced = brightness(frames.shown()->frame);

    // The settled picture of all orders is as bright.
    frames.set_mode(ViewMode::final);
    QTRY_VERIFY(frames.is_settled());
    QVERIFY(frames.shown()->request.settings.airlight != AirlightMethod::path);
    QVERIFY(!legend->isVisible());
    const double solved = brightness(frames.shown()->frame);
    QVERIFY2(std::abs(solved / traced - 1.0) < 0.1,
             qPrintable(QString("%1 %2").arg(solved).arg(traced)));
    // Paths only correct it: two of them alone are several times as far from it.
    QVERIFY(rms_difference(beauty_of_paths, frames.shown()->frame.beauty) < 0.1);
    // And measured again, though no other frame is needed.
    frames.set_mode(ViewMode::path_traced);
    frames.set_mode(ViewMode::final);
    QVERIFY(window.settle());
    QVERIFY(frames.shown()->request.settings.airlight != AirlightMethod::path);
  }

  void paths_hold_up_no_other_view() {
    TestWindow window(dense_scene(), small);
    window->viewport().frames().set_mode(ViewMode::path_traced);
    window->views().show_four(true);
    QVERIFY(&window->views().active() == &window->viewport());
    for (const Viewport* pane : window->views().panes()) QTRY_VERIFY(pane->frames().is_settled());
    const int paths = window.shown().request.settings.paths;
    QTRY_VERIFY(window.shown().request.settings.paths > paths);
  }

  void paths_are_traced_on_the_cpu_beside_opengl() {
    TestWindow window(dense_scene(), small);
    const FrameScheduler& frames = window->viewport().frames();
    invoke(window, "backend_gl");
    QVERIFY(window.settle());
    const std::string backend = frames.shown()->frame.statistics.backend;
    window->viewport().frames().set_mode(ViewMode::path_traced);
    QTRY_VERIFY(frames.shown()->request.settings.airlight == AirlightMethod::path);
    QCOMPARE(frames.shown()->frame.statistics.backend, "cpu");
    // Nothing has failed.
    if (backend == "gl") QVERIFY(!window->findChild<MessageBar*>()->isVisible());
    window->viewport().frames().set_mode(ViewMode::final);
    QVERIFY(window.settle());
    QCOMPARE(frames.shown()->frame.statistics.backend, backend);
    invoke(window, "backend_auto");
  }
};

BRUME_APP_SUITE("scattering", ScatteringTest)
#include "scattering_test.moc"
