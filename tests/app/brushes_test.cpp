// Brushes: soft edges, flow, jitter, smoothing, mirrors, snapping, the pressure of a pen, presets
// and the user's own.

#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QPointingDevice>
#include <QPushButton>
#include <QTabletEvent>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/brushes/brush_library.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/tool_box.h"
#include "app/widgets/mnemonics.h"
#include "brume/error.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

class BrushDesk : public Desk {
 public:
  BrushDesk() : Desk(scene_of_a_light()) { key(Qt::Key_B); }

  static Scene scene_of_a_light() {
    Scene scene = small_scene();
    scene.medium = {};
    return scene;
  }

  PaintbrushTool& brush() { return dynamic_cast<PaintbrushTool&>(tools().tool()); }
  AirbrushTool& airbrush() { return dynamic_cast<AirbrushTool&>(tools().tool()); }

  // A straight stroke of 200 pixels about the middle.
  std::vector<Gaussian> stroke() {
    const std::size_t before = document().medium().size();
    const QPoint center = view().rect().center();
    drag(center - QPoint(100, 30), center + QPoint(100, -30));
    return added_after(before);
  }
  std::vector<Gaussian> added_after(std::size_t count) {
    return gaussians_after(document(), count);
  }
  void pen(QEvent::Type type, QPointF position, double pressure) {
    static const QPointingDevice stylus("pen", 7, QInputDevice::DeviceType::Stylus,
                                        QPointingDevice::PointerType::Pen,
                                        QInputDevice::Capability::Pressure, 1, 1);
    QTabletEvent event(type, &stylus, position, view().mapToGlobal(position), pressure, 0, 0, 0, 0,
                       0, Qt::NoModifier, Qt::LeftButton,
                       type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
    QApplication::sendEvent(&view(), &event);
    QVERIFY(!event.isAccepted());  // so that Qt makes an event of the mouse of it
  }
  // A stroke of a pen whose pressure goes from one value to another.
  std::vector<Gaussian> pen_stroke(double first, double last) {
    const std::size_t before = document().medium().size();
    const QPointF start = view().rect().center() - QPoint(100, 30);
    pen(QEvent::TabletPress, start, first);
    QTest::mousePress(&view(), Qt::LeftButton, {}, start.toPoint());
    for (int k = 1; k <= 20; ++k) {
      const QPointF at = start + QPointF(10.0 * k, 0.0);
      pen(QEvent::TabletMove, at, first + (last - first) * k / 20.0);
      move(at);
    }
    const QPointF end = start + QPointF(200.0, 0.0);
    pen(QEvent::TabletRelease, end, 0.0);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, end.toPoint());
    return added_after(before);
  }
};

QMenu& open_presets(BrushDesk& desk, const char* name) {
  auto* menu = desk.findChild<QMenu*>(name);
  Q_EMIT menu->aboutToShow();
  return *menu;
}

QAction* entry(const QMenu& menu, const QString& text) {
  for (QAction* action : menu.actions()) {
    if (without_mnemonic(action->text()) == text) return action;
  }
  return nullptr;
}

QString library_text() {
  QFile file(QString::fromStdString(BrushLibrary::default_file().string()));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void write_library(const QByteArray& text) {
  const std::filesystem::path path = BrushLibrary::default_file();
  std::filesystem::create_directories(path.parent_path());
  write_text(path, text.toStdString());
}

}  // namespace

class BrushesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { std::filesystem::remove(BrushLibrary::default_file()); }

  void a_soft_edge_thins_towards_the_rim() {
    BrushDesk desk;
    enter(desk, "brush_scatter", "2");
    enter(desk, "brush_spacing", "0.1");
    enter(desk, "brush_falloff", "1");
    const double full = desk.brush().brush().density;
    const std::vector<Gaussian> gaussians = desk.stroke();
    QVERIFY(gaussians.size() > 30);
    // All in the view plane of a straight, level stroke: the offset is that in y and z.
    const double level = gaussians.front().center.y;
    const double reach = 2.0 * desk.brush().brush().radius;
    for (std::size_t k = 1; k < gaussians.size(); ++k) {
      const Gaussian& g = gaussians[k];
      const double offset = std::hypot(g.center.y - level, g.center.z) / reach;
      const double expected = full * (1.0 - offset * offset * (3.0 - 2.0 * offset));
      QVERIFY(std::abs(g.density - expected) < 0.01 * full);
    }
  }

  void flow_builds_up() {
    BrushDesk desk;
    const double full = desk.stroke().front().density;
    enter(desk, "brush_flow", "0.25");
    QVERIFY(std::abs(desk.stroke().front().density - 0.25 * full) < 1e-9);
  }

  void jitter_varies_radius_and_density() {
    BrushDesk desk;
    enter(desk, "brush_jitter", "1");
    const std::vector<Gaussian> gaussians = desk.stroke();
    const Paintbrush& brush = desk.brush().brush();
    const auto [low, high] = std::ranges::minmax(gaussians, {}, &Gaussian::radius);
    QVERIFY(high.radius > 1.3 * low.radius);
    for (const Gaussian& g : gaussians) {
      QVERIFY(g.radius >= 0.5 * brush.radius && g.radius <= 2.0 * brush.radius);
      QVERIFY(g.density >= 0.5 * brush.density && g.density <= 2.0 * brush.density);
    }
  }

  void smoothing_steadies_the_line() {
    // The rms distance from the mean height of a shaky stroke.
    const auto shake = [](double smoothing) {
      BrushDesk desk;
      enter(desk, "brush_scatter", "0");
      enter(desk, "brush_spacing", "0.2");
      enter(desk, "brush_smoothing", QString::number(smoothing));
      const QPointF start = desk.view().rect().center() - QPoint(150, 0);
      desk.press(start.toPoint());
      for (int k = 1; k <= 60; ++k) {
        desk.move(start + QPointF(5.0 * k, k % 2 == 0 ? 10.0 : -10.0));
      }
      QTest::mouseRelease(&desk.view(), Qt::LeftButton);
      double sum = 0.0;
      double squares = 0.0;
      const std::vector<Gaussian> all = desk.added_after(0);
      for (const Gaussian& g : all) {
        sum += g.center.y;
        squares += g.center.y * g.center.y;
      }
      const double n = all.size();
      return std::sqrt(squares / n - sum * sum / (n * n));
    };
    const double free = shake(0.0);
    QVERIFY(free > 0.0);
    QVERIFY(shake(40.0) < 0.3 * free);
  }

  void mirrors_repeat_the_stroke() {
    BrushDesk desk;
    click(desk, "brush_mirror_x");
    click(desk, "brush_mirror_y");
    const std::size_t steps = step_count(desk.document());
    QPoint at = desk.view().rect().center() + QPoint(120, 80);
    desk.drag(at, at + QPoint(60, 30));
    const std::vector<Gaussian> all = desk.added_after(0);
    QVERIFY(!all.empty() && all.size() % 4 == 0);
    for (std::size_t k = 0; k < all.size(); k += 4) {
      const glm::dvec3 p = all[k].center;
      QCOMPARE(all[k + 1].center.x, -p.x);
      QCOMPARE(all[k + 1].center.y, p.y);
      QCOMPARE(all[k + 2].center.y, -p.y);
      QVERIFY(glm::distance(all[k + 3].center, {-p.x, -p.y, p.z}) < 1e-12);
    }
    QCOMPARE(static_cast<std::size_t>(step_count(desk.document())), steps + 1);
    desk.document().undo_stack().undo();
    QVERIFY(desk.document().medium().empty());

    // Through what the view looks at.
    click(desk, "brush_mirror_y");
    choose(desk, "brush_mirror_at", 1);
    desk.view().camera_controller().drag(NavigationDrag::pan, {-90.0, 0.0});
    const double middle = desk.view().camera().target.x;
    QVERIFY(middle > 0.1);
    at = desk.view().rect().center() + QPoint(120, 80);
    desk.drag(at, at + QPoint(60, 30));
    const std::vector<Gaussian> pair = desk.added_after(0);
    QVERIFY(std::abs(pair[0].center.x + pair[1].center.x - 2.0 * middle) < 1e-9);
  }

  void what_lies_on_the_mirror_is_painted_once() {
    BrushDesk desk;
    enter(desk, "brush_scatter", "0");
    click(desk, "brush_mirror_z");
    const std::vector<Gaussian> gaussians = desk.stroke();  // in the plane z = 0
    for (std::size_t k = 1; k < gaussians.size(); ++k) {
      QVERIFY(glm::distance(gaussians[k].center, gaussians[k - 1].center) > 0.01);
    }
  }

  void strokes_snap_to_a_grid() {
    BrushDesk desk;
    enter(desk, "brush_scatter", "0");
    choose(desk, "brush_snap", 1);
    enter(desk, "brush_grid", "0.25");
    const std::vector<Gaussian> gaussians = desk.stroke();
    const glm::dvec3 first = gaussians.front().center;
    for (int k = 0; k < 3; ++k) QVERIFY(std::abs(std::remainder(first[k], 0.25)) < 1e-9);
  }

  void a_pen_changes_radius_and_density() {
    BrushDesk desk;
    enter(desk, "brush_scatter", "0");
    const Paintbrush brush = desk.brush().brush();
    const std::vector<Gaussian> both = desk.pen_stroke(0.2, 1.0);
    QVERIFY(both.size() > 5);
    QVERIFY(std::abs(both.front().radius / brush.radius - 0.2) < 1e-9);
    QVERIFY(both.back().radius > 0.9 * brush.radius);
    for (std::size_t k = 1; k < both.size(); ++k) {
      QVERIFY(both[k].radius >= both[k - 1].radius);
      QVERIFY(std::abs(both[k].radius / brush.radius - both[k].density / brush.density) < 1e-6);
    }
    choose(desk, "brush_pen", 2);
    const std::vector<Gaussian> density = desk.pen_stroke(0.5, 0.5);
    QCOMPARE(density.back().radius, brush.radius);
    QVERIFY(std::abs(density.back().density - 0.5 * brush.density) < 1e-9);
    // The mouse has full pressure again.
    QVERIFY(std::abs(desk.stroke().front().density - brush.density) < 1e-9);
  }

  void presets_follow_the_view() {
    BrushDesk desk;
    QVERIFY(!entry(open_presets(desk, "brush_presets"), "Steam jet"));
    QAction* mist = entry(open_presets(desk, "brush_presets"), "Soft mist");
    QVERIFY(mist);
    mist->trigger();
    const Paintbrush near_brush = desk.brush().brush();
    QVERIFY(near_brush.falloff > 0.5);
    QCOMPARE(value(desk, "brush_falloff"), "0.9");
    QVERIFY(!desk.stroke().empty());
    desk.view().camera_controller().zoom_by(10.0);
    entry(open_presets(desk, "brush_presets"), "Soft mist")->trigger();
    const Paintbrush far_brush = desk.brush().brush();
    QVERIFY(std::abs(far_brush.radius / near_brush.radius - 10.0) < 0.6);
    QVERIFY(
        std::abs(far_brush.radius * far_brush.density / (near_brush.radius * near_brush.density) -
                 1.0) < 0.1);

    desk.key(Qt::Key_A);
    entry(open_presets(desk, "air_presets"), "Steam jet")->trigger();
    QCOMPARE(desk.airbrush().airbrush().rate, 120.0);
  }

  void every_preset_comes_back_from_its_numbers() {
    BrushDesk desk;
    for (const BrushPreset& preset : brush_presets()) {
      desk.key(preset.sprays ? Qt::Key_A : Qt::Key_B);
      auto& tool = dynamic_cast<FogBrushTool&>(desk.tools().tool());
      tool.apply_preset(preset);
      BrushPreset back = tool.preset();
      QVERIFY2(std::abs(back.size / preset.size - 1.0) < 0.06, qPrintable(preset.name));
      QVERIFY2(std::abs(back.depth / preset.depth - 1.0) < 0.06, qPrintable(preset.name));
      back.size = preset.size;
      back.depth = preset.depth;
      back.name = preset.name;
      if (preset.sprays) {
        back.speed = preset.speed;
        back.wander = preset.wander;
      }
      QVERIFY2(back == preset, qPrintable(preset.name));
    }
  }

  void ones_own_brushes_are_kept() {
    {
      BrushDesk desk;
      enter(desk, "brush_scatter", "1.5");
      enter(desk, "brush_flow", "0.4");
      enter(desk, "brush_stretch", "2.5");
      QMenu& menu = open_presets(desk, "brush_presets");
      auto* name = menu.findChild<QLineEdit*>("brush_preset_name");
      auto* save = menu.findChild<QPushButton*>("brush_preset_save");
      QVERIFY(!save->isEnabled());
      QTest::keyClicks(name, "Thin & wide");
      QVERIFY(save->isEnabled());
      QTest::mouseClick(save, Qt::LeftButton);
    }
    BrushDesk desk;
    QAction* own = entry(open_presets(desk, "brush_presets"), "Thin & wide");
    QVERIFY(own);
    own->trigger();
    QCOMPARE(desk.brush().brush().scatter, 1.5);
    QCOMPARE(desk.brush().brush().flow, 0.4);
    QCOMPARE(desk.brush().brush().stretch, 2.5);
    QVERIFY(!entry(open_presets(desk, "air_presets"), "Thin & wide"));

    auto* remove = open_presets(desk, "brush_presets").findChild<QAction*>("delete_Thin & wide");
    QVERIFY(remove);
    remove->trigger();
    QVERIFY(!entry(open_presets(desk, "brush_presets"), "Thin & wide"));
  }

  void unknown_keys_of_the_library_are_kept() {
    write_library(R"({"format": "brume-brushes", "version": 1, "author": "me",
      "brushes": [{"name": "a", "tool": "paintbrush", "size": 0.5, "note": "mine"}]})");
    const BrushLibrary library(BrushLibrary::default_file());
    BrushPreset preset = library.read().at(0);
    QCOMPARE(preset.size, 0.5);
    preset.size = 0.25;
    library.add(preset);
    QCOMPARE(library.read().size(), 1u);
    QCOMPARE(library.read().at(0).size, 0.25);
    QVERIFY(library_text().contains("mine") && library_text().contains("author"));
  }

  void a_broken_library_is_told_once_and_never_overwritten() {
    const QByteArray head = R"({"format": "brume-brushes", "version": 1, "brushes": )";
    for (const auto& [text, place] : std::vector<std::pair<QByteArray, QString>>{
             {"{", "byte"},
             {"[]", "object"},
             {R"({"format": "other"})", "format"},
             {R"({"format": "brume-brushes", "version": 2})", "version"},
             {head + "3}", "brushes"},
             {head + "[7]}", "brushes[0]"},
             {head + R"([{"tool": "paintbrush"}]})", "brushes[0].name"},
             {head + R"([{"name": "a", "tool": "broom"}]})", "brushes[0].tool"},
             {head + R"([{"name": "a", "tool": "airbrush", "size": -1}]})", "brushes[0].size"},
             {head + R"([{"name": "a", "tool": "airbrush", "size": "x"}]})", "brushes[0].size"},
             {head + R"([{"name": "a", "tool": "airbrush", "flow": 1e99}]})", "brushes[0].flow"}}) {
      write_library(text);
      BrushDesk desk;
      QSignalSpy refused(&desk.brush(), &Tool::refused);
      QMenu& menu = open_presets(desk, "brush_presets");
      open_presets(desk, "brush_presets");
      QCOMPARE(refused.count(), 1);
      const QString problem = refused[0][0].toString();
      QVERIFY2(problem.contains("brushes.json") && problem.contains(place), qPrintable(problem));
      QVERIFY(menu.findChild<QAction*>("broken_library"));
      QVERIFY(entry(menu, "Wisps"));
      QVERIFY(!menu.findChild<QLineEdit*>("brush_preset_name"));
      try {
        BrushLibrary(BrushLibrary::default_file()).add({.name = "b"});
        QFAIL("a broken library was written");
      } catch (const InputError&) {
      }
      QCOMPARE(library_text().toUtf8(), text);
    }
  }

  void an_airbrush_is_mirrored_and_jittered() {
    BrushDesk desk;
    desk.key(Qt::Key_A);
    qint64 now = 0;
    desk.airbrush().set_clock([&] { return now; });
    click(desk, "air_mirror_x");
    enter(desk, "air_jitter", "1");
    const QPoint at = desk.view().rect().center() + QPoint(100, 0);
    desk.press(at);
    for (int k = 1; k <= 10; ++k) {
      now += 100;
      desk.move(at + QPoint(k, 0));
    }
    desk.release(at);
    const std::vector<Gaussian> all = desk.added_after(0);
    QVERIFY(all.size() > 40 && all.size() % 2 == 0);
    std::set<double> radii;
    for (std::size_t k = 0; k < all.size(); k += 2) {
      QCOMPARE(all[k + 1].center.x, -all[k].center.x);
      QCOMPARE(all[k + 1].radius, all[k].radius);
      radii.insert(all[k].radius);
    }
    QVERIFY(radii.size() > 10);
    desk.document().undo_stack().undo();
    QVERIFY(desk.document().medium().empty());
  }
};

BRUME_APP_SUITE("brushes", BrushesTest)
#include "brushes_test.moc"
