// Selecting, the clipboard, hiding and locking, and the handles that transform.

#include <QClipboard>
#include <glm/geometric.hpp>

#include "app/commands/gaussians/clipboard.h"
#include "app/commands/gaussians/select_command.h"
#include "app/document/paths.h"
#include "app/files/scene_files.h"
#include "app/tools/selection/selection_tool.h"
#include "app/tools/tool_box.h"
#include "app/view/drawing/gizmo.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
#include "brume/error.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

using Ids = std::vector<GaussianId>;

namespace {

// Draws a closed line around some places.
void lasso(Desk& desk, const std::vector<QPoint>& line, Qt::KeyboardModifiers modifiers) {
  DeskView& view = desk.view();
  QTest::mousePress(&view, Qt::LeftButton, modifiers, line.front());
  for (const QPoint& point : line) desk.move(point, Qt::LeftButton, modifiers);
  QTest::mouseRelease(&view, Qt::LeftButton, modifiers, line.back());
}

std::vector<QPoint> triangle(QPoint around) {
  return {around + QPoint(-30, 25), around + QPoint(30, 25), around + QPoint(0, -35)};
}

glm::dvec3 center(const Document& document, std::size_t index) {
  return document.medium().centers()[index];
}

}  // namespace

class SelectionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sets_combine() {
    const Ids a{1, 2, 3};
    const Ids b{2, 3, 4};
    QCOMPARE(combined(a, b, SelectMode::set), b);
    QCOMPARE(combined(a, b, SelectMode::add), (Ids{1, 2, 3, 4}));
    QCOMPARE(combined(a, b, SelectMode::remove), Ids{1});
    QCOMPARE(combined(a, b, SelectMode::intersect), (Ids{2, 3}));
    QCOMPARE(combined(a, b, SelectMode::toggle), (Ids{1, 4}));
  }

  void selecting_is_a_step_but_no_change() {
    TestWindow window;
    Document& document = window->document();
    window.click(window.handle(2));
    QCOMPARE(last_step(document), "Select 1 Gaussian");
    QVERIFY(!document.is_modified() && !window->isWindowModified());
    window.key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(document.selection().size(), 5u);
    window.key(Qt::Key_A, Qt::ControlModifier);  // they are already
    QCOMPARE(step_count(document), 2);
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.selection(), Ids{3});
    window.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.selection().empty());
    window.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(document.selection(), Ids{3});
    // A change, a selection and the change undone: saved again.
    window.key(Qt::Key_Delete);
    window.key(Qt::Key_A, Qt::ControlModifier);
    QVERIFY(document.is_modified());
    document.undo_stack().setIndex(1);
    QVERIFY(!document.is_modified());
    QCOMPARE(document.selection(), Ids{3});
  }

  void a_click_selects_the_visible_gaussian() {
    Desk desk;
    // Well inside the outline, far from the handle.
    const QPoint beside = desk.handle(1) + QPoint(22, 0);
    QVERIFY(!desk.view().handles().pick(beside));
    desk.click(beside);
    QCOMPARE(desk.document().selection(), Ids{2});
  }

  void a_lasso_selects_enclosed_centers() {
    Desk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_L);
    lasso(desk, triangle(desk.handle(1)), {});
    QCOMPARE(document.selection(), Ids{2});
    lasso(desk, triangle(desk.handle(3)), Qt::ShiftModifier);
    QCOMPARE(document.selection(), (Ids{2, 4}));
    lasso(desk, triangle(desk.handle(3)), Qt::ShiftModifier | Qt::ControlModifier);
    QCOMPARE(document.selection(), Ids{4});
    lasso(desk, triangle(desk.handle(3)), Qt::ControlModifier);
    QVERIFY(document.selection().empty());
    QCOMPARE(step_count(document), 4);
    dynamic_cast<SelectionTool&>(desk.tools().tool()).set_mode(SelectMode::add);
    lasso(desk, triangle(desk.handle(0)), {});
    lasso(desk, triangle(desk.handle(1)), {});
    QCOMPARE(document.selection(), (Ids{1, 2}));
  }

  void a_brush_selects_in_one_step() {
    Desk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_C);
    desk.drag(desk.handle(0), desk.handle(1));
    QVERIFY(document.is_selected(1) && document.is_selected(2));
    QVERIFY(!document.is_selected(3));
    QCOMPARE(step_count(document), 1);
    desk.drag(desk.handle(1), desk.handle(1) + QPoint(5, 0), Qt::LeftButton, Qt::ControlModifier);
    QVERIFY(!document.is_selected(2));
    const Ids before = document.selection();
    desk.press(desk.handle(2));
    QCOMPARE(document.selection(), Ids{3});
    QTest::keyClick(&desk.view(), Qt::Key_Escape);
    desk.release(desk.handle(2));
    QCOMPARE(document.selection(), before);
    QCOMPARE(step_count(document), 2);
  }

  void selection_grows_and_shrinks_by_contact() {
    Scene scene = small_scene();
    scene.medium = {};
    for (int k = 0; k < 6; ++k) scene.medium.append({{0.5 * k - 1.5, 0, 0}, 0.3, 0.5});
    TestWindow window(scene);
    Document& document = window->document();
    document.select({3});
    window.key(Qt::Key_Plus, Qt::ControlModifier);
    QCOMPARE(document.selection(), (Ids{2, 3, 4}));
    window.key(Qt::Key_Plus, Qt::ControlModifier);
    QCOMPARE(document.selection(), (Ids{1, 2, 3, 4, 5}));
    window.key(Qt::Key_Minus, Qt::ControlModifier);
    QCOMPARE(document.selection(), (Ids{1, 2, 3, 4}));
    QCOMPARE(last_step(document), "Select 4 Gaussians");
  }

  void hidden_gaussians_are_invisible_and_protected() {
    TestWindow window;
    Document& document = window->document();
    document.select({2});
    const QPoint at = window.handle(1);
    window.key(Qt::Key_H);
    QCOMPARE(document.hidden(), Ids{2});
    QVERIFY(document.selection().empty());
    QVERIFY(!document.is_modified());
    QVERIFY(window.settle());
    QCOMPARE(window.shown().request.scene->medium.size(), 4u);
    window.click(at);
    window.key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(document.selection(), (Ids{1, 3, 4, 5}));
    window.key(Qt::Key_E);
    window.drag(at - QPoint(60, 0), at + QPoint(60, 0));
    QCOMPARE(document.medium().densities()[1], 0.8);
    // The file gets all of it.
    QVERIFY(window->files().save_to(window.file("all.brume")));
    QCOMPARE(load_scene(window.file("all.brume")).medium.size(), 5u);
    window.key(Qt::Key_H, Qt::ShiftModifier);
    QVERIFY(document.hidden().empty());
    QVERIFY(window.settle());
    QCOMPARE(window.shown().request.scene->medium.size(), 5u);
  }

  void isolating_toggles_the_rest() {
    TestWindow window;
    Document& document = window->document();
    document.select({2, 3});
    window.key(Qt::Key_Slash);
    QCOMPARE(document.hidden(), (Ids{1, 4, 5}));
    QCOMPARE(document.selection(), (Ids{2, 3}));
    window.key(Qt::Key_Slash);
    QVERIFY(document.hidden().empty());
  }

  void locked_gaussians_are_visible_and_protected() {
    TestWindow window;
    Document& document = window->document();
    document.select({2});
    const QPoint at = window.handle(1);
    window.key(Qt::Key_K);
    QVERIFY(document.selection().empty());
    window.click(at);
    QVERIFY(document.selection().empty());
    window.key(Qt::Key_E);
    window.drag(at - QPoint(40, 0), at + QPoint(40, 0));  // past no other one
    QCOMPARE(document.medium().densities()[1], 0.8);
    QVERIFY(!document.is_modified());
    QCOMPARE(document.visible_snapshot()->medium.size(), 5u);
    window.key(Qt::Key_K, Qt::ShiftModifier);
    window.key(Qt::Key_V);
    window.click(at);
    QCOMPARE(document.selection(), Ids{2});
  }

  void copies_can_be_pasted_here_and_there() {
    TestWindow window;
    Document& document = window->document();
    const Scene before = document.scene();
    document.select({2, 3});
    window.key(Qt::Key_C, Qt::ControlModifier);
    window.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(last_step(document), "Paste 2 Gaussians");
    QCOMPARE(document.selection(), (Ids{6, 7}));
    QVERIFY(document.medium().gaussian(5) == before.medium.gaussian(1));
    QVERIFY(document.medium().gaussian(6) == before.medium.gaussian(2));
    window.key(Qt::Key_V, Qt::ControlModifier);  // somewhere in view, the two as they lie
    const glm::dvec3 shift = center(document, 7) - center(document, 5);
    QVERIFY(glm::distance(center(document, 8) - center(document, 6), shift) < 1e-12);
    window.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(last_step(document), "Duplicate 2 Gaussians");
    QCOMPARE(document.medium().size(), 11u);
    window.key(Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(last_step(document), "Cut 2 Gaussians");
    QVERIFY(is_undone(document, before));
    QCOMPARE(document.selection(), (Ids{2, 3}));
  }

  // Where the camera's target is below a floor, or the mouse points at the floor, what is pasted
  // lies on it.
  void a_paste_lands_in_view() {
    const TemporaryFolder folder;
    const std::filesystem::path mesh = folder / "floor.off";
    write_text(mesh, "OFF\n4 1 0\n-9 0 -9\n9 0 -9\n9 0 9\n-9 0 9\n4 3 2 1 0\n");
    Scene scene = small_scene();
    scene.camera.eye = {0.0, 3.0, 6.0};
    scene.camera.target = {0.0, -1.0, 0.0};
    scene.surfaces.emplace_back().mesh_file = mesh;
    TestWindow window(scene);
    Viewport& view = window->viewport();
    Document& document = window->document();
    document.select({2, 3});
    window.key(Qt::Key_C, Qt::ControlModifier);
    const auto check = [&](QPoint requested) {
      window.key(Qt::Key_V, Qt::ControlModifier);
      glm::dvec3 center(0.0);
      for (const GaussianId id : document.selection()) {
        const Gaussian pasted = document.medium().gaussian(*document.medium().index_of(id));
        QVERIFY2(pasted.center.y > 0.9 * pasted.radius,
                 qPrintable(QString::number(pasted.center.y)));
        center += 0.5 * pasted.center;
      }
      QVERIFY((film_position(view, center) - requested).manhattanLength() <= 3);
    };
    QTest::mouseMove(&*window, QPoint(5, 5));
    QTRY_VERIFY(!view.underMouse());
    check(view.rect().center());
    const QPoint low(view.width() / 3, view.height() - 40);
    QTest::mouseMove(&view, low);
    QTRY_VERIFY(view.underMouse());
    check(low);
  }

  void the_clipboard_keeps_every_digit_and_refuses_nonsense() {
    const std::vector<Gaussian> gaussians{{{0.1, -1.0 / 3.0, 1e12}, 1e-12, 0.0},
                                          {{1e-300, 2, 3}, 0.1 + 0.2, 7.7}};
    const QString text = gaussians_to_text(gaussians);
    QVERIFY(gaussians_from_text(text) == gaussians);
    for (const QString& bad :
         {QString(), QString("fog"), text + "1\t2\t3\t0\t1\n", text + "1\t2\t3\n",
          text + "1\t2\t3\tnan\t1\n", text + "1\t2\t3\t1\t-1\n"}) {
      QVERIFY_THROWS_EXCEPTION(InputError, gaussians_from_text(bad));
    }
  }

  void tables_of_other_programs_are_pasted() {
    const std::vector<Gaussian> gaussians{{{1, 2, 3}, 0.5, 4}, {{-1, 0, 0.25}, 2, 0}};
    for (const char* table :
         {"X\tY\tZ\tRadius\tDensity\n1\t2\t3\t0.5\t4\n-1\t0\t0.25\t2\t0\n",
          "1\t2\t3\t0.5\t4\n-1\t0\t0.25\t2\t0", "1,2,3,.5,4\r\n-1,0,.25,2,0\r\n",
          "1 2 3 0.5 4\n-1 0 0.25 2 0\n", "1;2;3;0,5;4\n-1;0;0,25;2;0\n",
          "density;radius;z;y;x\n4;0,5;3;2;1\n0;2;0,25;0;-1\n"}) {
      QVERIFY2(gaussians_from_text(table) == gaussians, table);
    }
    TestWindow window;
    const auto* bar = window->findChild<MessageBar*>();
    const auto message_for = [&](const char* text) {
      QGuiApplication::clipboard()->setText(text);
      window.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
      return bar->message();
    };
    QVERIFY(message_for("fog").startsWith("Nothing to paste: clipboard: line 1"));
    QVERIFY(message_for("1\t2\t3\t1\t1\n1\t2\t3\t-1\t1\n").contains("line 3, radius: found -1"));
    QVERIFY(!window->document().is_modified());
    message_for("1,2,3,.5,4\n");
    QCOMPARE(window->document().medium().size(), 6u);
  }

  void an_arrow_moves_along_its_axis() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({2, 3});
    desk.key(Qt::Key_G);
    const QPoint pivot = film_position(desk.view(), desk.view().pivot());
    desk.drag(pivot + QPoint(60, 0), pivot + QPoint(110, 30));
    QCOMPARE(last_step(document), "Move 2 Gaussians");
    QCOMPARE(step_count(document), 1);
    for (const std::size_t k : {1U, 2U}) {
      const glm::dvec3 moved = center(document, k) - before.medium.centers()[k];
      QVERIFY(moved.x > 0.1 && moved.y == 0.0 && moved.z == 0.0);
    }
    // The pivot went along with the mouse.
    QVERIFY(std::abs(film_position(desk.view(), desk.view().pivot()).x() - pivot.x() - 50) <= 1);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.scene() == before);
    // The ring in the middle, and all within it: across the view.
    for (const QPoint& start : {QPoint(0, 9), QPoint(0, 0)}) {
      desk.drag(pivot + start, pivot + QPoint(-40, 40));
      const glm::dvec3 moved = center(document, 1) - before.medium.centers()[1];
      QVERIFY(moved.x < -0.1 && moved.y < -0.1 && std::abs(moved.z) < 1e-12);
      desk.key(Qt::Key_Z, Qt::ControlModifier);
      QVERIFY(document.scene() == before);
    }
  }

  void a_ring_turns() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({1, 2, 3});
    desk.key(Qt::Key_R);
    const glm::dvec3 pivot = desk.view().pivot();
    const QPoint middle = film_position(desk.view(), pivot);
    // Around the view, a quarter of a turn counterclockwise.
    desk.drag(middle + QPoint(96, 0), middle + QPoint(0, -96));
    QCOMPARE(last_step(document), "Rotate 3 Gaussians");
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 was = before.medium.centers()[k] - pivot;
      const glm::dvec3 is = center(document, k) - pivot;
      QVERIFY(std::abs(glm::length(is) - glm::length(was)) < 1e-12);
      const glm::dvec3 axis = glm::normalize(document.scene().camera.eye - pivot);
      QVERIFY(std::abs(glm::dot(is, axis) - glm::dot(was, axis)) < 1e-12);
      const glm::dvec3 quarter = glm::cross(axis, was) + axis * glm::dot(axis, was);
      QVERIFY(glm::distance(is, quarter) < 0.02);
      QCOMPARE(document.medium().radii()[k], before.medium.radii()[k]);
    }
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(is_cancelled_by_escape(desk.view(), document, middle + QPoint(96, 0),
                                   middle + QPoint(70, 70)));
    QVERIFY(document.scene() == before);
  }

  void scaling_scales_radii_too() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({1, 2, 3});
    desk.key(Qt::Key_S);
    const glm::dvec3 pivot = desk.view().pivot();
    const QPoint middle = film_position(desk.view(), pivot);
    desk.drag(middle + QPoint(0, 10), middle + QPoint(0, 20));
    QCOMPARE(last_step(document), "Scale 3 Gaussians");
    for (std::size_t k = 0; k < 3; ++k) {
      const double factor = document.medium().radii()[k] / before.medium.radii()[k];
      QVERIFY(std::abs(factor - 2.0) < 0.1);
      QVERIFY(glm::distance(center(document, k) - pivot,
                            factor * (before.medium.centers()[k] - pivot)) < 1e-12);
    }
  }
};

BRUME_APP_SUITE("selection", SelectionTest)
#include "selection_test.moc"
