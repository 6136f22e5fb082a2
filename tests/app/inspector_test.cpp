// The Gaussians in numbers: sorted, filtered, as histograms, and at the cursor.

#include <QLabel>
#include <QLineEdit>
#include <glm/geometric.hpp>

#include "app/panels/gaussians/gaussian_filter.h"
#include "app/panels/gaussians/gaussian_histogram.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "app/panels/plots/contribution_panel.h"
#include "app/widgets/number_field.h"
#include "tests/app/desk.h"
#include "tests/app/gaussian_table.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

std::vector<double> column(QTableView* table, int k) {
  std::vector<double> values;
  for (int row = 0; row < table->model()->rowCount(); ++row) {
    values.push_back(table->model()->index(row, k).data(Qt::EditRole).toString().toDouble());
  }
  return values;
}

// From one position along its axis to another.
void drag_in(GaussianHistogram& histogram, double from, double to,
             Qt::KeyboardModifiers modifiers = {}) {
  const auto at = [&](double position) {
    return QPointF(2.0 + position * (histogram.width() - 4), 10.0);
  };
  drag_mouse(histogram, at(from), at(to), Qt::LeftButton, modifiers);
}

ContributionPanel& cursor_panel(TestWindow& window) {
  auto* panel = window->findChild<ContributionPanel*>();
  auto* dock = qobject_cast<QWidget*>(panel->parent());
  dock->show();
  dock->raise();
  return *panel;
}

std::vector<double> radii_of(const Document& document) {
  return {document.medium().radii().begin(), document.medium().radii().end()};
}

}  // namespace

class InspectorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void filters_report_errors() {
    const Gaussian gaussian{{1.0, -2.0, 3.0}, 0.5, 0.2};
    const auto passes = [&](const QString& text) {
      QString problem;
      const auto filter = GaussianFilter::parse(text, problem);
      if (!filter) throw problem;
      return filter->passes(gaussian);
    };
    for (const char* text : {"", "density > 0.1", "Radius<=0.5, x = 1", "d>0.1 and r<1 ; y < 0",
                             "z>=3", "rad > 4e-1"}) {
      QVERIFY2(passes(text), text);
    }
    for (const char* text : {"density > 0.2", "radius < 0.5", "x=2", "z>=3, y>0"}) {
      QVERIFY2(!passes(text), text);
    }
    for (const char* text : {"dense", "density >", "> 2", "density > much", "q < 2", "radius 2"}) {
      QString problem;
      QVERIFY2(!GaussianFilter::parse(text, problem), text);
      QVERIFY(!problem.isEmpty());
    }
    const auto problem_of = [](const char* text) {
      QString problem;
      GaussianFilter::parse(text, problem);
      return problem;
    };
    QVERIFY(problem_of("dense").contains("lacks a comparison"));
    QVERIFY(problem_of("density >").contains("lacks what it is compared with"));
    QVERIFY(problem_of("x > 0, density > much").contains("“much” is no number"));
    QVERIFY(problem_of("q < 2").contains("“q” is no attribute; allowed are x, y"));
    QVERIFY(problem_of("group < steam").contains("compared by ="));
    Gaussian grouped = gaussian;
    grouped.group = 2;
    const std::vector<Group> groups{{.id = 1, .name = "Pot"},
                                    {.id = 2, .name = "Steam", .parent = 1}};
    const auto passes_group = [&](const char* text, const Gaussian& of) {
      QString problem;
      return GaussianFilter::parse(text, problem)->passes(of, groups);
    };
    QVERIFY(passes_group("group = steam", grouped) && passes_group("g=Pot, r < 1", grouped));
    QVERIFY(!passes_group("group = none", grouped) && !passes_group("group = fog", grouped));
    QVERIFY(passes_group("group = none", gaussian) && !passes_group("group=steam", gaussian));
  }

  void a_click_on_a_header_sorts() {
    Desk desk;
    Document& document = desk.document();
    QTableView* table = table_of(desk);
    const auto sorted = [](std::vector<double> values) {
      std::sort(values.begin(), values.end());
      return values;
    };
    const std::vector<double> unsorted = radii_of(document);
    QCOMPARE(column(table, 3), unsorted);
    click_header(table, 3);
    QCOMPARE(column(table, 3), sorted(unsorted));
    // The selection is the same in any order, and an edit goes to the right Gaussian.
    table->selectRow(0);
    const auto min_value = std::min_element(unsorted.begin(), unsorted.end()) - unsorted.begin();
    QCOMPARE(document.selection(),
             std::vector<GaussianId>{document.medium().ids()[static_cast<std::size_t>(min_value)]});
    QVERIFY(table->model()->setData(table->model()->index(0, 3), "3.5"));
    QCOMPARE(document.medium().radii()[static_cast<std::size_t>(min_value)], 3.5);
    QCOMPARE(column(table, 3).back(), 3.5);
    QCOMPARE(document.selection().size(), 1u);
    document.undo_stack().undo();
    QCOMPARE(column(table, 3), sorted(unsorted));
    click_header(table, 3);
    QVERIFY(column(table, 3).front() >= column(table, 3).back());
    click_header(table, 3);  // as they came
    QCOMPARE(column(table, 3), unsorted);
  }

  void a_typed_value_moves_its_row_and_the_current_cell_with_it() {
    Desk desk;
    Document& document = desk.document();
    QTableView* table = table_of(desk);
    click_header(table, 3);
    const auto id_of_row = [&](int row) {
      auto* model = qobject_cast<GaussianTableModel*>(table->model());
      return model->id(row);
    };
    const GaussianId first = id_of_row(0);
    const QPoint cell = table->visualRect(table->model()->index(0, 3)).center();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell);
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, cell);
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "3.5");
    QTest::keyClick(editor, Qt::Key_Return);
    const auto radius_of_first = [&] {
      return document.medium().radii()[*document.medium().index_of(first)];
    };
    QTRY_COMPARE(radius_of_first(), 3.5);
    const int last = table->model()->rowCount() - 1;
    QTRY_COMPARE(id_of_row(last), first);
    QCOMPARE(document.selection(), std::vector<GaussianId>{first});
    QCOMPARE(table->currentIndex(), table->model()->index(last, 3));
    QVERIFY(!table->isPersistentEditorOpen(table->currentIndex()));
    // Tab goes on to the density, in the row's new place.
    QTest::keyClick(table->viewport(), Qt::Key_F2);
    editor = table->viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, "0.01");
    QTest::keyClick(editor, Qt::Key_Tab);
    QTRY_COMPARE(radius_of_first(), 0.01);
    QTRY_COMPARE(id_of_row(0), first);
    QTRY_COMPARE(table->currentIndex(), table->model()->index(0, 4));
    QVERIFY(table->isPersistentEditorOpen(table->currentIndex()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTRY_VERIFY(!table->isPersistentEditorOpen(table->currentIndex()));
    document.undo_stack().undo();
    document.undo_stack().undo();
    QCOMPARE(table->currentIndex(), table->model()->index(0, 4));
    // Deleted rows go from the middle of a sorted table.
    delete_selection(document, "Delete");
    QCOMPARE(table->model()->rowCount(), last);
    document.undo_stack().undo();
    QCOMPARE(id_of_row(0), first);
  }

  void a_filter_shows_some() {
    Desk desk;
    Document& document = desk.document();
    QTableView* table = table_of(desk);
    document.select({1, 2});
    set_filter(desk, "radius < 0.4");
    for (const double radius : column(table, 3)) QVERIFY(radius < 0.4);
    const auto all = radii_of(document);
    const auto expected = std::count_if(all.begin(), all.end(), [](double r) { return r < 0.4; });
    QVERIFY(expected > 0 && expected < 5);
    QCOMPARE(table->model()->rowCount(), static_cast<int>(expected));
    QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 2}));
    // A Gaussian edited out of the range goes, and comes back.
    QVERIFY(table->model()->setData(table->model()->index(0, 3), "2"));
    QVERIFY(table->model()->rowCount() < static_cast<int>(expected));
    document.undo_stack().undo();
    QCOMPARE(table->model()->rowCount(), static_cast<int>(expected));
    // A text that is none changes nothing.
    auto* filter = desk.findChild<QLineEdit*>("gaussian_filter");
    QTest::keyClicks(filter, " quatsch");
    QVERIFY(desk.findChild<QLabel*>("filter_count")->text().contains("quatsch"));
    QCOMPARE(table->model()->rowCount(), static_cast<int>(expected));
    table->selectAll();
    QCOMPARE(document.selection().size(), static_cast<std::size_t>(expected));
    set_filter(desk, "");
    QCOMPARE(table->model()->rowCount(), 5);
  }

  void mixed_values_are_written_in_one_step() {
    Desk desk;
    Document& document = desk.document();
    auto* radius = desk.findChild<NumberField*>("radius");
    auto* density = desk.findChild<NumberField*>("density");
    QVERIFY(!radius->isEnabled());
    document.select({1, 2, 5});
    QCOMPARE(radius->text(), "");
    QCOMPARE(radius->placeholderText(), "mixed");
    QCOMPARE(density->text(), "0.8");
    radius->setFocus();
    QTest::keyClicks(radius, "0.7");
    QTest::keyClick(radius, Qt::Key_Return);
    for (const std::size_t k : {0U, 1U, 4U}) QCOMPARE(document.medium().radii()[k], 0.7);
    QVERIFY(document.medium().radii()[2] != 0.7);
    QCOMPARE(step_count(document), 1);
    QCOMPARE(radius->text(), "0.7");
    document.select({});
    QVERIFY(radius->placeholderText() != "mixed");
  }

  void changes_act_on_each_of_mixed_values() {
    Desk desk;
    Document& document = desk.document();
    const std::vector<double> before(document.medium().radii().begin(),
                                     document.medium().radii().end());
    auto* radius = desk.findChild<NumberField*>("radius");
    const auto type = [&](const QString& text) {
      radius->selectAll();
      QTest::keyClicks(radius, text);
      QTest::keyClick(radius, Qt::Key_Return);
    };
    document.select({1, 2, 5});
    QCOMPARE(radius->placeholderText(), "mixed");
    type("*2");
    QCOMPARE(last_step(document), "Change radius of 3 Gaussians");
    type("+0.5");
    type("/4");
    type("-=1/8");
    QCOMPARE(step_count(document), 4);
    for (const std::size_t k : {0U, 1U, 4U}) {
      QVERIFY(std::abs(document.medium().radii()[k] - before[k] / 2.0) < 1e-12);
    }
    QCOMPARE(document.medium().radii()[2], before[2]);
    type("*nonsense");
    QCOMPARE(step_count(document), 4);
    type("-=100");  // no radius is negative
    for (const double r : document.medium().radii()) QVERIFY(r > 0.0);
    document.undo_stack().setIndex(0);
    // The field changes a single value.
    document.select({1});
    type("*3");
    QCOMPARE(document.medium().radii()[0], 3.0 * before[0]);
    type("/0");
    QCOMPARE(document.medium().radii()[0], 3.0 * before[0]);
  }

  void a_drag_in_a_histogram_selects_a_range() {
    Desk desk;
    Document& document = desk.document();
    auto* histogram = desk.findChild<GaussianHistogram*>("histogram_radius");
    const auto axis = histogram->axis();
    const auto radii = radii_of(document);
    QCOMPARE(axis.low, *std::min_element(radii.begin(), radii.end()));
    QCOMPARE(axis.high, *std::max_element(radii.begin(), radii.end()));
    const auto in_range = [&](double low, double high) {
      std::vector<GaussianId> ids;
      for (std::size_t k = 0; k < radii.size(); ++k) {
        if (radii[k] >= low && radii[k] <= high) ids.push_back(document.medium().ids()[k]);
      }
      return ids;
    };
    // No Gaussian lies within a pixel of this.
    drag_in(*histogram, 0.45, 1.2);
    const auto upper = in_range(axis.at(0.45), axis.high);
    QVERIFY(!upper.empty() && upper.size() < 5);
    QCOMPARE(document.selection(), upper);
    QCOMPARE(step_count(document), 1);
    QVERIFY(!document.is_modified());
    drag_in(*histogram, 0.3, -0.1, Qt::ShiftModifier);
    QVERIFY(document.selection().size() > upper.size());
    drag_in(*histogram, 0.45, 1.2, Qt::ControlModifier);
    QCOMPARE(document.selection(), in_range(axis.low, axis.at(0.3)));
    document.undo_stack().setIndex(1);
    QCOMPARE(document.selection(), upper);
    document.undo_stack().setIndex(0);
    QVERIFY(document.selection().empty());
  }

  void albedo_and_emission_have_columns_filters_and_histograms() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    QTableView* table = table_of(desk);
    auto* albedo = desk.findChild<GaussianHistogram*>("histogram_albedo");
    auto* emission = desk.findChild<GaussianHistogram*>("histogram_emission");
    QVERIFY(!albedo->isVisible() && !emission->isVisible());
    const auto cell = [&](int row, int k, int role) {
      return table->model()->index(row, k).data(role);
    };
    QVERIFY(!cell(1, 5, Qt::DecorationRole).isValid());
    QVERIFY(cell(1, 5, Qt::ToolTipRole).toString().contains("medium"));

    // Typed into a cell, an albedo is grey.
    document.select({2});
    QVERIFY(table->model()->setData(table->model()->index(1, 5), "0.25"));
    QCOMPARE(last_step(document), "Set albedo of 1 Gaussian to 0.25");
    QVERIFY(!table->model()->setData(table->model()->index(1, 5), "1.5"));
    QVERIFY(!table->model()->setData(table->model()->index(1, 5), "0"));
    QCOMPARE(document.medium().optics(1).albedo, std::optional(glm::dvec3(0.25)));
    enter(desk, "gaussian_emission", "4");
    QVERIFY(albedo->isVisible() && emission->isVisible());
    QCOMPARE(column(table, 5), (std::vector<double>{1.0, 0.25, 1.0, 1.0, 1.0}));
    QCOMPARE(column(table, 6), (std::vector<double>{0.0, 4.0, 0.0, 0.0, 0.0}));
    const QImage swatch = cell(1, 6, Qt::DecorationRole).value<QPixmap>().toImage();
    QCOMPARE(swatch.pixelColor(4, 6), QColor(Qt::white));
    QCOMPARE(cell(1, 5, Qt::ToolTipRole).toString(), "0.25, 0.25, 0.25");
    QVERIFY(!cell(0, 6, Qt::DecorationRole).isValid());
    click_header(table, 5);
    QCOMPARE(column(table, 5).front(), 0.25);
    click_header(table, 5);
    QCOMPARE(column(table, 5).back(), 0.25);
    drag_in(*emission, 0.5, 1.2);
    QCOMPARE(document.selection(), std::vector<GaussianId>{2});

    // The others follow the medium's albedo.
    set_filter(desk, "albedo < 0.5");
    QCOMPARE(table->model()->rowCount(), 1);
    for (const char* field : {"albedo_x", "albedo_y", "albedo_z"}) enter(desk, field, "0.2");
    QCOMPARE(table->model()->rowCount(), 5);
    QCOMPARE(column(table, 5), (std::vector<double>{0.25, 0.2, 0.2, 0.2, 0.2}));
    QCOMPARE(albedo->axis().low, 0.2);
    QCOMPARE(albedo->axis().high, 0.25);
    drag_in(*albedo, 0.5, -0.1);
    QCOMPARE(document.selection(), (std::vector<GaussianId>{1, 3, 4, 5}));
    QVERIFY(document.is_modified());
    QVERIFY(is_undone(document, before));
    QVERIFY(!document.is_modified());
    QVERIFY(!albedo->isVisible() && !emission->isVisible());
    QCOMPARE(table->model()->rowCount(), 0);
  }

  void far_apart_values_are_spread_by_factors() {
    const GaussianHistogram::Axis axis(0.01, 10.0);
    QVERIFY(axis.logarithmic);
    QVERIFY(std::abs(axis.position(0.1) - 1.0 / 3.0) < 1e-12);
    QVERIFY(std::abs(axis.at(axis.position(0.37)) - 0.37) < 1e-12);
    QVERIFY(!GaussianHistogram::Axis(0.0, 10.0).logarithmic);
    QCOMPARE(GaussianHistogram::Axis(2.0, 2.0).position(2.0), 0.5);
  }

  void cursor_panel_matches_the_pixel() {
    TestWindow window;
    Document& document = window->document();
    Viewport& view = window->viewport();
    ContributionPanel* panel = &cursor_panel(window);
    QTRY_VERIFY(panel->isVisible());
    QVERIFY(!panel->facts());
    QTest::mouseMove(&view, window.handle(1));
    QTRY_VERIFY(panel->facts());
    QCOMPARE(panel->facts()->id, GaussianId{2});
    const auto& facts = *panel->facts();
    QVERIFY(facts.contribution.fraction > 0.1);
    QCOMPARE(facts.lights.size(), 1u);
    // Alone on its ray, it is all the airlight of the pixel, but for where in it the light is
    // taken.
    const Frame& frame = view.frames().shown()->frame;
    const QPoint at = window.handle(1);
    const auto pixel = static_cast<std::size_t>(at.y() * frame.film.width + at.x());
    for (int c = 0; c < 3; ++c) {
      const double shown = frame.airlight[3 * pixel + static_cast<std::size_t>(c)];
      QVERIFY2(std::abs(facts.lights[0].radiance[c] - shown) < 0.2 * shown,
               qPrintable(QString("%1 %2").arg(facts.lights[0].radiance[c]).arg(shown)));
    }
    // A selected one comes first, if the ray meets it; a click on another selects that.
    const QPoint between = (window.handle(0) + window.handle(4)) / 2;
    QTest::mouseMove(&view, between);
    QTRY_VERIFY(panel->facts() && panel->facts()->met.size() >= 2);
    const auto last = panel->facts()->met.back().first;
    document.select({last});
    QTRY_COMPARE(panel->facts()->id, last);
    QTest::mouseMove(&view, QPoint(3, 3));
    QTRY_VERIFY(!panel->facts());
  }

  void cursor_panel_shows_what_shines() {
    Scene scene = small_scene();
    scene.lights[0].on = false;
    std::size_t index = 0;
    scene.medium = scene.medium.changed(0.0, [&](Gaussian gaussian) {
      if (index++ == 1) gaussian.optics = {glm::dvec3(0.5, 0.25, 0.5), {0.0, 6.0, 0.0}};
      return gaussian;
    });
    TestWindow window(scene);
    ContributionPanel& panel = cursor_panel(window);
    QTRY_VERIFY(panel.isVisible());
    const QPoint at = window.handle(1);
    QTest::mouseMove(&window->viewport(), at);
    QTRY_VERIFY(panel.facts());
    const Contribution& contribution = panel.facts()->contribution;
    QCOMPARE(contribution.optical_depth.g, 2.0 * contribution.optical_depth.r);
    // Alone on its ray, and all the airlight of the pixel.
    const Frame& frame = window.shown().frame;
    const auto pixel = static_cast<std::size_t>(at.y() * frame.film.width + at.x());
    const double shown = frame.airlight[3 * pixel + 1];
    QVERIFY(shown > 1.0);
    QVERIFY2(std::abs(contribution.emitted.g - shown) < 0.02 * shown,
             qPrintable(QString("%1 %2").arg(contribution.emitted.g).arg(shown)));
    // Its bar is of its colour.
    const QImage picture = panel.grab().toImage();
    bool has_green = false;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        has_green = has_green || picture.pixelColor(x, y) == QColor(0, 255, 0);
      }
    }
    QVERIFY(has_green);
  }
};

BRUME_APP_SUITE("inspector", InspectorTest)
#include "inspector_test.moc"
