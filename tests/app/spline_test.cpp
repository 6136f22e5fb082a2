// The spline brush, and moves with a soft selection and with snapping.

#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <cmath>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/edit_splines.h"
#include "app/tools/brushes/spline_tool.h"
#include "app/tools/tool_box.h"
#include "app/viewport/viewport.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

Scene scene_without_fog() {
  Scene scene = small_scene();
  scene.medium = {};
  return scene;
}

class SplineDesk : public Desk {
 public:
  SplineDesk() : Desk(scene_without_fog()) {}
};

}  // namespace

class SplineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_soft_move_takes_near_fog_along() {
    SplineDesk desk;
    Document& document = desk.document();
    for (int k = 0; k < 6; ++k) {
      add_gaussian(document, {.center = {0.3 * k, 0.0, 0.0}, .radius = 0.2, .density = 1.0});
    }
    const Scene before = document.scene();
    document.select({before.medium.ids()[0]});
    document.lock({before.medium.ids()[2]});
    desk.key(Qt::Key_G);
    enter(desk, "move_soft", "1");
    const QPoint pivot = film_position(desk.view(), desk.view().pivot());
    const auto steps = step_count(document);
    desk.drag(pivot + QPoint(0, 9), pivot + QPoint(0, 69));
    QCOMPARE(step_count(document), steps + 1);
    const auto moved = [&](std::size_t k) {
      return document.medium().centers()[k].y - before.medium.centers()[k].y;
    };
    QVERIFY(moved(0) < -0.2);
    const auto weight = [](double t) { return (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t); };
    QVERIFY(std::abs(moved(1) / moved(0) - weight(0.3)) < 1e-6);
    QCOMPARE(moved(2), 0.0);  // locked
    QVERIFY(std::abs(moved(3) / moved(0) - weight(0.9)) < 1e-6);
    QCOMPARE(moved(4), 0.0);
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    enter(desk, "move_soft", "0");
    desk.drag(pivot + QPoint(0, 9), pivot + QPoint(0, 69));
    QCOMPARE(moved(1), 0.0);
    QCOMPARE(last_step(document), "Move 1 Gaussian");
  }

  void moves_snap_to_a_grid() {
    SplineDesk desk;
    Document& document = desk.document();
    add_gaussian(document, {.center = {0.1, 0.2, 0.3}, .radius = 0.2, .density = 1.0});
    document.select({document.medium().ids()[0]});
    desk.key(Qt::Key_G);
    choose(desk, "move_snap", 2);
    enter(desk, "move_grid", "0.5");
    const QPoint pivot = film_position(desk.view(), desk.view().pivot());
    desk.drag(pivot + QPoint(60, 0), pivot + QPoint(150, 0));  // along x only
    const glm::dvec3 center = document.medium().centers()[0];
    QVERIFY(center.x > 0.4 && std::abs(std::remainder(center.x, 0.5)) < 1e-9);
    QCOMPARE(center.y, 0.2);
    QCOMPARE(center.z, 0.3);
  }

  void a_spline_stays_editable() {
    SplineDesk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    desk.key(Qt::Key_B, Qt::ShiftModifier);
    auto& tool = dynamic_cast<SplineTool&>(desk.tools().tool());
    const QPoint center = desk.view().rect().center();
    const auto click = [&](QPoint at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
      desk.click(at, modifiers);
    };
    click(center - QPoint(150, 0));
    click(center);
    click(center + QPoint(150, 0));
    QCOMPARE(tool.spline().points.size(), 3u);
    QCOMPARE(step_count(document), 3);
    const Medium straight = document.medium();
    const std::vector<glm::dvec3> points = tool.spline().points;
    QVERIFY(straight.size() > 5);

    // The point in the middle, down: one step, and undo takes the point back as well.
    desk.drag(center, center + QPoint(0, 90));
    QCOMPARE(step_count(document), 4);
    QCOMPARE(last_step(document), "Move point of spline");
    QVERIFY(tool.spline().points[1].y < -0.5);
    double lowest = 0.0;
    for (const glm::dvec3& at : document.medium().centers()) lowest = std::min(lowest, at.y);
    QVERIFY(lowest < -0.5);
    document.undo_stack().undo();
    QVERIFY(tool.spline().points == points);
    QVERIFY(document.medium() == straight);
    document.undo_stack().redo();
    QVERIFY(tool.spline().points[1].y < -0.5);

    // A change of the brush repaints it, as one step of all in a row.
    enter(desk, "spline_radius", "0.1");
    enter(desk, "spline_density", "2");
    QCOMPARE(step_count(document), 5);
    for (std::size_t k = 0; k < document.medium().size(); ++k) {
      QCOMPARE(document.medium().gaussian(k).radius, 0.1);
      QCOMPARE(document.medium().gaussian(k).density, 2.0);
    }
    enter(desk, "spline_smoothing", "10");  // which changes nothing of it
    QCOMPARE(step_count(document), 5);

    click(center + QPoint(0, 90), Qt::ControlModifier);
    QCOMPARE(tool.spline().points.size(), 2u);
    QCOMPARE(last_step(document), "Remove point of spline");

    // Gaussians deleted meanwhile are painted again; Escape takes a drag back.
    document.select({document.medium().ids()[1]});
    delete_selection(document, "Delete");
    const Medium deleted = document.medium();
    const QPoint end = center + QPoint(150, 0);
    desk.press(end);
    desk.move(end + QPoint(0, 40));
    QVERIFY(document.medium().size() >= deleted.size());
    QTest::keyClick(&desk.view(), Qt::Key_Escape);
    desk.release(end);
    QVERIFY(tool.spline().points[1] == points[2]);

    // New leaves it; the next click begins another.
    const std::size_t count = document.medium().size();
    brume::click(desk, "spline_new");
    QVERIFY(tool.spline().points.empty());
    click(center + QPoint(0, 120));
    QCOMPARE(tool.spline().points.size(), 1u);
    QCOMPARE(document.medium().size(), count + 1);
    QVERIFY(is_undone(document, before));
    while (document.undo_stack().canRedo()) document.undo_stack().redo();
    QCOMPARE(document.medium().size(), count + 1);
  }

  // Its points are in the scene, not in the tool: by the file, and in the outliner.
  void a_saved_spline_is_edited_again() {
    SplineDesk desk;
    desk.key(Qt::Key_B, Qt::ShiftModifier);
    const QPoint center = desk.view().rect().center();
    enter(desk, "spline_radius", "0.2");
    enter(desk, "spline_density", "3");
    desk.click(center - QPoint(120, 0));
    desk.click(center + QPoint(120, 0));
    const PaintedSpline painted = desk.scene().splines.at(0);
    QVERIFY(painted.gaussians.size() > 5);
    desk.document().save(desk.file("spline.brume"));

    TestWindow later(scene_without_fog());
    Document& document = later->document();
    document.open(load_document(desk.file("spline.brume")), {});
    const Scene opened = document.scene();
    QVERIFY(later->tools().active() == 0);
    auto* tree = later->findChild<QTreeWidget*>("outliner_tree");
    QTreeWidgetItem* row =
        tree->findItems("Spline", Qt::MatchExactly | Qt::MatchRecursive).value(0);
    QVERIFY(row);
    tree->scrollToItem(row);
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(row).center());
    auto* tool = dynamic_cast<SplineTool*>(&later->tools().tool());
    QVERIFY(tool);
    QVERIFY(tool->spline().points == painted.points);
    QVERIFY(tool->brush() == painted.brush);
    QVERIFY(!document.is_modified());  // looking at it is no edit

    // Exactly its own Gaussians are painted again.
    const QPoint at = film_position(later->viewport(), painted.points[1]);
    later.drag(at, at + QPoint(0, 80));
    QCOMPARE(last_step(document), "Move point of spline");
    QVERIFY(tool->spline().points[1].y < painted.points[1].y - 0.3);
    QVERIFY(document.medium().centers().back().y < opened.medium.centers().back().y - 0.1);
    QCOMPARE(document.medium().radii().front(), 0.2);
    document.undo_stack().undo();
    QVERIFY(document.scene() == opened);

    // Undo of a change of the brush gives the tool's back, too.
    enter(later, "spline_density", "5");
    QCOMPARE(document.scene().splines[0].brush.density, 5.0);
    document.undo_stack().undo();
    QCOMPARE(tool->brush().density, 3.0);
    QVERIFY(document.scene() == opened);
  }

  void splines_are_renamed_and_deleted_in_the_outliner() {
    SplineDesk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_B, Qt::ShiftModifier);
    const QPoint center = desk.view().rect().center();
    desk.click(center);
    const Scene painted = document.scene();
    auto* tree = desk.findChild<QTreeWidget*>("outliner_tree");
    const auto row = [&](const QString& name) {
      return tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive).value(0);
    };
    tree->setCurrentItem(row("Spline"));
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_F2);
    auto* editor = tree->findChild<QLineEdit*>("row_name");
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "Trail");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(row("Trail"));
    QCOMPARE(last_step(document), "Rename Spline to Trail");
    tree->setCurrentItem(row("Trail"));
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Delete);
    QVERIFY(document.scene().splines.empty() && document.medium().empty());
    QVERIFY(!row("Trail"));
    document.undo_stack().undo();
    QVERIFY(row("Trail"));
    QVERIFY(document.medium() == painted.medium);
    release_spline(document, document.scene().splines[0].id);
    QVERIFY(document.scene().splines.empty() && document.medium() == painted.medium);
    while (document.undo_stack().canUndo()) document.undo_stack().undo();
    QVERIFY(document.scene() == scene_without_fog() || document.medium().empty());
  }

  // Fog that was put into a group stays there when its spline is painted again.
  void a_repainted_spline_stays_in_its_group() {
    SplineDesk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_B, Qt::ShiftModifier);
    const QPoint center = desk.view().rect().center();
    desk.click(center);
    document.select({document.medium().ids()[0]});
    group_selection(document);
    const GroupId group = document.scene().groups[0].id;
    document.set_active_group(0);
    desk.click(center + QPoint(150, 0));
    QVERIFY(document.medium().size() > 3);
    for (std::size_t k = 0; k < document.medium().size(); ++k) {
      QCOMPARE(document.medium().group(k), group);
    }
  }

  void another_scene_ends_a_spline() {
    SplineDesk desk;
    desk.key(Qt::Key_B, Qt::ShiftModifier);
    auto& tool = dynamic_cast<SplineTool&>(desk.tools().tool());
    desk.click(desk.view().rect().center());
    QVERIFY(!tool.spline().points.empty());
    desk.document().create();
    QVERIFY(tool.spline().points.empty());
    QVERIFY(desk.document().medium().empty());
    QVERIFY(!desk.document().is_modified());
  }
};

BRUME_APP_SUITE("spline", SplineTest)
#include "spline_test.moc"
