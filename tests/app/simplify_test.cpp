// Edit > Simplify: fewer Gaussians in one step, that undo takes back.

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/window/dialogs/simplify_dialog.h"
#include "core/math/random_source.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

// Small ones close together, and one far away.
Scene crowded_scene() {
  Scene scene = small_scene();
  scene.medium = {};
  RandomSource random(3);
  for (int i = 0; i < 300; ++i) scene.medium.append({0.4 * random.in_ball(), 0.15, 0.2});
  scene.medium.append({{1.2, 0.0, 0.0}, 0.1, 0.5});
  return scene;
}

class SimplifyWindow : public TestWindow {
 public:
  explicit SimplifyWindow(const Scene& scene = crowded_scene()) : TestWindow(scene) {}

  SimplifyDialog& show() {
    (*this)->findChild<QAction*>("edit.simplify")->trigger();
    return *(*this)->findChild<SimplifyDialog*>();
  }
  void simplify(const char* percent) {
    SimplifyDialog& dialog = show();
    enter(*this, "simplify_error", percent);
    brume::click(dialog, "simplify_now");
  }
};

}  // namespace

class SimplifyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void is_one_step_that_undo_takes_back() {
    SimplifyWindow window;
    const Scene before = window.scene();
    window.simplify("5");
    QTRY_COMPARE(step_count(window.document()), 1);
    QCOMPARE(last_step(window.document()), "Simplify 301 Gaussians");
    const std::size_t left = window.document().medium().size();
    QVERIFY2(left < 250, qPrintable(QString::number(left)));
    // The one that stands alone is as it was.
    QVERIFY(window.document().medium().index_of(before.medium.ids()[300]));
    window.document().undo_stack().undo();
    QVERIFY(window.scene() == before);
    window.document().undo_stack().redo();
    QCOMPARE(window.document().medium().size(), left);
  }

  void acts_on_what_is_selected() {
    SimplifyWindow window;
    const auto ids = window.document().medium().ids();
    select_gaussians(window.document(), {ids.begin(), ids.begin() + 100});
    SimplifyDialog& dialog = window.show();
    QCOMPARE(dialog.findChild<QLabel*>("simplify_count")->text(), "Merges 100 Gaussians, selected");
    const auto* result = dialog.findChild<QLabel*>("simplify_result");
    QTRY_VERIFY2(result->text().startsWith("Leaves ") || result->text().startsWith("None "),
                 qPrintable(result->text()));
    enter(window, "simplify_error", "20");
    QTRY_VERIFY(result->text().startsWith("Leaves "));
    const QString said = result->text();
    brume::click(dialog, "simplify_now");
    QTRY_COMPARE(last_step(window.document()), "Simplify 100 Gaussians");
    const std::size_t left = window.document().medium().size() - 201;
    QVERIFY2(said.startsWith(QString("Leaves %1,").arg(left)), qPrintable(said));
    QCOMPARE(window.document().selection().size(), left);  // all of them, those unchanged too
    for (std::size_t i = 100; i < 301; ++i) {
      QVERIFY(window.document().medium().index_of(crowded_scene().medium.ids()[i]));
    }
  }

  void counts_again_when_the_fog_has_changed() {
    SimplifyWindow window;
    Document& document = window.document();
    const auto* count = window.show().findChild<QLabel*>("simplify_count");
    QCOMPARE(count->text(), "Merges all 301 Gaussians");
    const auto ids = document.medium().ids();
    document.hide({ids.begin(), ids.begin() + 40});
    QTRY_COMPARE(count->text(), "Merges all 261 Gaussians");
    add_gaussian(document, {{0, 1, 0}, 0.1, 1.0});
    QTRY_COMPARE(count->text(), "Merges 1 Gaussian, selected");
    document.select({});
    QTRY_COMPARE(count->text(), "Merges all 262 Gaussians");
  }

  void leaves_alone_what_is_locked_or_hidden() {
    SimplifyWindow window;
    const auto ids = window.document().medium().ids();
    const std::vector<GaussianId> locked{ids.begin(), ids.begin() + 40};
    const std::vector<GaussianId> hidden{ids.begin() + 40, ids.begin() + 80};
    window.document().lock(locked);
    window.document().hide(hidden);
    window.simplify("20");
    QTRY_COMPARE(last_step(window.document()), "Simplify 221 Gaussians");
    for (const GaussianId id : locked) QVERIFY(window.document().medium().index_of(id));
    for (const GaussianId id : hidden) QVERIFY(window.document().medium().index_of(id));
  }

  void says_that_nothing_can_be_merged() {
    SimplifyWindow window(small_scene());
    window.simplify("1");
    QTRY_VERIFY(window->statusBar()->currentMessage().contains("No Gaussians"));
    QCOMPARE(step_count(window.document()), 0);
  }

  void refuses_what_is_no_error() {
    SimplifyWindow window;
    SimplifyDialog& dialog = window.show();
    enter(window, "simplify_error", "200");
    const QString text = dialog.findChild<QLabel*>("simplify_count")->text();
    QVERIFY2(text.contains("0.01 to 100"), qPrintable(text));
  }
};

BRUME_APP_SUITE("simplify", SimplifyTest)
#include "simplify_test.moc"
