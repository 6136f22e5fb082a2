// Albedo and emission of Gaussians: in the inspector, in brushes and emitters, and copied.

#include <QCheckBox>
#include <QColorDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "app/commands/objects/edit_emitters.h"
#include "app/document/time/timeline.h"
#include "app/panels/gaussians/gaussian_filter.h"
#include "app/widgets/color_button.h"
#include "core/scene/lights/photometry.h"
#include "render/prepare/albedo.h"
#include "tests/app/desk.h"

using namespace brume;

namespace {

// The mean over channels, by luminance, of the extinction that a Gaussian is rendered with.
double mean_extinction(const Scene& scene, std::size_t index) {
  glm::dvec3 extinction;
  for (const AlbedoGroup& group : albedo_groups(scene, true)) {
    const double density = extinction_medium(scene, group).densities()[index];
    for (const std::size_t channel : group.channels)
      extinction[static_cast<int>(channel)] = density;
  }
  return luminance(extinction);
}

}  // namespace

class ColoursTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_inspector_sets_them_for_the_selection() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    auto* own = desk.findChild<QCheckBox*>("gaussian_has_albedo");
    auto* albedo = desk.findChild<ColorButton*>("gaussian_albedo");
    QVERIFY(!own->isEnabled());
    const std::vector<GaussianId> two{before.medium.ids()[0], before.medium.ids()[2]};
    document.select(two);
    const auto optics = [&](std::size_t i) { return document.medium().optics(i); };
    QVERIFY(own->isEnabled() && !albedo->isEnabled());
    QTest::mouseClick(own, Qt::LeftButton, {}, QPoint(8, own->height() / 2));
    QVERIFY(optics(0).albedo && !optics(1).albedo && optics(2).albedo);
    QCOMPARE(*optics(0).albedo, before.optics.albedo);
    // The dialog's colours are one step; black is as dark as albedos go.
    QTest::mouseClick(albedo, Qt::LeftButton);
    auto* dialog = albedo->findChild<QColorDialog*>();
    QVERIFY(dialog);
    dialog->setCurrentColor(QColor(0, 255, 0));
    dialog->setCurrentColor(QColor(255, 0, 0));
    QCOMPARE(*optics(2).albedo, glm::dvec3(1.0, 1e-6, 1e-6));
    // Black channels leave some of it.
    QVERIFY(document.medium().densities()[2] > 0.01 * before.medium.densities()[2]);
    dialog->setCurrentColor(QColor(255, 160, 90));
    const double extinction = mean_extinction(before, 2);
    QVERIFY(std::abs(mean_extinction(document.scene(), 2) / extinction - 1.0) < 1e-9);
    const auto titles = dialog->findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(titles, [](const QLabel* title) {
      return title->text() == "Temperature" && title->isVisible();
    }));
    click(*dialog, "color_1850_K");
    const glm::dvec3 candle = black_body_color(1850.0);
    QVERIFY(glm::length(*optics(2).albedo - glm::clamp(candle, 1e-6, 1.0)) < 0.01);
    dialog->close();
    QCOMPARE(step_count(document), 2);
    enter(desk, "gaussian_emission", "5");
    QCOMPARE(optics(0).emission, glm::dvec3(5.0));
    enter(desk, "gaussian_temperature", "1850");
    QCOMPARE(optics(2).emission, 5.0 * black_body_color(1850.0));
    QCOMPARE(optics(1).emission, glm::dvec3(0.0));
    enter(desk, "gaussian_emission", "-1");  // refused
    QCOMPARE(optics(0).emission, 5.0 * black_body_color(1850.0));
    QTest::mouseClick(own, Qt::LeftButton, {}, QPoint(8, own->height() / 2));
    QVERIFY(!optics(0).albedo);
    document.undo_stack().undo();
  }

  void the_table_has_a_column_and_a_filter() {
    Scene scene = small_scene();
    std::size_t index = 0;
    scene.medium = scene.medium.changed(0.0, [&](Gaussian g) {
      if (index++ % 2 == 0) g.optics.emission = {0.5, 3.0, 1.0};
      return g;
    });
    Desk desk(scene);
    auto* table = desk.findChild<QTableView*>();
    QVERIFY(table);
    QCOMPARE(table->model()->columnCount(), 16);
    QCOMPARE(table->model()->rowCount(), 5);
    auto* filter = desk.findChild<QLineEdit*>("gaussian_filter");
    QTest::keyClicks(filter, "emission > 1");
    QCOMPARE(table->model()->rowCount(), 3);
    // A number typed into a cell keeps the colour.
    table->model()->setData(table->model()->index(0, 6), "6");
    QCOMPARE(desk.document().medium().optics(0).emission, glm::dvec3(1.0, 6.0, 2.0));
  }

  void colours_are_typed_into_the_table() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    auto* table = desk.findChild<QTableView*>();
    const auto type_into = [&](int row, int column, const QString& text) {
      const QModelIndex cell = table->model()->index(row, column);
      table->selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
      table->edit(cell);
      auto* editor = table->viewport()->findChild<QLineEdit*>();
      if (!editor) qFatal("no editor");
      editor->selectAll();
      QTest::keyClicks(editor, text);
      QTest::keyClick(editor, Qt::Key_Return);
      QCoreApplication::processEvents();  // it is taken over later, and goes
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    const auto optics = [&](std::size_t i) { return document.medium().optics(i); };
    type_into(0, 5, "0.9 0.2 0.1");
    QCOMPARE(step_count(document), 1);
    QCOMPARE(*optics(0).albedo, glm::dvec3(0.9, 0.2, 0.1));
    QVERIFY(std::abs(mean_extinction(document.scene(), 0) / mean_extinction(before, 0) - 1.0) <
            1e-9);
    type_into(0, 5, "0,5, 0,25, 1");  // with decimal commas
    QCOMPARE(*optics(0).albedo, glm::dvec3(0.5, 0.25, 1.0));
    type_into(0, 5, "#ff8000");
    QCOMPARE(*optics(0).albedo, glm::clamp(to_linear(QColor(255, 128, 0)), 1e-6, 1.0));
    type_into(0, 6, "2 3 0.5");
    QCOMPARE(optics(0).emission, glm::dvec3(2.0, 3.0, 0.5));
    type_into(0, 6, "#00f");  // as bright
    QCOMPARE(optics(0).emission, glm::dvec3(0.0, 0.0, 3.0));
    type_into(0, 6, "#000");
    QCOMPARE(optics(0).emission, glm::dvec3(0.0));
    type_into(0, 6, "3");
    type_into(0, 6, "1850 K");
    QVERIFY(glm::length(optics(0).emission - 3.0 * black_body_color(1850.0)) < 1e-9);
    const int steps = step_count(document);
    for (const char* refused : {"0.5 0.5 2", "#12", "0.5 0.5", "-4 K", "0.5 0.5 x"}) {
      type_into(0, 5, refused);
      QCOMPARE(step_count(document), steps);
    }
    // One step for all that is selected.
    document.select({before.medium.ids()[0], before.medium.ids()[2]});
    type_into(2, 5, "#fff");
    QCOMPARE(*optics(0).albedo, glm::dvec3(1.0));
    QCOMPARE(*optics(2).albedo, glm::dvec3(1.0));
    QVERIFY(!optics(1).albedo);
    document.undo_stack().undo();
    QVERIFY(!optics(2).albedo);
  }

  void brushes_paint_with_them() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    desk.key(Qt::Key_B);
    auto* button = desk.findChild<QToolButton*>("brush_colours");
    QVERIFY(button && button->isVisible());
    auto* own = desk.findChild<QCheckBox*>("brush_has_albedo");
    own->click();
    Q_EMIT desk.findChild<ColorButton*>("brush_albedo")->edited({0.9, 0.2, 0.1}, no_merge);
    enter(desk, "brush_emission", "2");
    const QPoint middle = desk.view().rect().center();
    desk.drag(middle, middle + QPoint(60, 0));
    const Medium& medium = document.medium();
    QVERIFY(medium.size() > before.medium.size());
    for (std::size_t i = before.medium.size(); i < medium.size(); ++i) {
      QVERIFY(medium.optics(i) == (GaussianOptics{glm::dvec3(0.9, 0.2, 0.1), glm::dvec3(2.0)}));
    }
    QCOMPARE(step_count(document), 1);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.scene(), before);
    // Alt picks them, here those of a plain one.
    desk.drag(desk.handle(4), desk.handle(4), Qt::LeftButton, Qt::AltModifier);
    QVERIFY(!own->isChecked());
  }

  void emitters_have_them() {
    Scene scene = small_scene();
    scene.emitters.push_back({.rate = 30.0, .lifetime = 1.0});
    Desk desk(scene);
    Document& document = desk.document();
    const Scene before = document.scene();
    const auto emitter = [&]() -> const Emitter& { return document.scene().emitters[0]; };
    auto* own = desk.findChild<QCheckBox*>("emitter_has_albedo");
    QTest::mouseClick(own, Qt::LeftButton, {}, QPoint(8, own->height() / 2));
    QCOMPARE(last_step(document), "Set colours of emitter 1");
    QCOMPARE(*emitter().optics.albedo, before.optics.albedo);
    auto* albedo = desk.findChild<ColorButton*>("emitter_albedo");
    QTest::mouseClick(albedo, Qt::LeftButton);
    albedo->findChild<QColorDialog*>()->setCurrentColor(QColor(255, 0, 0));
    albedo->findChild<QColorDialog*>()->close();
    enter(desk, "emitter_emission", "8");
    enter(desk, "emitter_temperature", "1850");
    enter(desk, "emitter_death_emission", "2");
    QCOMPARE(last_step(document), "Set emission of emitter 1");
    enter(desk, "emitter_death_temperature", "1000");
    QCOMPARE(*emitter().optics.albedo, glm::dvec3(1.0, 1e-6, 1e-6));
    QCOMPARE(emitter().optics.emission, 8.0 * black_body_color(1850.0));
    QCOMPARE(emitter().emission_at_death, 2.0 * black_body_color(1000.0));
    const int steps = step_count(document);
    QCOMPARE(steps, 6);
    enter(desk, "emitter_emission", "-1");  // refused
    enter(desk, "emitter_death_emission", "much");
    QCOMPARE(step_count(document), steps);

    // The picture's particles have them, and what is baked.
    desk.timeline().set_frame(15);
    const Medium& shown = desk.view().shown_scene()->medium;
    QCOMPARE(shown.optics(5).albedo, emitter().optics.albedo);
    QVERIFY(shown.optics(5).emission.r > 2.0 && shown.optics(5).emission.r < 8.0);
    freeze_particles(document, document.time());
    QVERIFY(document.medium().optics(5) == shown.optics(5));
  }
};

BRUME_APP_SUITE("colours", ColoursTest)
#include "colours_test.moc"
