// Auto, the error of what is shown, and the panel that tells of both.

#include <QAction>
#include <QComboBox>
#include <QDeadlineTimer>
#include <QLabel>
#include <QScopeGuard>
#include <QSettings>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>

#include "app/document/text/number_text.h"
#include "app/frames/error_meter.h"
#include "app/frames/quality_words.h"
#include "app/panels/plots/frontier_plot.h"
#include "app/panels/plots/performance_panel.h"
#include "app/viewport/viewport.h"
#include "app/widgets/frame_text.h"
#include "core/io/scene/scene_file.h"
#include "render/renderer.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

Scene dense_cloud() {
  return load_scene(std::filesystem::path(BRUME_SCENES) / "dense_cloud.brume");
}

// So many Gaussians that measuring takes far longer than what a test does meanwhile.
Scene heavy_scene() {
  Scene scene = small_scene();
  for (int k = 0; k < 10000; ++k) {
    const double x = std::fmod(0.618034 * k, 1.0);
    const double y = std::fmod(0.754878 * k, 1.0);
    const double z = std::fmod(0.569840 * k, 1.0);
    scene.medium.append({{3.0 * x - 1.5, 3.0 * y - 1.5, 3.0 * z - 1.5}, 0.25, 0.008});
  }
  return scene;
}

std::shared_ptr<const RenderedFrame> rendered(const Scene& scene) {
  auto frame = std::make_shared<RenderedFrame>();
  frame->request.scene = std::make_shared<const Scene>(scene);
  frame->request.camera = scene.camera;
  frame->request.film = {60, 40};
  frame->request.settings = sliced_settings({}, 16);
  Renderer renderer;
  frame->frame = *renderer.render(scene, scene.camera, {60, 40}, frame->request.settings);
  return frame;
}

const ErrorEstimate& error_of(MainWindow& window) {
  return window.viewport().frames().quality().error()->airlight;
}

// With the keyboard, as a user would.
void choose_bound(MainWindow& window, const QString& text) {
  auto* bounds = window.findChild<QComboBox*>("max_error");
  const int requested = bounds->findText(text);
  QVERIFY(requested >= 0);
  bounds->setFocus();
  while (bounds->currentIndex() != requested) {
    QTest::keyClick(bounds, bounds->currentIndex() < requested ? Qt::Key_Down : Qt::Key_Up);
  }
}

QTreeWidgetItem* stage(MainWindow& window, const QString& name) {
  return window.findChild<QTreeWidget*>("stages")->findItems(name, Qt::MatchExactly).value(0);
}

}  // namespace

class QualityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void auto_is_the_default_and_keeps_two_per_cent() {
    QSettings().remove("view/scattering");
    const auto once = qScopeGuard([] { QSettings().setValue("view/scattering", "single"); });
    TestWindow window(dense_cloud());
    QVERIFY(window->findChild<QAction*>("airlight_auto")->isChecked());
    QCOMPARE(window->viewport().frames().quality().max_error(), 0.02);
    QVERIFY(error_of(*window).high <= 0.02);
    QVERIFY(error_of(*window).high > 0.0);  // the estimate itself may be 0, within its interval
    const QString error = errors_text(*window->viewport().frames().quality().error());
    QVERIFY2(error.contains(" ± "), qPrintable(error));
    QCOMPARE(label_text(*window, "error"), "settled");
    QVERIFY(window->findChild<QLabel*>("error")->toolTip().contains(error));
    QCOMPARE(label_text(*window, "panel_error"), error);
    QVERIFY(window->findChild<QLabel*>("error")->isEnabled());
    QCOMPARE(label_text(*window, "quality"), settings_text(window.shown().request.settings));
  }

  void the_error_is_grey_while_outdated() {
    TestWindow window;
    auto* error = window->findChild<QLabel*>("error");
    QVERIFY(error->isEnabled());
    int grey = 0;
    connect(&window->viewport().frames(), &FrameScheduler::frame_shown, this, [&] {
      QVERIFY(!error->isEnabled());
      ++grey;
    });
    const QPoint middle = window->viewport().rect().center();
    window.drag(middle, middle + QPoint(60, 20), Qt::MiddleButton);
    QVERIFY(!window->viewport().frames().is_measured());
    QVERIFY(window.settle());
    QVERIFY(grey >= 1);
    QVERIFY(error->isEnabled());
  }

  void another_bound_is_another_choice() {
    TestWindow window(dense_cloud());
    const Viewport& view = window->viewport();
    const auto slices_for = [&](const QString& bound) {
      choose_bound(*window, bound);
      return window.settle() ? view.frames().shown()->request.settings.slices : 0;
    };
    const int loose = slices_for("10 %");
    QVERIFY(error_of(*window).high <= 0.1);
    const int tight = slices_for("1 %");
    QVERIFY(error_of(*window).high <= 0.01);
    QVERIFY2(0 < loose && loose < tight, qPrintable(QString("%1 %2").arg(loose).arg(tight)));
    QCOMPARE(label_text(*window, "shown"), QString("Auto: %1 slices").arg(tight));
    QVERIFY(label_text(*window, "why").contains("1 %"));
  }

  // Runs after the one above.
  void the_plot_shows_measured_current_and_auto_settings() {
    TestWindow window(dense_cloud());
    const auto* plot = window->findChild<FrontierPlot*>("frontier");
    choose_bound(*window, "10 %");
    QVERIFY(window.settle());
    choose_bound(*window, "1 %");
    QVERIFY(window.settle());
    QVERIFY(plot->points().size() >= 2);
    const auto count = [&](auto what) { return std::ranges::count(plot->points(), true, what); };
    QCOMPARE(count(&FrontierPlot::Point::is_shown), 1);
    QCOMPARE(count(&FrontierPlot::Point::is_auto_choice), 1);
    const FrontierPlot::Point autos =
        *std::ranges::find(plot->points(), true, &FrontierPlot::Point::is_auto_choice);
    QVERIFY(autos.is_shown);
    QCOMPARE(autos.error.rel_rmse, error_of(*window).rel_rmse);
    QVERIFY(autos.milliseconds > 0.0);
    for (const FrontierPlot::Point& point : plot->points()) {
      QVERIFY(QRectF(plot->rect()).contains(plot->position(point)));
    }

    // With a method of the user's own that one is on screen, and auto's still told of.
    invoke(window, "airlight_paper");
    QVERIFY(window.settle());
    QCOMPARE(plot->points().back().settings.airlight, AirlightMethod::paper);
    QVERIFY(plot->points().back().is_shown);
    QCOMPARE(count(&FrontierPlot::Point::is_shown), 1);
    QCOMPARE(count(&FrontierPlot::Point::is_auto_choice), 1);
    // Far more error lies higher up.
    QVERIFY(plot->position(plot->points().back()).y() < plot->position(autos).y());
    invoke(window, "airlight_auto");
    QVERIFY(window.settle());
  }

  // Runs after the one above.
  void the_bound_is_remembered() {
    TestWindow window;
    QCOMPARE(window->viewport().frames().quality().max_error(), 0.01);
    QCOMPARE(window->findChild<QComboBox*>("max_error")->currentText(), "1 %");
    choose_bound(*window, "2 %");
  }

  void an_unreachable_bound_is_reported() {
    TestWindow window;
    window->viewport().frames().quality().set_max_error(1e-9);
    QVERIFY(window.settle());
    QVERIFY(window->viewport().frames().quality().is_exhausted());
    QVERIFY2(label_text(*window, "error").contains("cannot be met"),
             qPrintable(label_text(*window, "error")));
    QVERIFY(label_text(*window, "why").contains("cannot meet"));
    window->viewport().frames().quality().set_max_error(0.02);
    QVERIFY(window.settle());
    QCOMPARE(label_text(*window, "error"), "settled");
  }

  void words_alarm_only_at_what_an_eye_sees() {
    QualityState state{.max_error = 0.02};
    QCOMPARE(quality_words(state), "refining");
    state.is_measured = true;
    QCOMPARE(quality_words(state), "settled");
    state.is_auto = true;
    state.error = FrameError{{.rel_rmse = 0.08}, ErrorEstimate{.rel_rmse = 0.008}};
    QCOMPARE(quality_words(state), "settled");  // the picture hides it
    state.error->picture->rel_rmse = 0.05;
    QVERIFY(quality_words(state).startsWith("2 % cannot be met here"));
    state.is_auto = false;
    QVERIFY(quality_words(state).startsWith("error above 2 %"));
    state.error->airlight.rel_rmse = 0.01;
    QCOMPARE(quality_words(state), "settled");
    state.noise = 0.3;  // of paths
    QCOMPARE(quality_words(state), "refining");
    state.has_all_paths = true;
    QVERIFY(quality_words(state).startsWith("noise above 2 %"));
    state.noise = 0.01;
    QCOMPARE(quality_words(state), "settled");
  }

  void another_scene_starts_anew() {
    TestWindow window;
    window->viewport().frames().quality().set_max_error(1e-9);
    QVERIFY(window.settle());
    QVERIFY(window.open("scene.brume"));
    QVERIFY(!window->viewport().frames().quality().error());
    QCOMPARE(window->viewport().frames().quality().control().step(), QualityControl().step());
  }

  void replaced_frames_are_not_measured() {
    const auto heavy = rendered(heavy_scene());
    const auto light = rendered(small_scene());
    ErrorMeter meter;
    std::vector<const RenderedFrame*> came;
    connect(
        &meter, &ErrorMeter::measured, this,
        [&](const std::shared_ptr<const RenderedFrame>& frame) { came.push_back(frame.get()); });
    meter.measure(heavy, {});
    QTest::qWait(20);  // it has begun
    meter.measure(light, {});
    QTRY_VERIFY(!came.empty());
    QCOMPARE(came, std::vector{light.get()});
    meter.measure(heavy, {});
    QTest::qWait(20);
    meter.cancel();
    meter.measure(light, {});
    QTRY_VERIFY(came.size() == 2);
    QCOMPARE(came.back(), light.get());
  }

  void a_change_cancels_measuring() {
    TestWindow window;
    const Scene heavy = heavy_scene();
    save_document(heavy, window.file("heavy.brume"));
    QVERIFY(window.open("heavy.brume"));
    Viewport& view = window->viewport();
    QVERIFY(QTest::qWaitFor([&] { return view.frames().is_settled(); }, patience));
    QVERIFY(!view.frames().is_measured());
    QSignalSpy errors(&view.frames().quality(), &FrameQuality::error_changed);
    window.key(Qt::Key_A, Qt::ShiftModifier);
    // Long enough for the error of what was there before to come.
    for (int k = 0; k < 30; ++k) {
      const RenderedFrame* before = view.frames().shown();
      Camera camera = view.camera();
      camera.eye.x += 0.01;
      view.camera_controller().set_camera(camera);
      QVERIFY(QTest::qWaitFor([&] { return view.frames().shown() != before; }, patience));
      QCOMPARE(view.frames().shown()->request.scene->medium.size(), heavy.medium.size() + 1);
    }
    QCOMPARE(errors.count(), 0);
    QVERIFY(window.settle());
  }

  void the_panel_shows_the_cost_of_the_frame() {
    TestWindow window;
    for (const char* name : {"light_table", "airlight", "composite", "frame"}) {
      QVERIFY2(stage(*window, name), name);
      bool is_number = false;
      stage(*window, name)->text(1).toDouble(&is_number);
      QVERIFY2(is_number, name);
    }
    QVERIFY(stage(*window, "visibility")->text(1).contains("no surfaces"));
    QVERIFY(stage(*window, "visibility")->isDisabled());
    QCOMPARE(label_text(*window, "gaussians_used"), "5 of 5 used");
    const FrameStatistics& statistics = window.shown().frame.statistics;
    QVERIFY(label_text(*window, "pairs").contains(count_text(statistics.view_pairs)));
    QCOMPARE(label_text(*window, "panel_error"),
             errors_text(*window->viewport().frames().quality().error()));
    QVERIFY(label_text(*window, "interval").contains(count_text(error_of(*window).pixels)));

    // Live: in motion too, which takes other settings than the finest.
    window->viewport().frames().quality().set_max_error(1e-9);
    QVERIFY(window.settle());
    int in_motion = 0;
    connect(&window->viewport().frames(), &FrameScheduler::frame_shown, this, [&] {
      if (label_text(*window, "picture").contains("in motion")) ++in_motion;
    });
    const QPoint middle = window->viewport().rect().center();
    // Again if a frame came so late that it was one at rest.
    const QDeadlineTimer deadline(patience);
    do {
      window.drag(middle, middle + QPoint(60, 20), Qt::MiddleButton);
    } while (!QTest::qWaitFor([&] { return in_motion > 0; }, 100) && !deadline.hasExpired());
    QVERIFY(in_motion > 0);
    QVERIFY(window.settle());
    QVERIFY(!label_text(*window, "picture").contains("in motion"));
    window->document().select({5});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    QCOMPARE(label_text(*window, "gaussians_used"), "4 of 4 used");
  }

  // Frame time, error and method; the rest where it is asked for, by mouse and for later.
  void the_panel_is_compact_until_it_is_unfolded() {
    QSettings().remove("performance/details");
    {
      TestWindow window;
      auto* details = window->findChild<QToolButton*>("performance_details");
      auto* stages = window->findChild<QTreeWidget*>("stages");
      for (const char* name : {"frame_time", "panel_error", "shown"}) {
        QVERIFY2(window->findChild<QLabel*>(name)->isVisible(), name);
        QVERIFY2(!label_text(*window, name).isEmpty(), name);
      }
      QVERIFY(label_text(*window, "frame_time").contains('s'));
      QVERIFY(label_text(*window, "shown").startsWith("Auto: "));
      QVERIFY(!stages->isVisible());
      QVERIFY(!window->findChild<QLabel*>("interval")->isVisible());
      QTest::mouseClick(details, Qt::LeftButton);
      QVERIFY(stages->isVisible());
      QVERIFY(window->findChild<QLabel*>("interval")->isVisible());
    }
    TestWindow later;
    auto* details = later->findChild<QToolButton*>("performance_details");
    QVERIFY(later->findChild<QTreeWidget*>("stages")->isVisible());
    QTest::mouseClick(details, Qt::LeftButton);
    QVERIFY(!later->findChild<QTreeWidget*>("stages")->isVisible());
  }

  void the_four_qualities_render() {
    TestWindow window(small_scene(), {500, 420});
    const Viewport& view = window->viewport();
    const auto choose = [&](const char* name) {
      invoke(window, name);
      return window.settle();
    };
    const auto is_checked = [&](const char* name) {
      return window->findChild<QAction*>(name)->isChecked();
    };
    QCOMPARE(window->findChild<QAction*>("airlight_auto")->text().remove('&'),
             "Auto (max error 2 %)");
    choose_bound(*window, "5 %");
    QCOMPARE(window->findChild<QAction*>("airlight_auto")->text().remove('&'),
             "Auto (max error 5 %)");
    choose_bound(*window, "2 %");
    QVERIFY(choose("airlight_fast"));
    QCOMPARE(view.frames().shown()->request.settings.slices, FrameQuality::fast_slices);
    QCOMPARE(label_text(*window, "shown"), "Fast: 8 slices");
    QVERIFY(choose("airlight_sliced"));
    QCOMPARE(label_text(*window, "shown"), "Fixed: 24 slices");
    QVERIFY(choose("airlight_paper"));
    QCOMPARE(label_text(*window, "shown"), "Paper's method");
    // More paths come by themselves, and the window answers meanwhile.
    QVERIFY(choose("airlight_reference"));
    QCOMPARE(view.frames().mode(), ViewMode::path_traced);
    QCOMPARE(label_text(*window, "shown"), "Reference: path tracing");
    const int paths = view.frames().shown()->request.settings.paths;
    QTRY_VERIFY(view.frames().shown()->request.settings.paths > paths);
    // View > Show wins, and the method is as it was before.
    window->viewport().frames().set_mode(ViewMode::final);
    QVERIFY(is_checked("airlight_paper") && !is_checked("airlight_reference"));
    window->viewport().frames().set_mode(ViewMode::path_traced);
    QVERIFY(is_checked("airlight_reference"));
    QVERIFY(choose("airlight_auto"));
    QCOMPARE(view.frames().mode(), ViewMode::final);
    QVERIFY(is_checked("airlight_auto"));
  }

  void numbers_are_short() {
    const auto text = [](double error, double high) {
      return error_text({error, error * error / high, high, 100});
    };
    QCOMPARE(text(0.014, 0.016), "1.4 ± 0.2 %");
    QCOMPARE(text(0.353, 0.384), "35 ± 3 %");
    QCOMPARE(text(0.0021, 0.0025), "0.21 ± 0.04 %");
    QCOMPARE(text(1e-6, 2e-6), "< 0.01 %");
    QCOMPARE(error_text({}), "< 0.01 %");
    QCOMPARE(errors_text({{0.014, 0.013, 0.016, 100}, std::nullopt}), "1.4 ± 0.2 %");
    QCOMPARE(errors_text({{0.014, 0.013, 0.016, 100}, ErrorEstimate{0.02, 0.01, 0.024, 100}}),
             "1.4 ± 0.2 %, picture 2.0 ± 0.4 %");
    QCOMPARE(count_text(12408), "12,408");
    QCOMPARE(bound_text(0.02), "2 %");
  }
};

BRUME_APP_SUITE("quality", QualityTest)
#include "quality_test.moc"
