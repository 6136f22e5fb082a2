// Playback: pictures are kept and shown again as they were rendered, and dropped frames are told.

#include <QLabel>
#include <QSpinBox>
#include <algorithm>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/time/playback_rate.h"
#include "app/document/time/timeline.h"
#include "app/frames/picture_cache.h"
#include "app/panels/time/playback_label.h"
#include "app/panels/time/time_ruler.h"
#include "app/viewport/view_grid.h"
#include "app/viewport/viewport.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

Scene moving_scene() {
  Scene scene = small_scene();
  scene.emitters.push_back({.rate = 30.0, .lifetime = 1.0});
  return scene;
}

const PictureCache& cache(TestWindow& window) {
  return window->findChild<ViewGrid*>()->picture_cache();
}

bool is_full(TestWindow& window, int frame) {
  const double time = window->timeline().time_of(frame);
  return std::ranges::any_of(cache(window).kept(0), [time](const PictureCache::Kept& kept) {
    return kept.time == time && kept.full;
  });
}

RenderedFrame frame_of(double time) {
  RenderedFrame frame;
  frame.request.time = time;
  frame.frame.film = {10, 10};
  frame.picture = QImage(10, 10, QImage::Format_RGB32);
  return frame;
}

}  // namespace

class PlaybackTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_cache_keeps_the_best_of_each_time_and_its_limit() {
    PictureCache cache(1000);
    cache.insert(frame_of(0.0), false);
    QCOMPARE(cache.bytes(), 400u);
    QVERIFY(!cache.kept(0).front().full);
    cache.insert(frame_of(0.0), true);
    cache.insert(frame_of(0.0), false);
    QCOMPARE(cache.bytes(), 400u);
    QVERIFY(cache.kept(0).front().full);
    QVERIFY(cache.find(0, 0.0, Camera{}));
    QVERIFY(!cache.find(1, 0.0, Camera{}));
    QVERIFY(!cache.find(0, 0.5, Camera{}));
    QVERIFY(!cache.find(0, 0.0, Camera{.eye = {1.0, 2.0, 3.0}}));
    cache.insert(frame_of(0.5), true);
    cache.insert(frame_of(1.0), true);  // no more room
    QCOMPARE(cache.kept(0).size(), 2u);
    cache.forget(0);
    QCOMPARE(cache.bytes(), 0u);
    QVERIFY(!cache.find(0, 0.0, Camera{}));
  }

  void a_frame_comes_back_as_it_was_rendered() {
    TestWindow window(moving_scene());
    FrameScheduler& frames = window->viewport().frames();
    auto* ruler = window->findChild<TimeRuler*>("frame_ruler");
    window->timeline().set_frame(15);
    QVERIFY(window.settle());
    const QImage rendered = frames.shown()->picture;
    window->timeline().set_frame(20);
    QVERIFY(window.settle());
    QVERIFY(frames.shown()->picture != rendered);
    QVERIFY(is_full(window, 15) && is_full(window, 20));
    QTRY_VERIFY(std::ranges::count(ruler->cached(), TimeRuler::Cached{15, true}) == 1);
    // At once, without a frame in motion between.
    window->timeline().set_frame(15);
    QVERIFY(frames.shown()->cached);
    QVERIFY(frames.shown()->picture == rendered);
    QCOMPARE(frames.shown()->request.scene->time, 0.5);
    QVERIFY(!frames.is_settled());
    QVERIFY(window.settle());
    QVERIFY(!frames.shown()->cached);
    QVERIFY(frames.shown()->picture == rendered);
  }

  void what_changes_the_picture_forgets_the_cache() {
    TestWindow window(moving_scene());
    Viewport& view = window->viewport();
    const auto is_forgotten = [&](auto&& change) {
      window->timeline().set_frame(15);
      if (!window.settle() || !is_full(window, 15)) return false;
      window->timeline().set_frame(20);
      if (!window.settle() || !is_full(window, 15)) return false;
      change();
      window->timeline().set_frame(15);
      const bool forgotten = !view.frames().shown()->cached;
      return forgotten && window.settle();
    };
    QVERIFY(is_forgotten([&] { view.frames().set_exposure(1.0); }));
    QVERIFY(is_forgotten([&] { view.frames().set_mode(ViewMode::airlight); }));
    QVERIFY(is_forgotten([&] { view.camera_controller().zoom_by(0.9); }));
    QVERIFY(is_forgotten([&] {
      add_gaussian(window->document(), {.center = {0.1, 0.2, 0.3}, .radius = 0.2, .density = 1.0});
    }));
    QVERIFY(is_forgotten([&] { window->document().undo_stack().undo(); }));
    QVERIFY(is_forgotten([&] { view.frames().quality().set_airlight(AirlightMethod::paper); }));
  }

  void a_loop_fills_the_cache_and_is_shown_at_full_quality_in_the_end() {
    TestWindow window(moving_scene());
    window->findChild<QSpinBox*>("last_frame_of_range")->setValue(4);
    QVERIFY(window.settle());
    auto* label = window->findChild<PlaybackLabel*>("playback_rate");
    QVERIFY(label->text().isEmpty());
    window.key(Qt::Key_Space);
    const QRect place = label->geometry();
    QTRY_VERIFY(label->text().contains("fps"));
    QCOMPARE(label->geometry(), place);
    for (int frame = 0; frame <= 4; ++frame) QTRY_VERIFY(is_full(window, frame));
    QTRY_VERIFY(window.shown().cached);
    QVERIFY(window->timeline().is_playing());
    const auto playing = [&] { return window->viewport().frames().shown(); };
    QTRY_COMPARE(window->timeline().frame(), 2);
    QTRY_COMPARE(playing()->divisor, 1);
    window.key(Qt::Key_Space);
    QVERIFY(window.settle());
    QVERIFY(label->text().isEmpty());  // it was about that playback
  }

  void dropped_frames_are_counted() {
    PlaybackRate rate;
    rate.start(1000);
    QCOMPARE(rate.measured(1100), 0.0);  // too soon to tell
    for (int k = 0; k < 24; ++k) {
      rate.show(k / 2, 1040 + 80 * (k / 2));
    }
    QCOMPARE(rate.measured(2000), 12.0);
    QCOMPARE(rate.measured(9000), 0.0);
    QCOMPARE(playback_text(12.0, 30.0), "12 of 30 fps, 18 dropped");
    QCOMPARE(playback_text(30.0, 30.0), "30 of 30 fps");
    QCOMPARE(playback_text(31.2, 30.0), "30 of 30 fps");
  }
};

BRUME_APP_SUITE("playback", PlaybackTest)
#include "playback_test.moc"
