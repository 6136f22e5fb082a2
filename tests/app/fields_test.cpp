// Fields with keyboard, mouse and wheel: what is typed is not lost, the view has the focus again,
// and the wheel changes nothing that one scrolls past.

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QToolBar>
#include <array>
#include <functional>

#include "app/commands/gaussians/edit_medium.h"
#include "app/document/time/timeline.h"
#include "app/files/scene_files.h"
#include "app/panels/gaussians/gaussian_panel.h"
#include "app/panels/lists/outliner.h"
#include "app/tools/brushes/paintbrush_tool.h"
#include "app/tools/tool_box.h"
#include "app/viewport/view_grid.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/desk.h"
#include "tests/app/dock_of.h"
#include "tests/app/question.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

NumberField& line_of(TestWindow& window, const char* field) {
  return window->findChild<ValueField*>(field)->number();
}

void type(QWidget& field, const QString& text) {
  show_dock_of(field);
  field.setFocus();
  QVERIFY(field.hasFocus());
  if (auto* box = qobject_cast<QSpinBox*>(&field)) box->selectAll();
  QTest::keyClicks(&field, text);
}

// Over what is under the mouse, from where it goes on to what that is in.
void turn_wheel(QWidget& field, int notches) {
  const QPoint middle = field.rect().center();
  QWidget* inner = field.childAt(middle);
  QWidget& over = inner ? *inner : field;
  QWheelEvent wheel(over.rect().center(), field.mapToGlobal(middle), {}, {0, 120 * notches},
                    Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QSpontaneKeyEvent::setSpontaneous(&wheel);  // as from the system: it may give the focus too
  qApp->notify(&over, &wheel);
}

QWidget& tool_button(TestWindow& window, const char* tool) {
  auto* action = window->findChild<QAction*>(QString("tool.") + tool);
  return *window->findChild<QToolBar*>("tools")->widgetForAction(action);
}

// The editor of a cell in the first row has the focus.
void open_cell(QTableView& table, int column) {
  show_dock_of(table);
  table.setFocus();
  table.selectionModel()->setCurrentIndex(table.model()->index(0, column),
                                          QItemSelectionModel::NoUpdate);
  QTest::keyClick(&table, Qt::Key_F2);
}

void activate(TestWindow& window) {
  window->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&*window));
}

QString active_tool(TestWindow& window) {
  return window->tools().entries()[window->tools().active()].name;
}

}  // namespace

class FieldsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void typed_values_are_committed_on_leaving() {
    TestWindow window;
    Document& document = window->document();
    auto& radius = *window->findChild<NumberField*>("radius");
    auto& filter = *window->findChild<QLineEdit*>("gaussian_filter");
    const auto click = [](QWidget* at) { QTest::mouseClick(at, Qt::LeftButton); };
    const std::function<void()> ways[]{
        [&] { QTest::keyClick(&radius, Qt::Key_Tab); },
        [&] { QTest::keyClick(&radius, Qt::Key_Return); },
        [&] { click(&filter); },
        [&] { window.click(QPoint(3, 3)); },
        [&] { click(&tool_button(window, "paintbrush")); },
        [&] { click(window->statusBar()); },
        [&] { QTest::keyClick(&radius, Qt::Key_S, Qt::ControlModifier); },
    };
    double value = 0.3;
    for (const auto& leave : ways) {
      document.select({1});
      value += 0.01;
      type(radius, QString::number(value));
      const int steps = document.undo_stack().index();
      leave();
      QCOMPARE(document.medium().radii()[0], value);
      QCOMPARE(document.undo_stack().text(steps),
               QString("Set radius of 1 Gaussian to %1").arg(value));
      QVERIFY(!radius.hasFocus());
    }
    // Saved with it.
    QCOMPARE(load_scene(document.file()).medium.radii()[0], value);
  }

  // Each way to end typing, with a name, a cell and a file.
  void typed_text_is_committed_by_shortcuts_saving_and_closing() {
    TestWindow window;
    Document& document = window->document();
    auto& tree = *window->findChild<Outliner*>();
    auto& table = *window->findChild<GaussianPanel*>()->table();
    auto& file = *window->findChild<QLineEdit*>("output_file");
    document.select({1});
    const auto type_name = [&](const QString& name) {
      show_dock_of(tree);
      document.set_object(ObjectRef{ObjectRef::Kind::light, 0});
      tree.rename_current();
      QTest::keyClicks(tree.findChild<QLineEdit*>("row_name"), name);
    };
    const auto type_radius = [&](const QString& radius) {
      open_cell(table, 3);
      QTest::keyClicks(QApplication::focusWidget(), radius);
    };
    const std::function<void()> ways[]{
        [] { QTest::keyClick(QApplication::focusWidget(), Qt::Key_S, Qt::ControlModifier); },
        [&] { QVERIFY(window->files().save()); },
        [&] { QTest::mouseClick(&tool_button(window, "eraser"), Qt::LeftButton); },
        [&] {
          answer(QMessageBox::Cancel);
          QTest::keyClick(QApplication::focusWidget(), Qt::Key_Q, Qt::ControlModifier);
          QVERIFY(window->isVisible());
          activate(window);  // after the question
        },
        [&] {
          answer(QMessageBox::Cancel);
          QVERIFY(!window->close());
          activate(window);
        },
    };
    int k = 0;
    for (const auto& leave : ways) {
      const QString number = QString::number(++k);
      type_name("Moon " + number);
      leave();
      QCOMPARE(document.scene().lights[0].name, ("Moon " + number).toStdString());
      QTRY_COMPARE(tree.findItems("Moon " + number, Qt::MatchRecursive).size(), 1);
      type_radius("0.7" + number);
      leave();
      QCOMPARE(document.medium().radii()[0], 0.7 + 0.01 * k);
      show_dock_of(file);
      file.clear();
      type(file, number + ".png");
      leave();
      QCOMPARE(document.scene().output.file, window.file(qPrintable(number + ".png")));
    }
    const Scene saved = load_scene(document.file());
    QCOMPARE(saved.lights[0].name, std::string("Moon 2"));
    QCOMPARE(saved.output.file.filename(), std::filesystem::path("2.png"));
  }

  void typed_text_is_committed_in_a_floating_panel() {
    TestWindow window;
    auto& file = *window->findChild<QLineEdit*>("output_file");
    auto& dock = *window->findChild<QDockWidget*>("output_dock");
    dock.setFloating(true);
    show_dock_of(file);
    dock.activateWindow();
    file.setFocus();
    QTRY_VERIFY(file.hasFocus());
    QTest::keyClicks(&file, "a.png");
    QTest::keyClick(&file, Qt::Key_S, Qt::ControlModifier);
    QVERIFY(load_scene(window.file("scene.brume")).output.file == window.file("a.png"));
    QVERIFY(!window->document().is_modified());
  }

  // Each frame of an animation changes the scene.
  void a_name_that_is_typed_outlasts_changes_of_the_scene() {
    TestWindow window;
    Document& document = window->document();
    auto& tree = *window->findChild<Outliner*>();
    show_dock_of(tree);
    document.set_object(ObjectRef{ObjectRef::Kind::light, 0});
    tree.rename_current();
    QTest::keyClicks(QApplication::focusWidget(), "Mo");
    document.announce(Change::part);
    QTest::keyClicks(QApplication::focusWidget(), "on");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTRY_COMPARE(document.scene().lights[0].name, std::string("Moon"));
    QTRY_COMPARE(tree.findItems("Moon", Qt::MatchRecursive).size(), 1);
  }

  void undo_is_the_documents_unless_something_is_typed() {
    TestWindow window;
    QUndoStack& stack = window->document().undo_stack();
    auto& table = *window->findChild<GaussianPanel*>()->table();
    const auto open_field = [&](const char* name) {
      auto& field = *window->findChild<QWidget*>(name);
      show_dock_of(field);
      field.setFocus();
    };
    const std::function<void()> ways[]{
        [&] { open_field("density"); },     [&] { open_field("gaussian_filter"); },
        [&] { open_field("output_file"); }, [&] { open_field("last_frame_of_range"); },
        [&] { open_cell(table, 3); },
    };
    const auto press_z = [](Qt::KeyboardModifiers modifiers) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier | modifiers);
    };
    window->document().select({1});
    double radius = 0.9;
    for (const auto& open : ways) {
      set_attribute(window->document(), std::array{GaussianId{1}}, GaussianAttribute::radius,
                    radius += 0.01);
      const int steps = stack.index();
      open();
      press_z({});
      QCOMPARE(stack.index(), steps - 1);
      open();
      press_z(Qt::ShiftModifier);
      QCOMPARE(stack.index(), steps);

      open();
      QWidget* field = QApplication::focusWidget();
      const QString text = field->property("text").toString();
      QTest::keyClicks(field, "5");
      QVERIFY(field->property("text") != text);
      while (field->property("text") != text) {
        press_z({});
        QCOMPARE(stack.index(), steps);
        QVERIFY(field->hasFocus());
      }
      press_z({});
      QCOMPARE(stack.index(), steps - 1);
    }
  }

  void all_fields_follow_the_same_rules() {
    TestWindow window;
    window.key(Qt::Key_B);
    auto& brush = dynamic_cast<PaintbrushTool&>(window->tools().tool());
    auto& last = *window->findChild<QSpinBox*>("last_frame_of_range");
    type(line_of(window, "light_intensity"), "34");
    QTest::mouseClick(&tool_button(window, "eraser"), Qt::LeftButton);
    QCOMPARE(window.scene().lights[0].intensity.r, 34.0);
    window.key(Qt::Key_B);
    type(line_of(window, "brush_radius"), "0.77");
    QTest::mouseClick(&tool_button(window, "eraser"), Qt::LeftButton);
    QCOMPARE(brush.brush().radius, 0.77);
    QCOMPARE(active_tool(window), "eraser");
    type(last, "60");
    QTest::mouseClick(&tool_button(window, "paintbrush"), Qt::LeftButton);
    QCOMPARE(window->timeline().last(), 60);
  }

  void after_enter_and_escape_keys_are_the_views() {
    TestWindow window;
    Document& document = window->document();
    document.select({1});
    const Scene before = document.scene();
    QWidget* const fields[]{window->findChild<NumberField*>("density"),
                            &line_of(window, "light_intensity"),
                            window->findChild<QSpinBox*>("last_frame_of_range")};
    for (QWidget* field : fields) {
      window->tools().activate(0);
      type(*field, "47");
      QTest::keyClick(field, Qt::Key_Return);
      QVERIFY(window->viewport().hasFocus());
      QCOMPARE(document.undo_stack().index(), 1);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_E);
      QCOMPARE(active_tool(window), "eraser");
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
      QVERIFY(document.scene() == before);

      const QString shown = field->property("text").toString();
      type(*field, "53");
      QTest::keyClick(field, Qt::Key_Escape);
      QVERIFY(window->viewport().hasFocus());
      QVERIFY(document.scene() == before);
      QCOMPARE(document.undo_stack().index(), 0);
      QCOMPARE(field->property("text").toString(), shown);
    }
    // The view that was used last.
    window.key(Qt::Key_Q, Qt::ControlModifier | Qt::AltModifier);
    Viewport& front = *window->views().panes()[2];
    front.setFocus();
    type(*fields[0], "1");
    QTest::keyClick(fields[0], Qt::Key_Return);
    QVERIFY(front.hasFocus());
  }

  void a_refused_value_is_reported_once() {
    TestWindow window;
    window->document().select({1});
    auto& radius = *window->findChild<NumberField*>("radius");
    const QString before = radius.text();
    QSignalSpy said(window->statusBar(), &QStatusBar::messageChanged);
    type(radius, "-1");
    QTest::keyClick(&radius, Qt::Key_Return);
    QCOMPARE(said.count(), 1);
    QVERIFY(window->statusBar()->currentMessage().contains("Radius"));
    QCOMPARE(radius.text(), before);
    QVERIFY(!window->document().is_modified());
  }

  void a_frame_before_0_is_refused() {
    TestWindow window;
    window->timeline().set_frame(7);
    for (const char* name : {"frame", "first_frame_of_range", "last_frame_of_range"}) {
      auto& box = *window->findChild<QSpinBox*>(name);
      const int before = box.value();
      window->statusBar()->clearMessage();
      type(box, "-3");
      QTest::keyClick(&box, Qt::Key_Return);
      QVERIFY2(window->statusBar()->currentMessage().contains("from 0 to 1000000"), name);
      QCOMPARE(box.value(), before);
      QCOMPARE(box.text(), QString::number(before));
    }
    QCOMPARE(window->timeline().frame(), 7);
    QVERIFY(!window->document().is_modified());
  }

  void tab_goes_through_the_panels_and_edits_nothing() {
    TestWindow window;
    Document& document = window->document();
    set_attribute(document, std::array{GaussianId{1}}, GaussianAttribute::radius, 0.9);
    document.undo_stack().undo();
    auto& table = *window->findChild<GaussianPanel*>()->table();
    show_dock_of(table);
    table.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&table, Qt::Key_Tab);
    QVERIFY(!table.hasFocus());
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab, Qt::ShiftModifier);
    QVERIFY(table.hasFocus());
    QVERIFY(document.undo_stack().canRedo());
    QVERIFY(document.selection().empty());
  }

  // Another value may change meanwhile, as when something plays.
  void typing_is_not_interrupted() {
    Desk desk;
    Document& document = desk.document();
    document.select({1});
    auto& radius = *desk.findChild<NumberField*>("radius");
    type(radius, "0.4");
    set_attribute(document, document.selection(), GaussianAttribute::density, 0.5);
    QCOMPARE(radius.text(), "0.4");
    QTest::keyClicks(&radius, "2");
    QTest::keyClick(&radius, Qt::Key_Return);
    QCOMPARE(document.medium().radii()[0], 0.42);
  }

  void the_wheel_changes_the_focused_field_only() {
    TestWindow window;
    window->document().select({1});
    window.key(Qt::Key_B);
    window->timeline().set_frame(30);
    struct Field {
      QWidget* over;
      QWidget* focus;
      std::function<QString()> value;
    };
    const auto number = [](NumberField* line) {
      return Field{line, line, [line] { return line->text(); }};
    };
    const auto spin = [](QSpinBox* box) {
      return Field{box, box, [box] { return QString::number(box->value()); }};
    };
    const auto choice = [](QComboBox* box) {
      return Field{box, box, [box] { return box->currentText(); }};
    };
    const Field fields[]{
        number(window->findChild<NumberField*>("radius")),
        number(window->findChild<NumberField*>("center_x")),
        number(&line_of(window, "light_intensity")),
        number(&line_of(window, "brush_radius")),
        spin(window->findChild<QSpinBox*>("frame")),
        choice(window->findChild<QComboBox*>("max_error")),
        choice(window->findChild<QComboBox*>("brush_plane")),
    };
    for (const Field& field : fields) {
      show_dock_of(*field.over);
      window->viewport().setFocus();
      QVERIFY(field.over->focusPolicy() != Qt::WheelFocus);  // nor does it get that by the wheel
      const QString before = field.value();
      turn_wheel(*field.over, -1);
      QCOMPARE(field.value(), before);
      QVERIFY(window->viewport().hasFocus());
      field.focus->setFocus();
      const QString exact = field.value();
      turn_wheel(*field.over, -1);
      QVERIFY2(field.value() != exact, qPrintable(field.over->objectName() + field.value()));
      turn_wheel(*field.over, 1);
    }
  }

  void elsewhere_the_wheel_scrolls_the_panel() {
    TestWindow window;
    NumberField& intensity = line_of(window, "light_intensity");
    QScrollArea* area = nullptr;
    for (QWidget* above = &intensity; above && !area; above = above->parentWidget()) {
      area = qobject_cast<QScrollArea*>(above);
    }
    QVERIFY(area);
    show_dock_of(intensity);
    area->widget()->setMinimumHeight(area->height() + 400);
    QTRY_VERIFY(area->verticalScrollBar()->maximum() > 100);
    area->ensureWidgetVisible(&intensity);
    const int before = area->verticalScrollBar()->value();
    turn_wheel(intensity, -1);
    QVERIFY(area->verticalScrollBar()->value() > before);
    QCOMPARE(window->document().undo_stack().index(), 0);
  }

  void a_title_of_the_panel_gaussians_is_dragged() {
    Desk desk;
    Document& document = desk.document();
    document.select({1, 2});
    drag_title(desk, "density", 40);
    const double expected = 0.8 * std::pow(1.01, 40.0);
    for (const std::size_t k : {0U, 1U}) {
      const double density = document.medium().densities()[k];
      QVERIFY2(std::abs(density / expected - 1.0) < 1e-3, qPrintable(QString::number(density)));
    }
    QCOMPARE(document.undo_stack().index(), 1);
    drag_title(desk, "radius", 40);  // which is mixed: no one value to begin from
    QCOMPARE(document.undo_stack().index(), 1);
  }
};

BRUME_APP_SUITE("fields", FieldsTest)
#include "fields_test.moc"
