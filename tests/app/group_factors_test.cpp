// Groups change their Gaussians by factors and offsets, with keyframes.

#include <QComboBox>
#include <QLabel>
#include <QToolButton>

#include "app/commands/edit_groups.h"
#include "app/commands/edit_keys.h"
#include "app/document/timeline.h"
#include "brume/at_time.h"
#include "core/io/scene/scene_file.h"
#include "core/scene/group_effects.h"
#include "tests/app/groups_window.h"

using namespace brume;

class GroupFactorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void factors_and_offsets() {
    GroupsWindow window;
    Document& document = window.document();
    const std::string before = bytes_of(document);
    QVERIFY(!window->findChild<QLabel*>("group_hint")->isHidden());
    window.group({1, 2});
    QVERIFY(window->findChild<QLabel*>("group_hint")->isHidden());
    window.click("Group");
    const Medium plain = document.medium();
    QCOMPARE(value(window, "group_density_factor"), QString("1"));
    enter(window, "group_density_factor", "2");
    QCOMPARE(document.undo_stack().undoText(), QString("Set density factor of Group"));
    enter(window, "group_radius_offset", "0.1");
    enter(window, "group_albedo_factor_y", "0.5");
    QCOMPARE(document.medium().revision(), plain.revision());
    const Medium shown = window.shown_medium();
    QCOMPARE(shown.densities()[0], 2.0 * plain.densities()[0]);
    QCOMPARE(shown.radii()[1], plain.radii()[1] + 0.1);
    QCOMPARE(shown.optics(0).albedo->y, 0.5);
    QCOMPARE(shown.gaussian(2), plain.gaussian(2));
    QCOMPARE(shown, evaluate_at(document.scene(), 0.0).medium);
    enter(window, "group_radius_factor", "0");  // refused
    QCOMPARE(window.groups()[0].radius_factor, 1.0);
    // A drag is one step.
    const int count = document.undo_stack().count();
    drag_title(window, "group_density_factor", 40);
    QCOMPARE(document.undo_stack().count(), count + 1);
    QVERIFY(window.groups()[0].density_factor > 2.0);
    // What does not change the picture leaves the medium of frames as it is.
    const Revision revision = window.shown_medium().revision();
    window.click("Group", 2);
    rename_group(document, window.groups()[0].id, "steam");
    QCOMPARE(window.shown_medium().revision(), revision);
    QVERIFY(window.settle());
    VERIFY_UNDONE(window, before);
    QCOMPARE(window.shown_medium(), document.medium());
  }

  void a_value_of_the_active_group_is_keyed_alone() {
    GroupsWindow window;
    Document& document = window.document();
    window.group({1});
    window.group({2});
    const GroupId second = document.active_group()->id;
    QCOMPARE(second, window.groups()[1].id);
    auto* key = window->findChild<QToolButton*>("group_radius_factor_key");
    QTest::mouseClick(key, Qt::LeftButton);
    QVERIFY(key->isChecked());
    GroupKeys keys;
    keys.radius_factor = window.groups()[1].keys.radius_factor;
    QCOMPARE(keys.radius_factor.size(), std::size_t{1});
    QVERIFY(window.groups()[1].keys == keys && window.groups()[0].keys == GroupKeys());
    QTest::mouseClick(key, Qt::LeftButton);
    QVERIFY(window.groups()[1].keys == GroupKeys());
    QVERIFY(!window->findChild<QToolButton*>("environment_rotation_key")->isEnabled());
  }

  void factors_have_keyframes() {
    GroupsWindow window;
    Document& document = window.document();
    window.group({1});
    window.click("Group");
    auto* target = window->findChild<QComboBox*>("key_target");
    const int index = target->findText("Group density factor");
    QVERIFY(index >= 0);
    target->setCurrentIndex(index);
    window.key(Qt::Key_I);
    window->timeline().set_frame(30);
    enter(window, "group_density_factor", "3");
    window.key(Qt::Key_I);
    QCOMPARE(window.groups()[0].keys.density_factor.size(), std::size_t{2});
    const double density = document.medium().densities()[0];
    QCOMPARE(window.shown_medium().densities()[0], 3.0 * density);
    window->timeline().set_frame(15);
    QCOMPARE(window.shown_medium().densities()[0], 2.0 * density);
    QCOMPARE(value(window, "group_density_factor"), QString("2"));
    // From then on what is entered is a keyframe.
    enter(window, "group_density_factor", "5");
    QCOMPARE(window.groups()[0].keys.density_factor.size(), std::size_t{3});
    window->timeline().set_frame(0);
    QCOMPARE(window.shown_medium().densities()[0], density);
    document.undo_stack().undo();
    QCOMPARE(window.groups()[0].keys.density_factor.size(), std::size_t{2});
  }

  // Random sequences of all that is done with groups, among what else is done with Gaussians.
};

BRUME_APP_SUITE("group_factors", GroupFactorsTest)
#include "group_factors_test.moc"
