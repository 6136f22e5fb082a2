// Random sequences of everything that makes a step: undo all gives the document as it was, byte for
// byte, redo all the end, and what is saved in between comes back.

#include <QAbstractItemModelTester>
#include <QClipboard>

#include "app/panels/gaussians/gaussian_table_model.h"
#include "brume/at_time.h"
#include "core/io/scene/scene_file.h"
#include "tests/app/random_hands.h"
#include "tests/app/test_window.h"

using namespace brume;

class HistoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // So do the table of all Gaussians and the selection.
  void visible_medium_follows_any_edit() {
    for (unsigned seed = 1; seed <= 100; ++seed) {
      QGuiApplication::clipboard()->clear();
      Document document;
      document.open(starting_document(), {});
      GaussianTableModel table(document);
      on_medium_edit(document, &table, [&table](const MediumEdit& edit) {
        if (!table.follow(edit)) table.reload();
      });
      const QAbstractItemModelTester tester(&table,
                                            QAbstractItemModelTester::FailureReportingMode::Fatal);
      RandomHands hands(document, seed);
      for (int k = 0; k < 50; ++k) {
        const Revision before = document.visible_snapshot()->medium.revision();
        const Revision medium = document.medium().revision();
        const std::vector<GaussianId> hidden = document.hidden();
        const Groups groups = document.scene().groups;
        const glm::dvec3 albedo = document.scene().optics.albedo;
        hands.act();
        Medium expected = document.medium();
        MediumEdit::remove(expected, document.hidden()).apply(expected);
        Scene scene = document.scene();
        scene.medium = expected;
        apply_groups(scene);
        expected = scene.medium;
        const Medium& visible = document.visible_snapshot()->medium;
        QVERIFY2(visible == expected, qPrintable(QString::number(seed)));
        for (const GaussianId id : document.selection()) QVERIFY(document.is_editable(id));
        const std::span<const GaussianId> ids = document.medium().ids();
        QCOMPARE(static_cast<std::size_t>(table.rowCount()), ids.size());
        for (int row = 0; row < table.rowCount(); ++row) {
          QCOMPARE(table.id(row), ids[static_cast<std::size_t>(row)]);
        }
        if (medium == document.medium().revision() && hidden == document.hidden() &&
            groups == document.scene().groups && albedo == document.scene().optics.albedo) {
          QCOMPARE(visible.revision(), before);
        }
      }
    }
  }

  void any_edit_can_be_undone_and_redone() {
    constexpr unsigned sequences = 2000;
    constexpr int acts = 50;
    int steps = 0;
    for (unsigned seed = 1; seed <= sequences; ++seed) {
      QGuiApplication::clipboard()->clear();
      Document document;
      document.open(starting_document(), {});
      const std::string before = bytes_of(document);
      RandomHands hands(document, seed);
      for (int k = 0; k < acts; ++k) hands.act();
      const std::string after = bytes_of(document);
      const bool was_modified = document.is_modified();
      const int index = document.undo_stack().index();
      steps += index;
      document.undo_stack().setIndex(0);
      QVERIFY2(bytes_of(document) == before, qPrintable(QString::number(seed)));
      QVERIFY(!document.is_modified());
      document.undo_stack().setIndex(index);
      QVERIFY2(bytes_of(document) == after, qPrintable(QString::number(seed)));
      QCOMPARE(document.is_modified(), was_modified);
    }
    QVERIFY2(steps > 20 * static_cast<int>(sequences), qPrintable(QString::number(steps)));
  }

  // Saving in the middle, and what the file then holds, changes nothing about that.
  void saving_keeps_the_history() {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "saved.brume";
    for (unsigned seed = 1; seed <= 50; ++seed) {
      Document document;
      document.open(starting_document(), {});
      const std::string before = bytes_of(document);
      RandomHands hands(document, seed);
      for (int k = 0; k < 25; ++k) hands.act();
      document.save(file);
      document.set_time(0.0);  // the moment that a file's values are of
      QVERIFY(!document.is_modified());
      const SceneDocument loaded = load_document(file);
      QCOMPARE(document_to_json(loaded, "/"), bytes_of(document));
      const std::string middle = bytes_of(document);
      const int saved_at = document.undo_stack().index();
      for (int k = 0; k < 25; ++k) hands.act();
      document.set_time(0.0);
      const std::string after = bytes_of(document);
      const int end = document.undo_stack().index();
      if (end >= saved_at && document.undo_stack().cleanIndex() == saved_at) {
        document.undo_stack().setIndex(saved_at);
        QVERIFY(bytes_of(document) == middle);
        QVERIFY(!document.is_modified());
      }
      document.undo_stack().setIndex(0);
      QVERIFY(bytes_of(document) == before);
      document.undo_stack().setIndex(end);
      QVERIFY(bytes_of(document) == after);
    }
  }
};

BRUME_APP_SUITE("history", HistoryTest)
#include "history_test.moc"
