// Views show a frame in false colours.

#include <cmath>
#include <numeric>

#include "app/frames/error_map.h"
#include "app/viewport/legend.h"
#include "render/renderer.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

std::shared_ptr<const RenderedFrame> rendered(const Settings& settings) {
  auto result = std::make_shared<RenderedFrame>();
  FrameRequest& request = result->request;
  request.scene = std::make_shared<const Scene>(small_scene());
  request.camera = request.scene->camera;
  request.film = {45, 34};
  request.settings = settings;
  result->frame = *Renderer().render(*request.scene, request.camera, request.film, settings);
  return result;
}

}  // namespace

class ModesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_cost_mode_matches_the_frame() {
    for (const int scale : {1, 4}) {
      Settings settings = sliced_settings({}, 12);
      settings.airlight_scale = scale;
      const auto frame = rendered(settings);
      const FrameStatistics& statistics = frame->frame.statistics;
      const double sum =
          std::accumulate(statistics.pixel_pairs.begin(), statistics.pixel_pairs.end(), 0.0);
      QVERIFY(statistics.view_pairs > 0);
      QVERIFY(std::abs(sum - static_cast<double>(statistics.view_pairs)) < 1e-4 * sum);
    }
    // A corner that is hardly reached costs less than fog; the end of the scale is no less than
    // any.
    const auto frame = rendered(sliced_settings({}, 12));
    const QImage picture = to_picture(frame->frame, {0.0}, ViewMode::cost);
    QVERIFY(2 * qGreen(picture.pixel(0, 0)) < qGreen(picture.pixel(22, 20)));
    const ColorScale scale = color_scale(frame->frame, ViewMode::cost, nullptr);
    QCOMPARE(scale.ticks.size(), 3);
    const auto& pairs = frame->frame.statistics.pixel_pairs;
    QVERIFY(scale.ticks[2].toDouble() >= 0.5 * *std::max_element(pairs.begin(), pairs.end()));
  }

  void the_error_map_matches_the_reference() {
    Settings settings;
    settings.scattering = Scattering::single;
    const auto frame = rendered(sliced_settings(settings, 8));
    settings.airlight = AirlightMethod::reference;
    const auto truth = rendered(settings);
    ErrorMapper mapper;
    std::shared_ptr<const ErrorMap> map;
    connect(&mapper, &ErrorMapper::grown, this, [&](const auto& of, const auto& grown) {
      QCOMPARE(of, frame);
      QVERIFY(!map || grown->done >= map->done);
      map = grown;
    });
    mapper.start(frame);
    QTRY_VERIFY(map && map->done == 1.0);
    const std::vector<float>& a = frame->frame.airlight;
    const std::vector<float>& b = truth->frame.airlight;
    double all = 0.0;
    for (const float v : a) all += static_cast<double>(v) * static_cast<double>(v);
    const double unit = std::sqrt(all / static_cast<double>(a.size()));
    double worst = 0.0;
    for (std::size_t i = 0; i < map->error.size(); ++i) {
      double square = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        square += std::pow(static_cast<double>(a[3 * i + c] - b[3 * i + c]), 2) / 3.0;
      }
      const double error = std::sqrt(square) / unit;
      // The map's own reference is converged that far.
      worst = std::max(worst, std::abs(error - static_cast<double>(map->error[i])));
    }
    QVERIFY2(worst < 5e-3, qPrintable(QString::number(worst)));
    const auto max_value = std::max_element(map->error.begin(), map->error.end());
    QVERIFY(*max_value > 0.01F);
    const auto at = static_cast<int>(max_value - map->error.begin());
    QVERIFY(error_picture(*map).pixel(at % 45, at / 45) != false_color(0.0));
    QCOMPARE(error_picture(*map).pixel(0, 0), false_color(0.0));
  }

  void the_error_map_of_all_orders_is_that_of_all_light() {
    Settings settings = sliced_settings({}, 24);
    settings.scattering = Scattering::multiple;
    const auto map_of = [this](const std::shared_ptr<const RenderedFrame>& frame) {
      ErrorMapper mapper;
      std::shared_ptr<const ErrorMap> map;
      connect(&mapper, &ErrorMapper::grown, this,
              [&](const auto&, const auto& grown) { map = grown; });
      mapper.start(frame);
      return QTest::qWaitFor([&] { return map && map->done == 1.0; }, patience) ? map : nullptr;
    };
    const auto rms_of = [](const ErrorMap& map) {
      double square = 0.0;
      for (const float e : map.error) square += static_cast<double>(e) * static_cast<double>(e);
      return std::sqrt(square / static_cast<double>(map.error.size()));
    };
    const std::shared_ptr<const RenderedFrame> right = rendered(settings);
    const auto map = map_of(right);
    QVERIFY(map && map->all_orders);
    // The noise of 256 paths, clipped at 0, included.
    QVERIFY2(rms_of(*map) < 0.06, qPrintable(QString::number(rms_of(*map))));
    QCOMPARE(color_scale({}, ViewMode::error, map.get()).title, "Error, all orders of scattering");

    const auto half = std::make_shared<RenderedFrame>(*right);
    for (float& v : half->frame.airlight) v *= 0.5F;
    const auto map_of_half = map_of(half);
    QVERIFY(map_of_half);
    QVERIFY2(std::abs(rms_of(*map_of_half) - 1.0) < 0.05,
             qPrintable(QString::number(rms_of(*map_of_half))));
  }

  void the_error_map_refines_until_a_change() {
    TestWindow window;
    Viewport& view = window->viewport();
    auto* legend = view.findChild<Legend*>();
    QVERIFY(!legend->isVisible());
    view.frames().set_mode(ViewMode::error);
    QVERIFY(legend->isVisible());
    QTRY_VERIFY(view.frames().error_map());
    const double done = view.frames().error_map()->done;
    QTRY_VERIFY(view.frames().error_map()->done > done || done == 1.0);
    QVERIFY(legend->scale().title.startsWith("Error"));
    QCOMPARE(legend->scale().ticks, (QStringList{"0.1 %", "1 %", "10 %"}));

    Camera camera = view.camera();
    camera.eye.x += 0.2;
    view.camera_controller().set_camera(camera);
    QVERIFY(!view.frames().error_map());
    QVERIFY(window.settle());
    QTRY_VERIFY(view.frames().error_map());
    window->document().select({2});
    window.key(Qt::Key_Delete);
    QVERIFY(!view.frames().error_map());
    view.frames().set_mode(ViewMode::cost);
    QVERIFY(window.settle());
    QTest::qWait(400);
    QVERIFY(!view.frames().error_map());
    QVERIFY(legend->scale().title.startsWith("Pairs"));
    view.frames().set_mode(ViewMode::final);
    QVERIFY(!legend->isVisible());
  }
};

BRUME_APP_SUITE("modes", ModesTest)
#include "modes_test.moc"
