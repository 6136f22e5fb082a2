// Frames come, are right for what is shown, and never hold up the interface.

#include <cmath>

#include "app/commands/edit_medium.h"
#include "app/frame_export.h"
#include "app/viewport/frame_service.h"
#include "app/viewport/viewport.h"
#include "core/io/image_file.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

bool all_finite(const Frame& frame) {
  const auto finite = [](const std::vector<float>& values) {
    return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
  };
  return finite(frame.beauty) && finite(frame.airlight) && finite(frame.transmittance);
}

// A frame that takes far longer than a test would wait.
FrameRequest endless_request(std::uint64_t serial) {
  Scene scene = small_scene();
  for (int k = 0; k < 60; ++k) {
    scene.medium.append({{0.03 * k - 1.0, 0.02 * k - 0.5, 0.01 * k}, 0.5, 0.3});
  }
  FrameRequest request;
  request.scene = std::make_shared<const Scene>(scene);
  request.camera = scene.camera;
  request.film = {1600, 1200};
  request.settings.airlight = AirlightMethod::reference;
  request.settings.reference_tolerance = 1e-7;
  request.serial = serial;
  return request;
}

}  // namespace

class FramesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_frame_comes_and_changes_with_an_edit() {
    TestWindow window;
    Viewport& view = window->viewport();
    QCOMPARE(view.shown()->picture.size(),
             (QSizeF(view.size()) * view.devicePixelRatioF()).toSize());
    QVERIFY(all_finite(view.shown()->frame));
    const QImage before = view.shown()->picture;
    window->document().select({5});
    window.key(Qt::Key_Delete);
    QVERIFY(window.settle());
    QVERIFY(all_finite(view.shown()->frame));
    QVERIFY(view.shown()->picture != before);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window.settle());
    QCOMPARE(view.shown()->picture, before);
  }

  void exposure_changes_the_picture_alone() {
    TestWindow window;
    const RenderedFrame* frame = window->viewport().shown();
    window.key(Qt::Key_Plus);
    QCOMPARE(window->viewport().exposure(), 0.5);
    QCOMPARE(window->viewport().shown(), frame);
  }

  void a_long_frame_does_not_block_and_gives_way() {
    FrameService service;
    std::vector<std::uint64_t> came;
    connect(&service, &FrameService::frame_ready, this,
            [&](const std::shared_ptr<const RenderedFrame>& frame) {
              came.push_back(frame->request.serial);
            });
    service.request(endless_request(1));
    int ticks = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] { ++ticks; });
    timer.start(10);
    QTest::qWait(600);
    QVERIFY2(ticks >= 10, qPrintable(QString::number(ticks)));
    QVERIFY(came.empty());

    service.request(endless_request(2));
    FrameRequest last = endless_request(3);
    last.film = {40, 30};
    last.settings = {};
    service.request(last);
    QTRY_VERIFY_WITH_TIMEOUT(!came.empty(), 30000);
    QCOMPARE(came, std::vector<std::uint64_t>{3});
  }

  void in_motion_the_resolution_drops() {
    FrameService service;
    std::shared_ptr<const RenderedFrame> frame;
    connect(&service, &FrameService::frame_ready, this,
            [&](const std::shared_ptr<const RenderedFrame>& f) { frame = f; });
    FrameRequest request = endless_request(1);
    request.settings = {};
    request.film = {400, 300};
    request.moving = true;
    service.request(request);
    QTRY_VERIFY_WITH_TIMEOUT(frame, 30000);
    QCOMPARE(frame->divisor, 4);
    QCOMPARE(frame->frame.film, (Film{100, 75}));
  }

  void export_writes_the_scene_film_in_the_background() {
    TestWindow window;
    auto* exporter = window->findChild<FrameExport*>();
    for (const char* name : {"frame.exr", "frame.png"}) {
      QSignalSpy finished(exporter, &FrameExport::finished);
      window->export_frame_to(window.file(name));
      QVERIFY(exporter->is_running());
      QVERIFY(finished.wait(60000));
      QVERIFY(!exporter->is_running());
    }
    const ImageLayers layers = read_exr(window.file("frame.exr"));
    QCOMPARE(layers.width, 120);
    QCOMPARE(layers.height, 90);
    QVERIFY(layers.channels.contains("transmittance.G"));
    QCOMPARE(QImage(QString::fromStdString(window.file("frame.png").string())).size(),
             QSize(120, 90));

    QSignalSpy failed(exporter, &FrameExport::failed);
    window->export_frame_to(window.file("frame.tiff"));
    QVERIFY(failed.wait(60000));
  }

  void export_can_be_cancelled() {
    TestWindow window;
    auto* exporter = window->findChild<FrameExport*>();
    Scene big = small_scene();
    big.film = {3000, 2000};
    QSignalSpy cancelled(exporter, &FrameExport::cancelled);
    exporter->start(std::make_shared<const Scene>(big), big.camera, 0.0, window.file("big.png"));
    exporter->cancel();
    QVERIFY(cancelled.wait(30000));
    QVERIFY(!std::filesystem::exists(window.file("big.png")));
  }
};

BRUME_TEST_MAIN(FramesTest)
#include "frames_test.moc"
