// Imports from files.

#include <QLineEdit>
#include <QSpinBox>
#include <fstream>

#include "app/document/time/timeline.h"
#include "app/files/scene_files.h"
#include "app/import/dialogs/folder_dialog.h"
#include "app/import/dialogs/volume_dialog.h"
#include "app/import/scene_import.h"
#include "app/import/vtk_points.h"
#include "app/viewport/viewport.h"
#include "app/window/pages/message_bar.h"
#include "brume/at_time.h"
#include "brume/error.h"
#include "core/io/gaussians/gaussian_file.h"
#include "core/io/scene/scene_file.h"
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
