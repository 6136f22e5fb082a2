// The sky: the panel that sets it, and its sun, which is dragged in the view.

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <glm/geometric.hpp>

#include "app/panels/forms/environment_panel.h"
#include "app/widgets/value_field.h"
#include "core/scene/lights/sky.h"
#include "tests/app/desk.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

const Sky& sky_of(Desk& desk) {
  return *desk.scene().environment->sky;
}

glm::dvec3 sun_of(Desk& desk) {
  const Environment& environment = *desk.scene().environment;
  return direction_to_sun(environment, *environment.sky);
}

QPoint sun_on_film(Desk& desk) {
  return film_position(desk.view(), desk.view().rays().eye() + 10.0 * sun_of(desk));
}

}  // namespace

class SkyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_sky_is_set_changed_and_replaced() {
    Desk desk;
    Document& document = desk.document();
    auto* elevation = desk.findChild<ValueField*>("sky_elevation");
    auto* file = desk.findChild<QLabel*>("environment_file");
    auto* picture = desk.findChild<QLabel*>("environment_picture");
    QVERIFY(!elevation->isEnabled());
    click(desk, "add_sky");
    QVERIFY(elevation->isEnabled());
    QCOMPARE(file->text(), "Sky");
    QVERIFY(!picture->pixmap().isNull());
    QCOMPARE(last_step(document), "Set sky");
    const QImage noon = picture->pixmap().toImage();
    enter(desk, "sky_elevation", "3");
    QCOMPARE(sky_of(desk).elevation, 3.0);
    QCOMPARE(last_step(document), "Set elevation of sky");
    QVERIFY(picture->pixmap().toImage() != noon);
    enter(desk, "sky_elevation", "91");  // refused
    QCOMPARE(sky_of(desk).elevation, 3.0);
    enter(desk, "sky_azimuth", "-40");
    enter(desk, "sky_turbidity", "5");
    click(desk, "sky_sun");
    QVERIFY(!sky_of(desk).sun);
    QCOMPARE(step_count(document), 5);
    // A map in its place.
    desk.findChild<EnvironmentPanel*>()->load(BRUME_RESOURCES "/environments/sunset.exr");
    QTRY_VERIFY(!document.scene().environment->sky);
    QVERIFY(!elevation->isEnabled());
    QCOMPARE(file->text(), "sunset.exr");
    click(desk, "add_sky");
    QVERIFY(document.scene().environment->file.empty());
    click(desk, "remove_environment");
    QVERIFY(!document.scene().environment);
  }

  void the_sun_is_dragged_in_the_view() {
    Desk desk;
    Document& document = desk.document();
    click(desk, "add_sky");
    enter(desk, "sky_elevation", "6");
    const Environment before = *document.scene().environment;
    const QPoint place = sun_on_film(desk);
    desk.drag(place, place + QPoint(40, -30));
    QCOMPARE(last_step(document), "Move sun");
    QCOMPARE(step_count(document), 3);
    QVERIFY((sun_on_film(desk) - place - QPoint(40, -30)).manhattanLength() <= 2);
    QVERIFY(sky_of(desk).elevation > 6.0);
    QVERIFY(sky_of(desk).azimuth > 0.0);
    QVERIFY(document.selection().empty());
    desk.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(*document.scene().environment, before);
  }

  // With a turned environment and keyframes of the elevation: the drag sets one.
  void a_dragged_sun_follows_rotation_and_keyframes() {
    Desk desk;
    click(desk, "add_sky");
    enter(desk, "sky_elevation", "6");
    enter(desk, "environment_rotation", "10");
    click(desk, "sky_elevation_key");
    QCOMPARE(sky_of(desk).keys.elevation.size(), 1u);
    const QPoint place = sun_on_film(desk);
    desk.drag(place, place + QPoint(-20, -20));
    QVERIFY((sun_on_film(desk) - place - QPoint(-20, -20)).manhattanLength() <= 2);
    QCOMPARE(sky_of(desk).keys.elevation[0].value, sky_of(desk).elevation);
  }
};

BRUME_APP_SUITE("sky", SkyTest)
#include "sky_test.moc"
