// The menu Fog: each entry is one step, fits the scene, and undoing it leaves nothing.

#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/add_fog.h"
#include "app/files/scene_files.h"
#include "app/view/surface_picker.h"
#include "app/viewport/viewport.h"
#include "app/window/dialogs/fog_shape_dialog.h"
#include "core/math/random_source.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

class FogWindow : public TestWindow {
 public:
  void open_template(const char* name) {
    (*this)->files().open_copy(std::filesystem::path(BRUME_RESOURCES) / "templates" /
                               (std::string(name) + ".brume"));
    QTRY_VERIFY(!(*this)->files().loading().is_running());
    QTRY_VERIFY((*this)->viewport().surfaces().is_ready());
  }
  void choose(const char* name) { (*this)->findChild<QAction*>(name)->trigger(); }
  std::vector<Gaussian> added_after(std::size_t count) {
    return gaussians_after(document(), count);
  }
};

}  // namespace

class FogPresetsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void each_is_one_step_that_undo_takes_back() {
    FogWindow window;
    for (const char* scene : {"room", "landscape"}) {
      window.open_template(scene);
      const Scene before = window.scene();
      for (const FogPreset& preset : fog_presets()) {
        window.choose(preset.name);
        QVERIFY2(step_count(window.document()) == 1, preset.name);
        QVERIFY2(last_step(window.document()).startsWith("Add "), preset.name);
        QVERIFY2(!(window.scene() == before), preset.name);
        const auto added = window.added_after(before.medium.size());
        QVERIFY2(added.size() < 400, preset.name);
        QCOMPARE(window.document().selection().size(), added.size());
        window.document().undo_stack().undo();
        QVERIFY2(window.scene() == before, preset.name);
        window.document().undo_stack().clear();
      }
    }
  }

  void mist_lies_on_the_floor_of_a_room() {
    FogWindow window;
    window.open_template("room");
    const std::size_t count = window.document().medium().size();
    window.choose("fog.ground_mist");
    const auto added = window.added_after(count);
    QVERIFY(added.size() > 10);
    for (const Gaussian& gaussian : added) {
      QVERIFY(std::abs(gaussian.center.x) < 3.3 && std::abs(gaussian.center.z) < 2.8);
      QVERIFY(gaussian.center.y > -0.01 && gaussian.center.y < 1.5);
    }
  }

  void mist_follows_the_land() {
    FogWindow window;
    window.open_template("landscape");
    const std::size_t count = window.document().medium().size();
    window.choose("fog.ground_mist");
    const auto added = window.added_after(count);
    QVERIFY(added.size() > 10);
    double low = 1e9;
    double high = -1e9;
    for (const Gaussian& gaussian : added) {
      const auto ground = window->viewport().surfaces().hit(
          {gaussian.center.x, 200.0, gaussian.center.z}, {0.0, -1.0, 0.0});
      QVERIFY(ground);
      QVERIFY(gaussian.center.y > ground->position.y - 0.1);
      QVERIFY(gaussian.center.y < ground->position.y + 1.5 * gaussian.radius);
      low = std::min(low, ground->position.y);
      high = std::max(high, ground->position.y);
    }
    QVERIFY(high - low > 2.0);
  }

  void columns_stay_below_the_ceiling() {
    FogWindow window;
    window.open_template("room");
    const std::size_t count = window.document().medium().size();
    window.choose("fog.smoke_column");
    for (const Gaussian& gaussian : window.added_after(count)) QVERIFY(gaussian.center.y < 3.0);
    QVERIFY(window.added_after(count).size() > 20);
  }

  // It stands on the floor under the mouse; with the mouse elsewhere in the middle of the view.
  void a_column_rises_from_under_the_mouse() {
    FogWindow window;
    window.open_template("room");
    Viewport& view = window.view();
    const auto foot = [&] {
      const std::size_t count = window.document().medium().size();
      window.choose("fog.steam");
      const auto added = window.added_after(count);
      const auto low =
          std::ranges::min_element(added, {}, [](const Gaussian& g) { return g.center.y; });
      return film_position(view, low->center);
    };
    QTest::mouseMove(&*window, QPoint(5, 5));
    QTRY_VERIFY(!view.underMouse());
    QVERIFY(std::abs(foot().x() - view.width() / 2) < 40);
    const QPoint floor(view.width() / 4, view.height() - 30);
    QTest::mouseMove(&view, floor);
    QTRY_VERIFY(view.underMouse());
    QVERIFY((foot() - floor).manhattanLength() < 60);
    // A menu of the view keeps the place where it was asked for.
    {
      QObject menu;
      view.set_asked(menu, QPointF(view.width() * 0.75, view.height() - 30));
      QVERIFY(std::abs(foot().x() - view.width() * 3 / 4) < 60);
    }
    QVERIFY((foot() - floor).manhattanLength() < 60);
  }

  void sizes_follow_the_scene() {
    FogWindow window;
    const auto size_in = [&](double scale) {
      Scene scene = small_scene();
      scene.medium = {};
      scene.camera = {{0.0, 2.0 * scale, 6.0 * scale}, {0.0, 0.0, 0.0}};
      window.document().open(scene, {});
      window.choose("fog.steam");
      double sum = 0.0;
      for (const Gaussian& g : window.added_after(0)) sum += g.radius * g.density;
      return std::pair(window.added_after(0).at(5).radius, sum);
    };
    const auto [radius, depth] = size_in(1.0);
    const auto [large_radius, large_depth] = size_in(100.0);
    QVERIFY(std::abs(large_radius / radius - 100.0) < 1.0);
    QVERIFY(std::abs(large_depth / depth - 1.0) < 0.02);  // the same optical depth
  }

  void god_rays_bring_a_sun_if_there_is_none() {
    FogWindow window;
    const std::size_t lights = window.scene().lights.size();
    window.choose("fog.god_rays");
    QCOMPARE(window.scene().lights.size(), lights + 1);
    QVERIFY(window.scene().lights.back().as<light::Directional>());
    window.choose("fog.god_rays");
    QCOMPARE(window.scene().lights.size(), lights + 1);
  }

  void shapes_are_added_by_numbers() {
    FogWindow window;
    window.choose("fog.shape");
    auto* dialog = window->findChild<FogShapeDialog*>();
    QVERIFY(dialog && dialog->isVisible() && !dialog->isModal());
    const std::size_t count = window.document().medium().size();
    for (const char* axis : {"x", "y", "z"}) {
      enter(window, qPrintable(QString("fog_shape_size_%1").arg(axis)), "2");
      enter(window, qPrintable(QString("fog_shape_center_%1").arg(axis)), "0");
    }
    enter(window, "fog_shape_spacing", "0.25");
    enter(window, "fog_shape_density", "0.4");
    auto* label = dialog->findChild<QLabel*>("fog_shape_count");
    QCOMPARE(label->text(), "512 Gaussians");
    auto* button = dialog->findChild<QPushButton*>("fog_shape_add");
    button->click();
    const auto added = window.added_after(count);
    QCOMPARE(added.size(), 512u);
    // Even inside: what the density says.
    for (const glm::dvec3 at : {glm::dvec3(0.0), glm::dvec3(0.3, -0.2, 0.11)}) {
      double sum = 0.0;
      for (const Gaussian& g : added) {
        const double d = glm::distance(at, g.center) / g.radius;
        sum += g.density * std::exp(-d * d);
      }
      QVERIFY(std::abs(sum - 0.4) < 0.01);
    }
    QCOMPARE(last_step(window.document()), "Add fog box");
    enter(window, "fog_shape_spacing", "0.01");
    QVERIFY(!button->isEnabled());
    QVERIFY(label->text().contains("spacing"));

    auto* kind = dialog->findChild<QComboBox*>("fog_shape_kind");
    QTest::keyClick(kind, Qt::Key_Down);
    QCOMPARE(dialog->shape().kind, FogShape::Kind::sphere);
    QTest::keyClick(kind, Qt::Key_Down);
    const std::size_t before = window.document().medium().size();
    button->click();
    // Thinner above.
    const auto height_fog = window.added_after(before);
    const auto [low, high] =
        std::ranges::minmax_element(height_fog, {}, [](const Gaussian& g) { return g.center.y; });
    QVERIFY(low->density > 3.0 * high->density);
  }
};

BRUME_APP_SUITE("fog_presets", FogPresetsTest)
#include "fog_presets_test.moc"
