// Lights: the panel that edits them, their handles in the view, and their keys.

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/commands/objects/edit_lights.h"
#include "app/panels/forms/light_panel.h"
#include "app/view/camera/object_box.h"
#include "app/view/drawing/overlay.h"
#include "app/viewport/viewport.h"
#include "app/widgets/color_button.h"
#include "app/widgets/number_field.h"
#include "app/widgets/value_field.h"
#include "core/scene/fields/light_fields.h"
#include "core/scene/lights/photometric_profile.h"
#include "core/scene/lights/photometry.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

QPoint light_position(Desk& desk, std::size_t index) {
  return film_position(desk.view(), desk.scene().lights[index].position);
}

}  // namespace

class LightsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lights_are_added_changed_and_deleted() {
    Desk desk;
    Document& document = desk.document();
    click(desk, "add_light");
    QCOMPARE(document.scene().lights.size(), 2u);
    QCOMPARE(last_step(document), "Add light 2");
    QCOMPARE(document.active_light(), 1u);
    enter(desk, "light_intensity", "48");
    QCOMPARE(document.scene().lights[1].intensity, glm::dvec3(48.0));
    QCOMPARE(last_step(document), "Set intensity of light 2");
    enter(desk, "light_position_y", "3.5");
    QCOMPARE(document.scene().lights[1].position.y, 3.5);
    enter(desk, "light_intensity", "-1");
    QCOMPARE(document.scene().lights[1].intensity, glm::dvec3(48.0));
    auto* list = desk.findChild<QListWidget*>("lights");
    QCOMPARE(list->count(), 2);
    list->item(0)->setCheckState(Qt::Unchecked);
    QVERIFY(!document.scene().lights[0].on);
    QCOMPARE(last_step(document), "Turn light 1 off");
    list->setCurrentRow(0);
    QCOMPARE(value(desk, "light_intensity"), "12");
    click(desk, "delete_light");
    QCOMPARE(document.scene().lights.size(), 1u);
    QCOMPARE(document.scene().lights[0].intensity, glm::dvec3(48.0));
    QCOMPARE(step_count(document), 5);
  }

  void dragging_a_title_is_one_step() {
    Desk desk;
    Document& document = desk.document();
    drag_title(desk, "light_intensity", 80);
    QCOMPARE(step_count(document), 1);
    const Light& light = document.scene().lights[0];
    QVERIFY(light_strength(light) > 20.0);
    // The colour stays.
    QVERIFY(glm::distance(light_color(light), glm::dvec3(12, 10, 8) / 12.0) < 1e-12);
    drag_title(desk, "light_intensity", 10);
    QCOMPARE(step_count(document), 2);
  }

  void the_colour_of_a_light_is_chosen_beside_the_work() {
    Desk desk;
    auto* button = desk.findChild<ColorButton*>("light_color");
    QTest::mouseClick(button, Qt::LeftButton);
    auto* dialog = button->findChild<QColorDialog*>();
    QVERIFY(dialog && !dialog->isModal());
    dialog->setCurrentColor(QColor(255, 0, 0));
    dialog->setCurrentColor(QColor(0, 0, 255));
    QCOMPARE(desk.scene().lights[0].intensity, glm::dvec3(0.0, 0.0, 12.0));
    QCOMPARE(step_count(desk.document()), 1);
    dialog->close();
    // Between what is shown and what is meant nothing is lost but rounding to 8 bits.
    for (const double x : {0.0, 0.001, 0.2, 0.5, 1.0}) {
      QVERIFY(std::abs(to_linear(to_color(glm::dvec3(x))).g - x) < 1e-3);
    }
  }

  void spots_are_added_opened_and_turned() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    const std::size_t last = before.lights.size();
    click(desk, "add_spot");
    QCOMPARE(document.scene().lights.size(), last + 1);
    QCOMPARE(last_step(document), "Add light 2");
    const auto spot = [&]() -> const light::Spot& {
      return std::get<light::Spot>(document.scene().lights[last].kind);
    };
    // Down, at what the view looks at.
    QVERIFY(spot().direction.y < 0.0);
    enter(desk, "light_outer_angle", "30");
    QCOMPARE(spot().outer_angle, 30.0);
    QCOMPARE(last_step(document), "Set outer angle of light 2");
    enter(desk, "light_inner_angle", "40");
    QCOMPARE(spot().inner_angle, 40.0);
    QVERIFY2(spot().outer_angle > 40.0, "the outer angle makes room");
    enter(desk, "light_outer_angle", "181");
    QVERIFY(spot().outer_angle < 180.0);
    enter(desk, "light_outer_angle", "5");
    QVERIFY(spot().inner_angle < 5.0);
    enter(desk, "light_direction_x", "-2");
    QCOMPARE(spot().direction.x, -2.0);
    QCOMPARE(last_step(document), "Set direction of light 2");
    enter(desk, "light_direction_x", "0");
    const glm::dvec3 direction = spot().direction;
    for (const char* name : {"light_direction_y", "light_direction_z"}) enter(desk, name, "0");
    QVERIFY2(spot().direction != glm::dvec3(0.0), "it shines somewhere");
    QVERIFY(direction.x == 0.0);

    auto* type = desk.findChild<QComboBox*>("light_type");
    QCOMPARE(type->currentText(), "Spot");
    const light::Spot cone = spot();
    type->setFocus();
    QTest::keyClick(type, Qt::Key_Up);
    QVERIFY(!document.scene().lights[last].as<light::Spot>());
    QCOMPARE(last_step(document), "Change type of light 2");
    QTest::keyClick(type, Qt::Key_Down);
    QVERIFY(document.scene().lights[last].as<light::Spot>());
    QVERIFY(cone != spot());
  }

  void a_light_of_another_type_keeps_the_keyframes_that_it_can() {
    Light light{.kind = light::Spot()};
    light.keys.position = {{0.0, {1, 2, 3}}};
    light.keys.intensity = {{0.0, {4, 5, 6}}};
    light.keys.direction = {{0.0, {0, 0, 1}}};
    light.keys.inner_angle = {{0.0, 5.0}};
    const LightKeys before = light.keys;
    set_kind(light, light::Point(), {});
    QCOMPARE(light.keys.position, before.position);
    QCOMPARE(light.keys.intensity, before.intensity);
    QVERIFY(light.keys.direction.empty() && light.keys.inner_angle.empty());
    set_kind(light, light::Directional(), {});
    QVERIFY2(light.keys.intensity.empty(), "in other units");
    QVERIFY(light.keys.position.empty());
  }

  void a_sun_is_added_changed_and_turned() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    click(desk, "add_directional");
    QCOMPARE(document.scene().lights.size(), before.lights.size() + 1);
    const auto sun = [&]() -> const Light& { return document.scene().lights.back(); };
    QVERIFY(sun().as<light::Directional>());
    QVERIFY(sun().as<light::Directional>()->direction.y < 0.0);
    QCOMPARE(desk.findChild<QComboBox*>("light_type")->currentText(), "Directional");
    QVERIFY(!desk.findChild<ValueField*>("light_position_x")->isEnabled());
    enter(desk, "light_intensity", "4.5");
    QCOMPARE(sun().intensity, glm::dvec3(4.5));
    enter(desk, "light_angular_diameter", "0.53");
    QCOMPARE(sun().as<light::Directional>()->angular_diameter, 0.53);
    enter(desk, "light_angular_diameter", "90");
    QVERIFY(sun().as<light::Directional>()->angular_diameter < 90.0);
    enter(desk, "light_direction_y", "-2");
    QCOMPARE(sun().as<light::Directional>()->direction.y, -2.0);
    QCOMPARE(last_step(document), "Set direction of light 2");

    // Its icon beside the scene turns it.
    enter(desk, "light_intensity", "0.001");  // a ring that is in nobody's way
    const glm::dvec3 direction = glm::normalize(sun().as<light::Directional>()->direction);
    const auto film = [&] {
      return film_position(desk.view(),
                           handle_position(sun(), document.scene(), desk.view().rays()));
    };
    const QPoint at = film();
    desk.drag(at, at + QPoint(50, 0));
    QCOMPARE(last_step(document), "Turn light 2");
    QVERIFY(glm::dot(glm::normalize(sun().as<light::Directional>()->direction), direction) < 0.999);
    QVERIFY2((film() - at).x() > 10, "it follows the pointer");
  }

  void an_area_light_is_added_changed_and_scaled() {
    Desk desk;
    Document& document = desk.document();
    const auto light = [&]() -> const Light& { return document.scene().lights.back(); };
    auto* menu = desk.findChild<QToolButton*>("add_area")->menu();
    QCOMPARE(menu->actions().size(), 3);
    for (QAction* shape : menu->actions()) {
      menu->popup(QPoint(40, 40));
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(shape).center());
      QVERIFY(area_of(light()));
    }
    QVERIFY(light().as<light::Sphere>());
    QVERIFY(!desk.findChild<ValueField*>("light_direction_x")->isEnabled());
    QVERIFY(!desk.findChild<ValueField*>("light_width")->isEnabled());
    enter(desk, "light_radius", "0.3");
    QCOMPARE(std::get<light::Sphere>(light().kind).radius, 0.3);
    QCOMPARE(last_step(document), "Set radius of light 4");
    enter(desk, "light_intensity", "2");
    QCOMPARE(light().intensity, glm::dvec3(2.0));
    enter(desk, "light_intensity", "0.001");  // a ring that is in nobody's way

    auto* type = desk.findChild<QComboBox*>("light_type");
    type->setFocus();
    QTest::keyClick(type, Qt::Key_Up);
    QTest::keyClick(type, Qt::Key_Up);
    const auto rectangle = [&] { return std::get<light::Rectangle>(light().kind); };
    enter(desk, "light_width", "0.4");
    enter(desk, "light_height", "0.25");
    enter(desk, "light_up_x", "0.5");
    QCOMPARE(rectangle().up.x, 0.5);
    enter(desk, "light_direction_x", "-2");
    QCOMPARE(rectangle().direction.x, -2.0);
    auto* two_sided = desk.findChild<QCheckBox*>("light_two_sided");
    QTest::mouseClick(two_sided, Qt::LeftButton, {}, QPoint(8, two_sided->height() / 2));
    QVERIFY(rectangle().two_sided);
    auto* visible = desk.findChild<QCheckBox*>("light_visible");
    QTest::mouseClick(visible, Qt::LeftButton, {}, QPoint(8, visible->height() / 2));
    QVERIFY(rectangle().visible);
    document.undo_stack().undo();
    QVERIFY(!rectangle().visible && !visible->isChecked());
    document.undo_stack().redo();
    QVERIFY(rectangle().visible && visible->isChecked());

    // A corner of it scales it, the end of its normal turns it.
    const auto film = [&](const glm::dvec3& point) { return film_position(desk.view(), point); };
    const auto [right, up] = rectangle_axes(rectangle());
    const QPoint corner = film(light().position + 0.2 * right + 0.125 * up);
    const QPoint center = film(light().position);
    desk.drag(corner, center + 2 * (corner - center));
    QCOMPARE(last_step(document), "Set size of light 4");
    QVERIFY(std::abs(rectangle().width - 0.8) < 0.1);
    QVERIFY(std::abs(rectangle().height / rectangle().width - 0.625) < 1e-9);

    const double radiant = light_strength(light()) * facing_area(rectangle());
    type->showPopup();
    QTest::keyClick(type->view(), Qt::Key_Home);
    QTest::keyClick(type->view(), Qt::Key_Return);
    QVERIFY(!area_of(light()));
    QVERIFY2(std::abs(light_strength(light()) - radiant) < 1e-9, "as bright from afar");
  }

  void lights_are_added_by_key_and_looked_through() {
    TestWindow window;
    Document& document = window->document();
    const Scene before = document.scene();
    for (int type = 0; type < 6; ++type) {
      window.key(static_cast<Qt::Key>(Qt::Key_1 + type), Qt::ControlModifier);
      QCOMPARE(document.scene().lights.size(), before.lights.size() + 1 + type);
      QCOMPARE(static_cast<int>(document.scene().lights.back().kind.index()), type);
    }
    // From the spot, along its axis, as wide as its cone.
    document.set_active_light(before.lights.size() + 1);
    const Light spot = document.scene().lights[document.active_light()];
    window.key(Qt::Key_L, Qt::ShiftModifier);
    const Camera& camera = window->viewport().camera();
    QCOMPARE(camera.eye, spot.position);
    QCOMPARE(camera.vertical_fov, 2.0 * spot.as<light::Spot>()->outer_angle);
    const glm::dvec3 axis = glm::normalize(spot.as<light::Spot>()->direction);
    QVERIFY(glm::distance(window->viewport().rays().forward(), axis) < 1e-9);
    QVERIFY(is_undone(document, before));
  }

  void lights_have_presets_temperatures_and_photometric_units() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    auto* menu = desk.findChild<QToolButton*>("light_presets")->menu();
    QCOMPARE(menu->actions().size(), 7);
    for (QAction* preset : menu->actions()) {
      menu->popup(QPoint(40, 40));
      QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(preset).center());
    }
    QCOMPARE(document.scene().lights.size(), before.lights.size() + 7);
    QVERIFY(document.scene().lights[before.lights.size()].as<light::Directional>());
    QVERIFY(document.scene().lights[before.lights.size() + 3].as<light::Spot>());
    QVERIFY(area_of(document.scene().lights[before.lights.size() + 5]));  // a window
    // The candle.
    const auto candle = [&]() -> const Light& { return document.scene().lights.back(); };
    const auto shown = [&](const char* name) {
      return desk.findChild<ValueField*>(name)->findChild<NumberField*>()->text().toDouble();
    };
    QVERIFY(candle().as<light::Point>());
    QVERIFY(std::abs(shown("light_temperature") - 1850.0) <= 2.0);
    enter(desk, "light_candela", "1");
    QVERIFY(std::abs(photometric_strength(candle()) - 1.0) < 1e-9);
    QVERIFY(std::abs(shown("light_lumen") - 12.566) < 0.01);
    enter(desk, "light_lumen", "800");
    QVERIFY(std::abs(*luminous_flux(candle()) - 800.0) < 1e-6);
    QVERIFY(std::abs(shown("light_temperature") - 1850.0) <= 2.0);
    const double strength = light_strength(candle());
    enter(desk, "light_temperature", "5500");
    QCOMPARE(last_step(document),
             QString("Set temperature of light %1").arg(document.scene().lights.size()));
    QVERIFY(std::abs(light_strength(candle()) - strength) < 1e-9);
    QVERIFY(candle().intensity.b > 0.7 * candle().intensity.r);
    enter(desk, "light_temperature", "50000");
    QVERIFY(nearest_temperature(light_color(candle())) < 40001.0);
    // A light that is black is made white.
    enter(desk, "light_candela", "0");
    QCOMPARE(candle().intensity, glm::dvec3(0.0));
    enter(desk, "light_candela", "683");
    QVERIFY(std::abs(candle().intensity.g - 1.0) < 1e-9);
    // The sun has no flux.
    document.set_active_light(before.lights.size());
    QVERIFY(!desk.findChild<ValueField*>("light_lumen")->isEnabled());
  }

  void a_spot_is_turned_and_opened_in_the_view() {
    Desk desk;
    Document& document = desk.document();
    click(desk, "add_spot");
    enter(desk, "light_intensity", "0.001");  // a ring that is in nobody's way
    const Light before = document.scene().lights[1];
    const auto film = [&](const glm::dvec3& point) { return film_position(desk.view(), point); };
    const double length = 0.2 * glm::distance(before.position, desk.view().rays().eye());
    const glm::dvec3 axis = glm::normalize(before.as<light::Spot>()->direction);
    const QPoint target = film(before.position + length * axis);
    desk.drag(target, target + QPoint(40, 0));
    QCOMPARE(last_step(document), "Turn light 2");
    const glm::dvec3 turned =
        glm::normalize(document.scene().lights[1].as<light::Spot>()->direction);
    QVERIFY(glm::dot(turned, axis) < 0.99);
    QCOMPARE(document.scene().lights[1].position, before.position);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.scene().lights[1], before);
    // The rim, to the right of the target.
    const glm::dvec3 right = glm::normalize(glm::cross(axis, glm::dvec3(1, 0, 0)));
    const double radius = length * std::tan(glm::radians(before.as<light::Spot>()->outer_angle));
    const glm::dvec3 across = glm::cross(right, axis);
    const QPoint rim = film(before.position + length * axis + radius * across);
    desk.drag(rim, rim + (rim - target));
    QCOMPARE(last_step(document), "Set outer angle of light 2");
    const light::Spot& cone = *document.scene().lights[1].as<light::Spot>();
    QVERIFY2(cone.outer_angle > 30.0 && cone.outer_angle < 42.0,
             qPrintable(QString::number(cone.outer_angle)));
    QVERIFY(std::abs(cone.inner_angle / cone.outer_angle - 0.75) < 1e-9);
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.scene().lights[1], before);
  }

  void a_cone_is_drawn_of_a_spot_that_is_selected_or_pointed_at() {
    Desk desk;
    Document& document = desk.document();
    click(desk, "add_spot");
    const auto lines = [&] {
      Overlay overlay;
      desk.tools().tool().draw(overlay, desk.view().rays());
      return overlay.lines.size();
    };
    const std::size_t selected = lines();
    document.set_object(std::nullopt);
    const std::size_t plain = lines();
    QVERIFY(selected > plain + 96);  // a rim of 48 segments
    desk.tools().tool().hover(light_position(desk, 1));
    QVERIFY(lines() > plain + 96);
    desk.tools().tool().hover(QPointF(3, 3));
    QCOMPARE(lines(), plain);
    auto* list = desk.findChild<QListWidget*>("lights");
    list->setCurrentRow(0);
    list->setCurrentRow(1);
    QCOMPARE(lines(), selected);
  }

  void a_light_is_dragged_in_the_view() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    const QPoint at = light_position(desk, 0);
    desk.drag(at, at + QPoint(-30, 20));
    QCOMPARE(last_step(document), "Move light 1");
    QCOMPARE(step_count(document), 1);
    QVERIFY((light_position(desk, 0) - at - QPoint(-30, 20)).manhattanLength() <= 2);
    QVERIFY(std::abs(document.scene().lights[0].position.z - 2.0) < 1e-9);
    QVERIFY(document.selection().empty());
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    // The ring: 18 pixels and 14 for each factor of ten of 1 + 12 W/sr.
    const QPoint ring(qRound(18.0 + 14.0 * std::log10(13.0)), 0);
    desk.drag(at + ring, at + ring + QPoint(14, 0));
    QCOMPARE(last_step(document), "Set intensity of light 1");
    const double strength = light_strength(document.scene().lights[0]);
    QVERIFY2(strength > 100.0 && strength < 160.0, qPrintable(QString::number(strength)));
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(is_cancelled_by_escape(desk.view(), document, at, at + QPoint(20, 0)));
    QVERIFY(document.scene() == before);
    QVERIFY(!document.is_modified());
  }

  void a_profile_is_read_turned_and_removed() {
    Desk desk;
    Document& document = desk.document();
    const Scene before = document.scene();
    const auto light = [&]() -> const Light& { return document.scene().lights[0]; };
    auto* rotation = desk.findChild<ValueField*>("light_profile_rotation");
    auto* remove = desk.findChild<QPushButton*>("remove_profile");
    QVERIFY(!rotation->isEnabled());
    QVERIFY(!remove->isEnabled());
    const std::filesystem::path file = desk.file("narrow.ies");
    std::ofstream(file) << "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 60\n"
                           "0 30 60\n0\n100 50 0\n";
    desk.findChild<LightPanel*>()->load_profile(file);
    QTRY_VERIFY(profile_of(light()));
    QCOMPARE(profile_of(light())->content->at({0.0, 0.0, 1.0}), 1.0);
    QCOMPARE(last_step(document), "Set profile of light 1");
    QCOMPARE(desk.findChild<QLabel*>("light_profile")->text(), "narrow.ies");
    // Less of its light, and so is its flux.
    const double flux = *luminous_flux(light());
    QVERIFY(flux < 0.1 * *luminous_flux(before.lights[0]));
    enter(desk, "light_profile_rotation", "45");
    QCOMPARE(profile_of(light())->rotation, 45.0);
    // A missing file changes nothing.
    QSignalSpy refused(desk.findChild<LightPanel*>(), &LightPanel::refused);
    desk.findChild<LightPanel*>()->load_profile(desk.file("none.ies"));
    QTRY_COMPARE(refused.count(), 1);
    QCOMPARE(profile_of(light())->file, file);
    // A spot keeps it, the sun cannot have one.
    auto* type = desk.findChild<QComboBox*>("light_type");
    type->setFocus();
    QTest::keyClick(type, Qt::Key_Down);
    QVERIFY(light().as<light::Spot>() && profile_of(light()));
    QTest::keyClick(type, Qt::Key_Down);
    QVERIFY(light().as<light::Directional>());
    QVERIFY(!desk.findChild<QPushButton*>("choose_profile")->isEnabled());
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(!profile_of(light()));
    QCOMPARE(desk.findChild<QLabel*>("light_profile")->text(), "none");
    document.undo_stack().undo();
  }

  void a_picture_is_put_into_the_beam_of_a_spot() {
    Scene scene;
    scene.lights = {{.kind = light::Spot{.outer_angle = 40.0}}};
    Desk desk(scene);
    Document& document = desk.document();
    const auto light = [&]() -> const Light& { return document.scene().lights[0]; };
    auto* focus = desk.findChild<ValueField*>("light_texture_focus");
    QVERIFY(!focus->isEnabled());
    const std::filesystem::path file = BRUME_RESOURCES "/gobos/window.png";
    desk.findChild<LightPanel*>()->load_texture(file);
    QTRY_VERIFY(texture_of(light()));
    QCOMPARE(last_step(document), "Set texture of light 1");
    QCOMPARE(desk.findChild<QLabel*>("light_texture")->text(), "window.png");
    enter(desk, "light_texture_focus", "0.5");
    QCOMPARE(texture_of(light())->focus, 0.5);
    // Wider than a half-space no picture fits.
    enter(desk, "light_outer_angle", "95");
    QCOMPARE(light().as<light::Spot>()->outer_angle, 40.0);
    click(desk, "remove_texture");
    QVERIFY(!texture_of(light()));
    document.undo_stack().undo();
  }
};

BRUME_APP_SUITE("lights", LightsTest)
#include "lights_test.moc"
