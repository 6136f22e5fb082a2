// Gaussians that are ellipsoids: outlined, stretched and turned, in tables, painted, copied.

#include <QLineEdit>
#include <QScopeGuard>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/commands/gaussians/clipboard.h"
#include "app/commands/gaussians/edit_groups.h"
#include "app/panels/gaussians/gaussian_filter.h"
#include "app/panels/gaussians/gaussian_histogram.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "app/tools/brushes/airbrush_tool.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/selection/transform_tool.h"
#include "app/tools/tool_box.h"
#include "app/view/camera/bounds.h"
#include "brume/error.h"
#include "tests/app/desk.h"
#include "tests/app/ellipsoids.h"
#include "tests/app/groups_window.h"
#include "tests/app/test_window.h"

using namespace brume;
using namespace brume::ellipsoids;

namespace {

QPoint pivot_on_film(Desk& desk) {
  return film_position(desk.view(), desk.view().pivot());
}

template <class Tool>
Tool& tool_of(Desk& desk) {
  for (const auto& entry : desk.tools().entries()) {
    if (auto* found = dynamic_cast<Tool*>(entry.tool.get())) return *found;
  }
  throw std::logic_error("no such tool");
}

}  // namespace

class EllipsoidsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void outlines_are_where_rays_touch() {
    Camera camera;
    camera.eye = {1.0, 2.0, 7.0};
    const CameraRays rays(camera, {640, 480});
    for (const Gaussian& shown :
         {Gaussian{.center = {0.5, 0.2, 0.0}, .radius = 0.7},
          ellipsoid({0.5, 0.2, 0.0}, {0.2, 1.5, 0.7}, {20.0, -40.0, 70.0}),
          ellipsoid({-1.0, 0.0, 1.0}, {2.0, 0.01, 0.3}, {0.0, 30.0, 0.0})}) {
      Overlay overlay;
      overlay.add_outline(rays, shown, qRgb(255, 255, 255));
      QVERIFY(overlay.lines.size() >= 24);
      const glm::dmat3 into_ball = warp(shown.shape);
      for (const Overlay::Vertex& vertex : overlay.lines) {
        const glm::dvec3 way = into_ball * rays.direction(static_cast<double>(vertex.x),
                                                          static_cast<double>(vertex.y));
        const glm::dvec3 center = into_ball * (shown.center - rays.eye());
        const double distance = glm::length(glm::cross(center, way)) / glm::length(way);
        QVERIFY(std::abs(distance / shown.radius - 1.0) < 2e-3);
      }
    }
    Overlay overlay;
    overlay.add_outline(rays, ellipsoid({1.0, 2.0, 6.0}, {0.1, 0.1, 1.5}, {}), qRgb(0, 0, 0));
    QVERIFY(overlay.lines.empty());  // the eye is inside
  }

  void framing_takes_the_true_extent() {
    Medium medium;
    const double angle = 30.0;
    medium.append(ellipsoid({1.0, 2.0, 3.0}, {2.0, 0.5, 0.5}, {0.0, 0.0, angle}));
    const Sphere sphere = *bounding_sphere(medium, medium.ids());
    const double c = std::cos(glm::radians(angle));
    const double s = std::sin(glm::radians(angle));
    const glm::dvec3 half(std::hypot(2.0 * c, 0.5 * s), std::hypot(2.0 * s, 0.5 * c), 0.5);
    QVERIFY(is_near(sphere.center, {1.0, 2.0, 3.0}));
    QVERIFY(std::abs(sphere.radius - glm::length(half)) < 1e-12);
  }

  void an_axis_of_the_scale_handle_makes_ellipsoids() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    document.select({1, 2, 3});
    desk.key(Qt::Key_S);
    const glm::dvec3 pivot = desk.view().pivot();
    const QPoint middle = pivot_on_film(desk);
    desk.drag(middle + QPoint(60, 0), middle + QPoint(90, 0));
    QCOMPARE(step_count(document), 1);
    QCOMPARE(last_step(document), "Scale 3 Gaussians");
    for (std::size_t k = 0; k < 3; ++k) {
      const Gaussian was = before.medium.gaussian(k);
      const Gaussian is = gaussian(document, k);
      const double factor = is.radii().x / was.radius;
      QVERIFY(std::abs(factor - 1.5) < 0.05);
      QVERIFY(is_near(is.radii(), was.radius * glm::dvec3(factor, 1.0, 1.0)));
      QVERIFY(is_near(is.center, pivot + glm::dvec3(factor, 1.0, 1.0) * (was.center - pivot)));
    }
    QVERIFY(gaussian(document, 3).is_ball());
    // Uniformly they keep their shape.
    const GaussianShape shape = gaussian(document, 1).shape;
    desk.drag(middle + QPoint(0, 10), middle + QPoint(0, 20));
    QCOMPARE(gaussian(document, 1).shape, shape);
    QVERIFY(gaussian(document, 1).radius > 1.8 * 1.5 * before.medium.radii()[1]);
    QVERIFY(is_undone(document, before));
    QVERIFY(is_cancelled_by_escape(desk.view(), document, middle + QPoint(60, 0),
                                   middle + QPoint(90, 0)));
  }

  // By a third of what the selected one does.
  void a_soft_selection_stretches_in_part() {
    Scene scene = small_scene();
    scene.medium = Medium();
    scene.medium.append({{0.0, 0.0, 0.0}, 0.4, 0.8});
    scene.medium.append({{0.0, 0.4, 0.0}, 0.4, 0.8});
    Desk desk(scene);
    Document& document = desk.document();
    document.select({1});
    desk.key(Qt::Key_S);
    enter(desk, "scale_soft", "1");
    const QPoint middle = pivot_on_film(desk);
    desk.drag(middle + QPoint(40, 0), middle + QPoint(80, 0));
    const double all = gaussian(document, 0).radii().x;
    const double part = gaussian(document, 1).radii().x;
    QVERIFY(all > 0.75 && part > 0.41 && part < all - 0.01);
    QVERIFY(std::abs(gaussian(document, 1).radii().y - 0.4) < 1e-12);
  }

  void a_ring_turns_ellipsoids() {
    const Scene before = scene_of_ellipsoids();
    Desk desk(before);
    Document& document = desk.document();
    document.select({2, 4});
    desk.key(Qt::Key_R);
    const glm::dvec3 pivot = desk.view().pivot();
    const QPoint middle = pivot_on_film(desk);
    desk.drag(middle + QPoint(96, 0), middle + QPoint(0, -96));
    const Gaussian was = before.medium.gaussian(1);
    const Gaussian is = gaussian(document, 1);
    // Its center and its axes alike.
    const glm::dmat3 turn =
        glm::mat3_cast(is.shape.rotation) * glm::transpose(glm::mat3_cast(was.shape.rotation));
    QVERIFY(is_near(is.center - pivot, turn * (was.center - pivot)));
    QCOMPARE(is.radii(), was.radii());
    QVERIFY(!is_near(is.center, was.center, 0.1));
    QCOMPARE(gaussian(document, 3).shape, GaussianShape());
  }

  void columns_filter_and_histogram() {
    const Scene before = scene_of_ellipsoids();
    Desk desk(before);
    Document& document = desk.document();
    QTableView* table = desk.findChild<GaussianPanel*>()->table();
    const auto column = [](GaussianAttribute field) {
      return static_cast<int>(std::ranges::find(gaussian_attributes, field) -
                              gaussian_attributes.begin());
    };
    const int elongation = column(GaussianAttribute::elongation);
    QVERIFY(table->isColumnHidden(elongation));
    QVERIFY(table->isColumnHidden(column(GaussianAttribute::rotation_y)));
    auto* chosen = desk.findChild<QAction*>("column_elongation");
    chosen->trigger();
    QVERIFY(!table->isColumnHidden(elongation));
    {
      Desk next(before);  // remembers it
      const QTableView* other = next.findChild<GaussianPanel*>()->table();
      QVERIFY(!other->isColumnHidden(elongation));
      QVERIFY(other->isColumnHidden(column(GaussianAttribute::rotation_y)));
    }
    const auto forget = qScopeGuard([&] { chosen->setChecked(false); });
    const auto text = [&](int row, int k) {
      return table->model()->index(row, k).data().toString();
    };
    QCOMPARE(text(0, elongation), "1");
    QCOMPARE(text(1, elongation), "3");
    QCOMPARE(text(1, column(GaussianAttribute::radius_x)), "0.3");
    QCOMPARE(text(1, column(GaussianAttribute::rotation_y)), "20");
    QCOMPARE(text(0, column(GaussianAttribute::rotation_y)), "0");
    const auto is_editable = [&](int k) {
      return table->model()->flags(table->model()->index(1, k)).testFlag(Qt::ItemIsEditable);
    };
    QVERIFY(!is_editable(elongation));
    QVERIFY(is_editable(column(GaussianAttribute::radius_z)));
    for (const GaussianAttribute angle :
         {GaussianAttribute::rotation_x, GaussianAttribute::rotation_y,
          GaussianAttribute::rotation_z}) {  // edited by the fields above
      const int k = column(angle);
      QVERIFY(!is_editable(k));
      QVERIFY(!table->model()->setData(table->model()->index(1, k), "130", Qt::EditRole));
    }
    QVERIFY(document.scene() == before);
    const QModelIndex cell = table->model()->index(1, column(GaussianAttribute::radius_x));
    QVERIFY(table->model()->setData(cell, "0.9", Qt::EditRole));
    QVERIFY(is_near(gaussian(document, 1).radii(), {0.9, 0.6, 0.2}));
    QVERIFY(is_turned(gaussian(document, 1), {10.0, 20.0, 30.0}));
    document.undo_stack().undo();
    table->sortByColumn(elongation, Qt::DescendingOrder);
    QCOMPARE(text(0, elongation), "3");
    table->sortByColumn(-1, Qt::AscendingOrder);
    auto* filter = desk.findChild<QLineEdit*>("gaussian_filter");
    const auto rows = [&](const char* condition) {
      filter->clear();
      QTest::keyClicks(filter, condition);
      return table->model()->rowCount();
    };
    QCOMPARE(rows("elongation > 1"), 2);
    QCOMPARE(rows("el > 2.9"), 1);
    QCOMPARE(rows("e > 1"), 0);  // the emission
    QCOMPARE(rows("centre x < 1e6"), rows("center x < 1e6"));
    QVERIFY(rows("centre x < 1e6") > 0 && rows("centre x > 1e6") == 0);
    QCOMPARE(rows("radius x = 0.3, radius y < 0.5"), 1);
    filter->clear();

    auto* histogram = desk.findChild<GaussianHistogram*>("histogram_elongation");
    QVERIFY(!histogram->isHidden());
    const auto at = [&](double position) {
      return QPointF(2.0 + position * (histogram->width() - 4), 10.0).toPoint();
    };
    drag_mouse(*histogram, at(0.5), at(1.0));
    QCOMPARE(document.selection(), (Ids{2, 3}));
    type_into(desk, "radius_x", "0.5");
    type_into(desk, "radius_y", "0.5");
    type_into(desk, "radius_z", "0.5");
    QVERIFY(histogram->isHidden());
    QVERIFY(is_undone(document, before));
    QVERIFY(!histogram->isHidden());
  }

  void a_brush_stretches_along_its_stroke() {
    Desk desk;
    Document& document = desk.document();
    desk.key(Qt::Key_B);
    auto& tool = tool_of<PaintbrushTool>(desk);
    tool.set_brush({.radius = 0.1, .density = 300.0, .spacing = 1.0, .scatter = 0.0});
    const QPoint from(300, 200);
    desk.drag(from, from + QPoint(200, 0));
    const std::size_t balls = document.medium().size() - 5;
    document.undo_stack().undo();
    enter(desk, "brush_stretch", "4");
    QCOMPARE(tool.brush().stretch, 4.0);
    desk.drag(from, from + QPoint(200, 0));
    const std::size_t painted = document.medium().size() - 5;
    QVERIFY(painted > 2 && painted <= balls / 4 + 1);
    for (std::size_t k = 6; k < document.medium().size(); ++k) {
      const Gaussian dab = document.medium().gaussian(k);
      QVERIFY(is_near(dab.radii(), {0.1, 0.1, 0.4}));
      // To the right on the view plane.
      QVERIFY(std::abs((dab.shape.rotation * glm::dvec3(0, 0, 1)).x) > 0.999);
    }
    // Alt and a click pick the brush from what it painted.
    const auto pick = [&](PaintbrushTool& brush, const glm::dvec3& center) {
      brush.set_brush({.radius = 7.0, .density = 1.0, .stretch = 2.0});
      QTest::mouseClick(&desk.view(), Qt::LeftButton, Qt::AltModifier,
                        film_position(desk.view(), center));
      return glm::dvec3(brush.brush().radius, brush.brush().density, brush.brush().stretch);
    };
    const Gaussian first = document.medium().gaussian(5);
    QVERIFY(first.is_ball());
    QVERIFY(is_near(pick(tool, document.medium().gaussian(7).center), {0.1, 300.0, 4.0}));
    // An ellipsoid that no stroke lays becomes the ball of its volume.
    document.undo_stack().undo();
    document.select({2});
    type_into(desk, "radius_x", "0.4");
    type_into(desk, "radius_z", "0.2");
    type_into(desk, "density", "5");
    desk.key(Qt::Key_B);
    QVERIFY(is_near(pick(tool, gaussian(document, 1).center),
                    {gaussian(document, 1).mean_radius(), 5.0, 2.0}));
    // One that is longer than the brush can lay.
    for (const char* field : {"radius_y", "radius_z"}) type_into(desk, field, "0.01");
    desk.key(Qt::Key_B);
    QVERIFY(is_near(pick(tool, gaussian(document, 1).center), {0.01, 5.0, 5.0}));
    document.undo_stack().setIndex(0);
    tool.set_brush({.stretch = 4.0});
    // Saved with the brush, and back.
    const BrushPreset preset = tool.preset();
    QCOMPARE(preset.stretch, 4.0);
    tool.set_brush({});
    tool.apply_preset(preset);
    QCOMPARE(tool.brush().stretch, 4.0);
  }

  void shapes_survive_the_clipboard_and_duplicates() {
    const Scene before = scene_of_ellipsoids();
    TestWindow window(before);
    Document& document = window->document();
    Gaussian shining = ellipsoid({1.0 / 3.0, 0.1, 0.0}, {0.1, 0.7 / 3.0, 0.3}, {1.0, 2.0, 3.0});
    shining.optics = {glm::dvec3(0.5, 0.25, 1.0), {0.0, 1.0, 2.0}};
    const std::vector<Gaussian> gaussians{shining, before.medium.gaussian(0),
                                          before.medium.gaussian(1)};
    const QString text = gaussians_to_text(gaussians);
    QVERIFY(gaussians_from_text(text) == gaussians);
    QString bad = text;
    QVERIFY_THROWS_EXCEPTION(InputError, gaussians_from_text(bad.replace("\t1\t", "\t2\t")));
    bad = text;
    QVERIFY_THROWS_EXCEPTION(InputError, gaussians_from_text(bad.replace("0.25", "1.25")));

    document.select({2, 3, 4});
    window.key(Qt::Key_C, Qt::ControlModifier);
    window.key(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(last_step(document), "Paste 3 Gaussians");
    for (const std::size_t k : {0U, 1U, 2U}) {
      QCOMPARE(gaussian(document, 5 + k), before.medium.gaussian(1 + k));
    }
    window.key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(document.medium().size(), 11u);
    for (const std::size_t k : {0U, 1U, 2U}) {
      QCOMPARE(gaussian(document, 8 + k).shape, before.medium.gaussian(1 + k).shape);
    }
    QVERIFY(is_undone(document, before));
  }

  void factors_of_groups_keep_shapes() {
    GroupsWindow desk;
    select_gaussians(desk.document(), {1, 2});
    type_into(desk, "radius_z", "0.9");
    desk.group({1, 2});
    desk.click("Group");
    const Medium plain = desk.document().medium();
    enter(desk, "group_radius_factor", "2");
    const Medium shown = desk.shown_medium();
    for (const std::size_t k : {0U, 1U}) {
      QVERIFY(is_near(shown.gaussian(k).radii(), 2.0 * plain.gaussian(k).radii()));
      QCOMPARE(shown.shape(k), plain.shape(k));
    }
  }
};

BRUME_APP_SUITE("ellipsoids", EllipsoidsTest)
#include "ellipsoids_test.moc"
