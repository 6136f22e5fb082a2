// Imports of volumes, which Gaussians are fitted to.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <fstream>

#include "app/commands/gaussians/edit_medium.h"
#include "app/commands/gaussians/select_command.h"
#include "app/document/time/timeline.h"
#include "app/files/scene_files.h"
#include "app/import/dialogs/volume_dialog.h"
#include "app/import/scene_import.h"
#include "brume/at_time.h"
#include "brume/error.h"
#include "core/io/disk/file_bytes.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/scene_file.h"
#include "core/io/volume/volume_file.h"
#include "core/scene/lights/photometry.h"
#include "core/volume/medium_grid.h"
#include "tests/app/file_jobs.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

const fs::path smoke = BRUME_RESOURCES "/volumes/smoke_0025.vdb";

// A ball of smoke of one albedo (1, `albedo`, 0.25) that emits (3, 2, 1).
void write_fire(const fs::path& file, double albedo) {
  Medium medium;
  medium.append({{0, 0, 0}, 0.5, 1.0, {glm::dvec3(1.0, albedo, 0.25), glm::dvec3(3.0, 2.0, 1.0)}});
  const MediumSampling plan = *MediumSampling::plan(medium, 0.125, 100'000);
  write_volume(file, *plan.sample(), false, *plan.sample_colors(glm::dvec3(1.0)));
}

// Other types of grids, by names that are as long.
void rename_type(const fs::path& file, const std::string& type, const std::string& other) {
  std::string bytes = read_bytes(file);
  for (std::size_t i = bytes.find(type); i != std::string::npos; i = bytes.find(type)) {
    bytes.replace(i, type.size(), other);
  }
  std::ofstream(file) << bytes;
}

}  // namespace

class VolumeImportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_volume_is_fitted_as_the_dialog_says() {
    FileDesk desk;
    Document& document = desk.document();
    drop(desk, {smoke});
    auto* dialog = shown<VolumeDialog>(desk);
    QVERIFY(dialog);
    auto* grids = dialog->findChild<QTreeWidget*>("volume_grid");
    QCOMPARE(grids->currentItem()->text(0), "density");
    QCOMPARE(grids->currentItem()->text(2), "2 × 2 × 2.08");
    QCOMPARE(grids->topLevelItemCount(), 5);
    QTRY_VERIFY(grids->currentItem()->text(3).startsWith("1.01e-6 to "));
    auto* cost = dialog->findChild<QLabel*>("volume_cost");
    QVERIFY2(cost->text().contains(" s and "), qPrintable(cost->text()));
    dialog->findChild<QSpinBox*>("volume_count")->setValue(1'000'000);
    QVERIFY2(cost->text().contains(" min "), qPrintable(cost->text()));
    dialog->findChild<QSpinBox*>("volume_count")->setValue(8);
    dialog->findChild<QComboBox*>("volume_up")->setCurrentIndex(1);
    dialog->findChild<QComboBox*>("volume_shape")->setCurrentIndex(1);
    dialog->findChild<QLineEdit*>("volume_scale")->setText("2.5");
    click(*dialog, "import_volume");
    QCOMPARE(wait(desk), "");
    QCOMPARE(last_step(document), "Import 8 Gaussians");
    VolumeFit how;
    how.options.count = 8;
    how.options.shape = FitShape::ball;
    how.z_up = true;
    how.density_scale = 2.5;
    const auto fitted = fit_volume(smoke, how, {});
    QVERIFY(document.medium().gaussian(5) == fitted->front());
  }

  void an_up_axis_that_was_chosen_stays_with_another_grid() {
    FileDesk desk;
    drop(desk, {smoke});
    auto* dialog = shown<VolumeDialog>(desk);
    QVERIFY(dialog);
    auto* up = dialog->findChild<QComboBox*>("volume_up");
    QCOMPARE(up->currentIndex(), 0);
    QTest::keyClick(up, Qt::Key_Down);
    QCOMPARE(up->currentIndex(), 1);
    auto* grids = dialog->findChild<QTreeWidget*>("volume_grid");
    const QTreeWidgetItem* first = grids->currentItem();
    for (int i = 0; i < grids->topLevelItemCount() && grids->currentItem() == first; ++i) {
      QTreeWidgetItem* item = grids->topLevelItem(i);
      if (item->flags().testFlag(Qt::ItemIsEnabled)) grids->setCurrentItem(item);
    }
    QVERIFY(grids->currentItem() != first);
    QCOMPARE(up->currentIndex(), 1);
  }

  void a_volume_without_numbers_says_why_it_is_not_imported() {
    FileDesk desk;
    const fs::path file = desk.file("fire.vdb");
    write_fire(file, 0.5);
    rename_type(file, "Tree_float_5_4_3", "Tree_funny_5_4_3");
    drop(desk, {file});
    auto* dialog = shown<VolumeDialog>(desk);
    QVERIFY(dialog);
    auto* grids = dialog->findChild<QTreeWidget*>("volume_grid");
    for (int k = 0; k < grids->topLevelItemCount(); ++k) {
      QVERIFY(grids->topLevelItem(k)->isDisabled());
    }
    QVERIFY(!dialog->findChild<QPushButton*>("import_volume")->isEnabled());
    QVERIFY(dialog->findChild<QLabel*>("volume_problem")->text().contains("one number per voxel"));
    const auto text = [&](const char* name) {
      return grids->findItems(name, Qt::MatchExactly).at(0)->text(3);
    };
    QTRY_COMPARE(text("density"), "–");  // no numbers
    QVERIFY2(text("albedo").contains(" to "), qPrintable(text("albedo")));
  }

  void colours_and_flames_of_a_volume_come_in_as_the_dialog_says() {
    FileDesk desk;
    Document& document = desk.document();
    const fs::path file = desk.file("fire.vdb");
    write_fire(file, 0.5);
    drop(desk, {file});
    auto* dialog = shown<VolumeDialog>(desk);
    QVERIFY(dialog);
    const auto combo = [&](const char* name) { return dialog->findChild<QComboBox*>(name); };
    const auto edit = [&](const char* name) { return dialog->findChild<QLineEdit*>(name); };
    auto* import = dialog->findChild<QPushButton*>("import_volume");
    QCOMPARE(combo("volume_color")->currentText(), "Automatic: albedo");
    QCOMPARE(combo("volume_emission")->currentText(), "Automatic: emission");
    QCOMPARE(combo("volume_flame")->currentText(), "Automatic: none");
    QCOMPARE(combo("volume_color")->findText("density"), -1);
    dialog->findChild<QSpinBox*>("volume_count")->setValue(10);
    combo("volume_emission")->setCurrentIndex(combo("volume_emission")->findText("None"));
    combo("volume_flame")->setCurrentIndex(combo("volume_flame")->findText("density"));
    edit("volume_flame_scale")->setText("2");
    edit("volume_emission_scale")->setText("0.25");
    edit("volume_flame_temperature")->setText("100");
    QVERIFY(!import->isEnabled());
    edit("volume_flame_temperature")->setText("1500");
    QVERIFY(import->isEnabled());
    const std::size_t before = document.medium().size();
    QTest::mouseClick(import, Qt::LeftButton);
    QCOMPARE(wait(desk), "");
    const Medium& medium = document.medium();
    QCOMPARE(medium.size(), before + 10);
    // Half of them are the smoke's, which is red, and half the flames'.
    for (std::size_t i = before; i < before + 5; ++i) {
      QVERIFY(glm::length(*medium.optics(i).albedo - glm::dvec3(1.0, 0.5, 0.25)) < 1e-4);
      QVERIFY(medium.optics(i).emission == glm::dvec3(0.0));
      const glm::dvec3 radiance = 0.25 * black_body_radiance(1500.0);
      const GaussianOptics flame = medium.optics(i + 5);
      QVERIFY(glm::length(flame.emission - radiance) < 1e-4 * glm::length(radiance));
      QVERIFY(flame.albedo->r < 0.1);
    }
    document.undo_stack().undo();
    QCOMPARE(document.medium().size(), before);
  }

  void colours_of_a_sequence_of_volumes_are_kept() {
    FileDesk desk;
    for (const auto& [name, albedo] : {std::pair("f_1.vdb", 0.5), std::pair("f_2.vdb", 0.75)}) {
      write_fire(desk.file(name), albedo);
    }
    const fs::path folder = desk.file("made");
    VolumeFit how;
    how.options.count = 5;
    desk.import().import_volumes(frames_around(desk.file("f_1.vdb")), how, folder);
    QCOMPARE(wait(desk), "");
    const auto& frames = *desk.scene().sequences.at(0).frames;
    QCOMPARE(frames.size(), 2u);
    for (const Gaussian& g : read_gaussians(folder / "f_2.ply")) {
      QVERIFY(std::abs(g.optics.albedo->g - 0.75) < 1e-4);
      QVERIFY(std::abs(g.optics.emission.r - 3.0) < 1e-3);
    }
    for (const Gaussian& g : frames.frame(0)->gaussians) {
      QVERIFY(std::abs(g.optics.albedo->g - 0.5) < 1e-4);
    }
  }

  void a_preview_of_a_volume_is_refined_in_its_place() {
    FileDesk desk;
    Document& document = desk.document();
    VolumeFit how;
    how.options.count = 100;  // takes a second
    desk.import().import_volume(smoke, how);
    QTRY_VERIFY(document.medium().size() > 5);
    QVERIFY(desk.job().is_running());
    QCOMPARE(last_step(document), "Import 100 Gaussians");
    const Gaussian preview = document.medium().gaussian(5);
    QCOMPARE(wait(desk), "");
    QCOMPARE(step_count(document), 1);
    QCOMPARE(document.medium().size(), 105u);
    const Gaussian refined = document.medium().gaussian(5);
    QVERIFY(refined != preview);
    document.undo_stack().undo();
    QCOMPARE(document.medium().size(), 5u);

    // Edits made meanwhile stay.
    desk.import().import_volume(smoke, how);
    QTRY_VERIFY(document.medium().size() > 5);
    document.select({1});
    delete_selection(document, "Delete");
    QCOMPARE(wait(desk), "");
    QCOMPARE(last_step(document), "Refine 100 Gaussians");
    QVERIFY(!document.medium().index_of(1));
    QVERIFY(document.medium().gaussian(4) == refined);
  }

  void a_refined_preview_leaves_alone_what_is_selected_meanwhile() {
    VolumeFit how;
    how.options.count = 100;
    const ObjectRef light{ObjectRef::Kind::light, 0};
    {
      FileDesk desk;
      Document& document = desk.document();
      desk.import().import_volume(smoke, how);
      QTRY_VERIFY(document.medium().size() > 5);
      select_gaussians(document, {1});
      QCOMPARE(wait(desk), "");
      QCOMPARE(last_step(document), "Refine 100 Gaussians");
      QCOMPARE(document.selection(), std::vector<GaussianId>{1});
    }
    for (const bool is_last_operation : {true, false}) {
      FileDesk desk;
      Document& document = desk.document();
      desk.import().import_volume(smoke, how);
      QTRY_VERIFY(document.medium().size() > 5);
      if (!is_last_operation) set_homogeneous_density(document, 0.25, no_merge);
      document.set_object(light);
      const std::size_t selected = document.selection().size();
      QCOMPARE(wait(desk), "");
      QVERIFY(document.object() == light);
      QCOMPARE(document.selection().size(), selected);
      QCOMPARE(document.medium().size(), 105u);
    }
  }

  void a_preview_that_was_edited_or_hidden_stays() {
    VolumeFit how;
    how.options.count = 100;
    const std::vector<std::function<void(Document&)>> changes{
        [](Document& d) {
          const std::vector<GaussianId> one{d.medium().ids()[7]};
          set_attribute(d, one, GaussianAttribute::radius, 0.75);
        },
        [](Document& d) { d.hide({d.medium().ids()[7]}); },
        [](Document& d) { d.lock({d.medium().ids()[7]}); },
        [](Document& d) {
          d.select({d.medium().ids()[7]});
          delete_selection(d, "Delete");
        }};
    for (const auto& change : changes) {
      FileDesk desk;
      QSignalSpy warned(&desk.import(), &SceneImport::warned);
      desk.import().import_volume(smoke, how);
      QTRY_VERIFY(desk.document().medium().size() > 5);
      QVERIFY(desk.job().is_running());
      change(desk.document());
      const Medium changed = desk.document().medium();
      QCOMPARE(wait(desk), "");
      QVERIFY(desk.document().medium() == changed);
      QCOMPARE(warned.size(), 1);
      QVERIFY(warned[0][0].toString().contains("smoke_0025.vdb"));
    }
  }

  void a_fit_ends_with_its_preview() {
    VolumeFit how;
    how.options.count = 100'000;  // takes minutes
    const auto ends = [&](const std::function<void(FileDesk&)>& act, const Scene& scene) {
      FileDesk desk(scene);
      QSignalSpy cancelled(&desk.job(), &BackgroundJob::cancelled);
      desk.import().import_volume(smoke, how);
      act(desk);
      QVERIFY(cancelled.size() == 1 || cancelled.wait(patience));
      QCOMPARE(desk.document().medium().size(), scene.medium.size());
    };
    ends(
        [](FileDesk& desk) {
          QTRY_VERIFY(desk.document().medium().size() > 5);
          desk.document().undo_stack().undo();
        },
        small_scene());
    ends([](FileDesk& desk) { desk.document().open({small_scene(), {}}, {}); }, small_scene());
  }

  void a_cancelled_fit_leaves_its_preview() {
    FileDesk desk;
    VolumeFit how;
    how.options.count = 2000;
    desk.import().import_volume(smoke, how);
    QTRY_VERIFY(desk.document().medium().size() > 5);
    QVERIFY(desk.job().is_running());
    desk.job().cancel();
    QTRY_VERIFY(!desk.job().is_running());
    QCOMPARE(last_step(desk.document()), "Import 500 Gaussians");
    QCOMPARE(desk.document().medium().size(), 505u);
  }

  void fitting_can_be_cancelled() {
    FileDesk desk;
    VolumeFit how;
    how.options.count = 100'000;
    desk.import().import_volume(smoke, how);
    BackgroundJob* job = &desk.job();
    QSignalSpy cancelled(job, &BackgroundJob::cancelled);
    QVERIFY(job->is_running());
    job->cancel();
    QVERIFY(cancelled.wait(patience));
    QVERIFY(!desk.document().is_modified());
  }
};

BRUME_APP_SUITE("volume_import", VolumeImportTest)
#include "volume_import_test.moc"
