// Groups change their Gaussians by factors and offsets, with keyframes.

#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include "app/commands/gaussians/edit_groups.h"
#include "app/commands/objects/edit_keys.h"
#include "app/document/time/timeline.h"
#include "app/panels/time/timeline_bar.h"
#include "brume/at_time.h"
#include "core/scene/group_effects.h"
#include "tests/app/groups_window.h"

using namespace brume;

class GroupFactorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void factors_and_offsets() {
    GroupsDesk desk;
    Document& document = desk.document();
    const std::string before = bytes_of(document);
    QVERIFY(!desk.findChild<QLabel*>("group_hint")->isHidden());
    desk.group({1, 2});
    QVERIFY(desk.findChild<QLabel*>("group_hint")->isHidden());
    desk.click("Group");
    const Medium plain = document.medium();
    QCOMPARE(value(desk, "group_density_factor"), "1");
    enter(desk, "group_density_factor", "2");
    QCOMPARE(last_step(document), "Set density factor of Group");
    enter(desk, "group_radius_offset", "0.1");
    enter(desk, "group_albedo_factor_y", "0.5");
    QCOMPARE(document.medium().revision(), plain.revision());
    const Medium shown = desk.shown_medium();
    QCOMPARE(shown.densities()[0], 2.0 * plain.densities()[0]);
    QCOMPARE(shown.radii()[1], plain.radii()[1] + 0.1);
    QCOMPARE(shown.optics(0).albedo->y, 0.5);
    QCOMPARE(shown.gaussian(2), plain.gaussian(2));
    QCOMPARE(shown, evaluate_at(document.scene(), 0.0).medium);
    enter(desk, "group_radius_factor", "0");  // refused
    QCOMPARE(desk.groups()[0].radius_factor, 1.0);
    // A drag is one step.
    const int count = step_count(document);
    drag_title(desk, "group_density_factor", 40);
    QCOMPARE(step_count(document), count + 1);
    QVERIFY(desk.groups()[0].density_factor > 2.0);
    // Edits that do not change the picture leave the medium of frames as it is.
    const Revision revision = desk.shown_medium().revision();
    desk.click("Group", 2);
    rename_group(document, desk.groups()[0].id, "steam");
    QCOMPARE(desk.shown_medium().revision(), revision);
    VERIFY_UNDONE(desk, before);
    QCOMPARE(desk.shown_medium(), document.medium());
  }

  void a_value_of_the_active_group_is_keyed_alone() {
    GroupsDesk desk;
    Document& document = desk.document();
    desk.group({1});
    desk.group({2});
    const GroupId second = document.active_group()->id;
    QCOMPARE(second, desk.groups()[1].id);
    auto* key = desk.findChild<QToolButton*>("group_radius_factor_key");
    QTest::mouseClick(key, Qt::LeftButton);
    QVERIFY(key->isChecked());
    GroupKeys keys;
    keys.radius_factor = desk.groups()[1].keys.radius_factor;
    QCOMPARE(keys.radius_factor.size(), 1u);
    QVERIFY(desk.groups()[1].keys == keys && desk.groups()[0].keys == GroupKeys());
    QTest::mouseClick(key, Qt::LeftButton);
    QVERIFY(desk.groups()[1].keys == GroupKeys());
    QVERIFY(!desk.findChild<QToolButton*>("environment_rotation_key")->isEnabled());
  }

  void factors_have_keyframes() {
    GroupsDesk desk;
    Document& document = desk.document();
    desk.group({1});
    desk.click("Group");
    set_key(document, "Group density factor");
    desk.timeline().set_frame(30);
    enter(desk, "group_density_factor", "3");
    set_key(document, "Group density factor");
    QCOMPARE(desk.groups()[0].keys.density_factor.size(), 2u);
    const double density = document.medium().densities()[0];
    QCOMPARE(desk.shown_medium().densities()[0], 3.0 * density);
    desk.timeline().set_frame(15);
    QCOMPARE(desk.shown_medium().densities()[0], 2.0 * density);
    QCOMPARE(value(desk, "group_density_factor"), "2");
    // From then on what is entered is a keyframe.
    enter(desk, "group_density_factor", "5");
    QCOMPARE(desk.groups()[0].keys.density_factor.size(), 3u);
    desk.timeline().set_frame(0);
    QCOMPARE(desk.shown_medium().densities()[0], density);
    document.undo_stack().undo();
    QCOMPARE(desk.groups()[0].keys.density_factor.size(), 2u);
  }
};

BRUME_APP_SUITE("group_factors", GroupFactorsTest)
#include "group_factors_test.moc"
