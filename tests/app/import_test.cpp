// Imports from files.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <fstream>

#include "app/commands/edit_medium.h"
#include "app/commands/select_command.h"
#include "app/document/timeline.h"
#include "app/files/scene_files.h"
#include "app/import/folder_dialog.h"
#include "app/import/scene_import.h"
#include "app/import/volume_dialog.h"
#include "app/import/vtk_points.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
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
const std::vector<Gaussian> two{{{0, 1, 0}, 0.5, 0.1}, {{0, 2, 0}, 0.7, 0.2}};

constexpr const char* ply_triangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

// Two points in a VTK file.
void write_vtp(const fs::path& file, const std::string& points, const std::string& arrays) {
  write_text(file,
             "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData>"
             "<Piece NumberOfPoints=\"2\"><PointData>" +
                 arrays +
                 "</PointData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
                 "format=\"ascii\">" +
                 points + "</DataArray></Points></Piece></PolyData></VTKFile>");
}

std::string array(const std::string& name, const std::string& values) {
  return "<DataArray type=\"Float32\" Name=\"" + name + "\" format=\"ascii\">" + values +
         "</DataArray>";
}

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
  write_text(file, bytes);
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class ImportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tables_meshes_and_environments_are_dropped_each_as_one_step() {
    FileDesk desk;
    Document& document = desk.document();
    write_gaussians(desk.file("two.csv"), two);
    write_gaussians(desk.file("two.ply"), two);
    for (const char* name : {"two.csv", "two.ply"}) {
      drop(desk, {desk.file(name)});
      QCOMPARE(wait(desk), "");
      QCOMPARE(last_step(document), "Import 2 Gaussians");
      QCOMPARE(document.selection().size(), 2u);
    }
    QCOMPARE(document.medium().size(), 9u);
    drop(desk, {BRUME_RESOURCES "/meshes/bunny.obj"});
    QCOMPARE(wait(desk), "");
    QCOMPARE(last_step(document), "Import bunny.obj");
    QCOMPARE(document.scene().surfaces.size(), 1u);
    write_text(desk.file("face.ply"), ply_triangle);
    drop(desk, {desk.file("face.ply")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(document.scene().surfaces.size(), 2u);
    drop(desk, {BRUME_RESOURCES "/environments/sunset.exr"});
    QCOMPARE(wait(desk), "");
    QVERIFY(document.scene().environment);
    QCOMPARE(step_count(document), 5);
  }

  void an_address_on_the_web_is_not_sought_as_a_file() {
    TestWindow window;
    drop(window, {}, {QUrl("https://example.org/cup.obj")});
    QCOMPARE(step_count(window->document()), 0);
    const auto* bar = window->findChild<MessageBar*>();
    QVERIFY(bar->message().startsWith("https://example.org/cup.obj is no file of this computer"));
  }

  void dropped_meshes_are_imported_in_one_step() {
    FileDesk desk;
    Document& document = desk.document();
    const char* text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (const char* name : {"cup.obj", "pot.obj", "m_1.obj", "m_2.obj"}) {
      write_text(desk.file(name), text);
    }
    write_gaussians(desk.file("two.csv"), two);
    drop(desk, {desk.file("cup.obj"), desk.file("pot.obj"), desk.file("two.csv")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(document.scene().surfaces.size(), 2u);
    QCOMPARE(document.medium().size(), 7u);
    QCOMPARE(last_step(document), "Import 3 files");
    QCOMPARE(step_count(document), 1);
    document.undo_stack().undo();
    QVERIFY(document.scene().surfaces.empty() && document.medium().size() == 5);
    QVERIFY(!document.is_modified());
    // Numbered meshes are no frames of a sequence.
    drop(desk, {desk.file("m_1.obj"), desk.file("m_2.obj")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(document.scene().surfaces.size(), 2u);
  }

  void numbered_ply_files_are_a_sequence_or_meshes_by_what_is_in_them() {
    FileDesk desk;
    for (const char* name : {"g_1.ply", "g_2.ply"}) write_gaussians(desk.file(name), two);
    drop(desk, {desk.file("g_1.ply"), desk.file("g_2.ply")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(desk.scene().sequences.size(), 1u);
    for (const char* name : {"f_1.ply", "f_2.ply"}) write_text(desk.file(name), ply_triangle);
    drop(desk, {desk.file("f_1.ply"), desk.file("f_2.ply")});
    QCOMPARE(wait(desk), "");
    QCOMPARE(desk.scene().surfaces.size(), 2u);
  }

  void unsupported_drops_are_reported() {
    TestWindow window;
    fs::create_directory(window.file("folder"));
    write_text(window.file("cup.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write_text(window.file("photo.jpg"), "");
    auto* bar = window->findChild<MessageBar*>();
    for (const char* name : {"folder", "photo.jpg", "."}) {
      drop(window, {window.file(name)});
      QVERIFY2(bar->isVisible() && bar->message().contains(".obj"), name);
      bar->hide();
    }
    drop(window, {window.file("cup.obj"), window.file("photo.jpg"), window.file("scene.brume")});
    QVERIFY2(bar->message().startsWith("photo.jpg, scene.brume: "), qPrintable(bar->message()));
    QCOMPARE(wait(window), "");
    QCOMPARE(window.scene().surfaces.size(), 1u);
  }

  void file_errors_are_reported_and_change_nothing() {
    FileDesk desk;
    write_text(desk.file("bad.csv"), "x,y,z,radius,density\n0,0,0,-1,1\n");
    drop(desk, {desk.file("bad.csv")});
    QVERIFY(wait(desk).contains("line 2, radius"));
    QVERIFY(!desk.document().is_modified());
    drop(desk, {desk.file("bad.csv"), desk.file("other.csv")});  // no sequence
    QVERIFY(!desk.document().is_modified());
    QVERIFY(!can_import("readme.txt"));
  }

  void points_of_vtk_files_bring_radius_and_density() {
    FileDesk desk;
    const auto points = [&](const char* name, const std::string& arrays) {
      write_vtp(desk.file(name), "0 0 0 1 2 4", arrays);
      return desk.file(name);
    };
    const auto full = points("full.vtp", array("radius", "0.5 0.25") + array("density", "2 3"));
    drop(desk, {full});
    QCOMPARE(wait(desk), "");
    QVERIFY(desk.document().medium().gaussian(6) == (Gaussian{{1, 2, 4}, 0.25, 3.0}));
    QCOMPARE(last_step(desk.document()), "Import 2 Gaussians");
    const auto bare = read_vtk_points(points("bare.vtp", ""));
    QCOMPARE(bare[0].density, 1.0);
    QCOMPARE(bare[0].radius, std::cbrt(8.0 / 2.0));
    QVERIFY_EXCEPTION_THROWN(read_vtk_points(points("bad.vtp", array("radius", "1 0"))),
                             InputError);
    write_text(desk.file("junk.vtp"), "no XML");
    QVERIFY_EXCEPTION_THROWN(read_vtk_points(desk.file("junk.vtp")), InputError);
    QVERIFY_EXCEPTION_THROWN(read_vtk_points(desk.file("none.vtu")), InputError);
  }

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
    QVERIFY2(cost->text().contains(" min and "), qPrintable(cost->text()));
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
    QTest::keyClick(grids, first == grids->topLevelItem(0) ? Qt::Key_Down : Qt::Key_Up);
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

  void a_sequence_plays_and_can_be_frozen() {
    TestWindow window;
    Document& document = window->document();
    const std::vector<GaussianNumber> ids{0, 1};
    for (int frame = 1; frame <= 3; ++frame) {
      std::vector<Gaussian> moved = two;
      for (Gaussian& gaussian : moved) gaussian.center.x += frame;
      const std::string name = "steam_" + std::to_string(frame) + ".csv";
      write_gaussians(window.file(name.c_str()), moved, ids);
    }
    window->timeline().set_frame(30);
    drop(window, {window.file("steam_2.csv"), window.file("steam_3.csv")});
    QCOMPARE(wait(window), "");
    QCOMPARE(last_step(document), "Import sequence steam_%d.csv");
    const MediumSequence& sequence = document.scene().sequences.at(0);
    QCOMPARE(sequence.first, 1);
    QCOMPARE(sequence.last, 3);
    QCOMPARE(sequence.start, 1.0);
    window->timeline().set_frame(31);
    QVERIFY(window.settle());
    const Scene& seen = *window.shown().request.scene;
    QCOMPARE(seen.medium.size(), 7u);
    QVERIFY(std::abs(seen.medium.centers()[5].x - 2.0) < 1e-12);
    QVERIFY(window->files().save_to(window.file("steam.brume")));
    QCOMPARE(evaluate_at(load_scene(window.file("steam.brume")), 31 / 30.0).medium, seen.medium);
    trigger(window, "Bake");
    QCOMPARE(last_step(document), "Bake 2 Gaussians");
    trigger(window, "Remove Seq");
    QVERIFY(document.scene().sequences.empty());
    document.undo_stack().undo();
    QCOMPARE(document.scene().sequences.size(), 1u);
    document.undo_stack().setIndex(0);
    QVERIFY(document.scene().sequences.empty());
  }

  // Points are named by their ids, wherever they stand in a file, and between frames they move.
  void points_of_vtk_files_become_a_sequence_of_files() {
    FileDesk desk;
    const std::string both = array("radius", "0.5 0.5");
    write_vtp(desk.file("p_01.vtp"), "0 0 0  8 0 0", both + array("id", "4 9"));
    write_vtp(desk.file("p_02.vtp"), "8 2 0  0 2 0", both + array("id", "9 4"));
    drop(desk, {desk.file("p_01.vtp"), desk.file("p_02.vtp")});
    auto* dialog = shown<FolderDialog>(desk);
    QVERIFY(dialog);
    const fs::path folder = desk.file("made");
    dialog->findChild<QLineEdit*>("sequence_folder")->setText(to_qstring(folder));
    click(*dialog, "import_sequence");
    QCOMPARE(wait(desk), "");
    const Scene& scene = desk.scene();
    QCOMPARE(last_step(desk.document()), "Import sequence p_%02d.ply");
    QCOMPARE(scene.sequences.size(), 1u);
    const std::vector<Gaussian> halfway =
        sequence_at(scene.sequences[0], 0.5 / 30.0, glm::dvec3(1.0));
    QCOMPARE(halfway.size(), 2u);
    QVERIFY(halfway[0].center == glm::dvec3(0, 1, 0));
    QVERIFY(halfway[1].center == glm::dvec3(8, 1, 0));
    QCOMPARE(files_in(folder), 2u);
    desk.document().save(desk.file("p.brume"));
    const Scene loaded = load_scene(desk.file("p.brume"));
    QVERIFY(*loaded.sequences.at(0).frames->frame(0) == *scene.sequences[0].frames->frame(0));

    // A bad frame is reported, and nothing is written.
    write_vtp(desk.file("p_03.vtp"), "8 2 0  0 2 0", both + array("id", "9 9"));
    desk.import().import_vtk_files(frames_around(desk.file("p_01.vtp")), desk.file("bad"));
    const QString problem = wait(desk);
    QVERIFY2(problem.contains("p_03.vtp") && problem.contains("twice"), qPrintable(problem));
    QVERIFY(!fs::exists(desk.file("bad")));
    QCOMPARE(step_count(desk.document()), 1);
  }

  void volumes_become_a_sequence_of_files() {
    FileDesk desk;
    desk.import().import_sequence(smoke);
    auto* dialog = shown<VolumeDialog>(desk);
    QVERIFY(dialog);
    dialog->findChild<QSpinBox*>("volume_count")->setValue(6);
    const fs::path folder = desk.file("made");
    dialog->findChild<QLineEdit*>("sequence_folder")->setText(to_qstring(folder));
    click(*dialog, "import_volume");
    QCOMPARE(wait(desk), "");
    QCOMPARE(desk.scene().sequences.size(), 1u);
    QCOMPARE(desk.scene().sequences[0].frames->size(), 2u);
    QCOMPARE(read_gaussians(folder / "smoke_0026.ply").size(), 6u);
    QCOMPARE(files_in(folder), 2u);
  }
};

BRUME_APP_SUITE("import", ImportTest)
#include "import_test.moc"
