// Gaussians that are asked for: what the table's filter shows is selected, grouped and exported.

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/panels/gaussians/gaussian_table_model.h"
#include "tests/app/desk.h"
#include "tests/app/gaussian_table.h"
#include "tests/app/test_window.h"

using namespace brume;

using Ids = std::vector<GaussianId>;

class QueryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void what_is_shown_is_counted_selected_and_saved_as_a_group() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    QTableView* table = table_of(desk);
    auto* count = desk.findChild<QLabel*>("filter_count");
    auto* select = desk.findChild<QPushButton*>("select_shown");
    auto* group = desk.findChild<QPushButton*>("save_as_group");
    QVERIFY(!count->isVisible() && !select->isVisible());
    set_filter(desk, "id > 2, id <= 4");
    QCOMPARE(count->text(), "2 of 5");
    QVERIFY(count->isVisible());
    QTest::mouseClick(select, Qt::LeftButton);
    QCOMPARE(document.selection(), (Ids{3, 4}));
    QCOMPARE(last_step(document), "Select 2 Gaussians");
    // So does Enter, and Ctrl+A in the table, even where all its rows are selected and others are.
    document.undo_stack().undo();
    QTest::keyClick(desk.findChild<QLineEdit*>("gaussian_filter"), Qt::Key_Return);
    QCOMPARE(document.selection(), (Ids{3, 4}));
    select_all(document);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(document.selection(), (Ids{3, 4}));
    // Edits are counted.
    document.select({3});
    delete_selection(document, "Delete");
    QCOMPARE(count->text(), "1 of 4");
    document.undo_stack().undo();
    QCOMPARE(count->text(), "2 of 5");

    // In place of the count there is what is wrong, and nothing to do.
    set_filter(desk, "id > two");
    QVERIFY2(count->text().contains("“two” is no number"), qPrintable(count->text()));
    QVERIFY(!select->isVisible() && !group->isVisible());
    const Ids chosen = document.selection();
    QTest::keyClick(desk.findChild<QLineEdit*>("gaussian_filter"), Qt::Key_Return);
    QCOMPARE(document.selection(), chosen);
    set_filter(desk, "id > 9");
    QCOMPARE(count->text(), "0 of 5");
    QVERIFY(!select->isEnabled() && !group->isEnabled());

    document.select({1});
    const int steps = document.undo_stack().index();
    set_filter(desk, "id > 2, id <= 4");
    QTest::mouseClick(group, Qt::LeftButton);
    QCOMPARE(document.undo_stack().index(), steps + 1);
    QCOMPARE(last_step(document), "Save id > 2, id <= 4 as group");
    QCOMPARE(document.scene().groups.size(), 1u);
    QCOMPARE(document.scene().groups[0].name, "id > 2, id <= 4");
    QCOMPARE(members_of(document.scene(), document.scene().groups[0].id), (Ids{3, 4}));
    document.undo_stack().undo();
    QVERIFY(document.scene() == before);
    QCOMPARE(document.selection(), Ids{1});
    // A locked Gaussian gets into no group, and where all are locked there is none.
    document.lock({3});
    QTest::mouseClick(group, Qt::LeftButton);
    QCOMPARE(document.selection(), Ids{4});
    document.undo_stack().undo();
    document.lock({3, 4});
    const QSignalSpy refused(desk.findChild<GaussianPanel*>(), &GaussianPanel::refused);
    for (QPushButton* button : {select, group}) QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(refused.count(), 2);
    document.lock({});
    QVERIFY(document.scene() == before);
    set_filter(desk, "");
    QVERIFY(!count->isVisible());
  }

  void rows_have_the_ids_of_gaussians() {
    Desk desk;
    QTableView* table = table_of(desk);
    constexpr int id_column = GaussianTableModel::id_column;
    QHeaderView* header = table->horizontalHeader();
    QCOMPARE(header->visualIndex(id_column), 0);
    QVERIFY(!table->isColumnHidden(id_column));
    desk.document().select({2});
    delete_selection(desk.document(), "Delete");
    const auto shown = [&] {
      QStringList ids;
      for (int row = 0; row < table->model()->rowCount(); ++row) {
        ids << table->model()->index(row, id_column).data().toString();
      }
      return ids.join(' ');
    };
    QCOMPARE(shown(), "1 3 4 5");
    click_header(table, id_column);
    click_header(table, id_column);
    QCOMPARE(shown(), "5 4 3 1");
    QVERIFY(!(table->model()->flags(table->model()->index(0, id_column)) & Qt::ItemIsEditable));
  }

  void similar_gaussians_are_selected() {
    TestWindow window;
    Document& document = window->document();
    document.select({3, 5});  // radii of 0.4 and 0.41; the others are 0.28, 0.29 and 0.52
    trigger(*window, "Similar Radius");
    QCOMPARE(document.selection(), (Ids{3, 5}));
    QCOMPARE(step_count(document), 0);
    document.select({1});
    trigger(*window, "Similar Radius");
    QCOMPARE(document.selection(), (Ids{1, 4}));
    QCOMPARE(last_step(document), "Select 2 Gaussians");
    document.undo_stack().undo();
    QCOMPARE(document.selection(), Ids{1});
    trigger(*window, "Similar Density");
    QCOMPARE(document.selection().size(), 5u);
    document.select({2, 3});
    group_selection(document);
    document.select({3});
    trigger(*window, "Same Group");
    QCOMPARE(document.selection(), (Ids{2, 3}));
    document.select({});
    const int steps = step_count(document);
    for (const char* text : {"Similar Emission", "Same Group"}) trigger(*window, text);
    QCOMPARE(step_count(document), steps);
  }
};

BRUME_APP_SUITE("query", QueryTest)
#include "query_test.moc"
