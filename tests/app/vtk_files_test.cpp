// Files of VTK, whole and damaged.

#include <sys/resource.h>

#include <QtTest/QtTest>
#include <atomic>
#include <fstream>
#include <functional>

#include "app/document/paths.h"
#include "app/import/vtk_points.h"
#include "brume/error.h"
#include "tests/app/test_window.h"

using namespace brume;

namespace {

namespace fs = std::filesystem;

const std::vector<double> coordinates{0, 0, 0, 1, 2, 4};

// The parts of a file of two points.
struct Parts {
  std::string before_root;
  std::string root = R"(version="1.0" byte_order="LittleEndian" header_type="UInt32")";
  std::string piece = R"(NumberOfPoints="2")";
  std::string arrays;  // of the points
  std::string points_type = "Float64";
  std::string points_format = R"(NumberOfComponents="3" format="ascii")";
  std::string points = "0 0 0 1 2 4";
  std::string after_data;

  [[nodiscard]] std::string text(const std::string& kind = "PolyData") const {
    const std::string cell_count = kind == "PolyData" ? "" : R"( NumberOfCells="0")";
    const std::string cells =
        kind == "PolyData" ? ""
                           : R"(<Cells><DataArray type="Int64" Name="connectivity" format="ascii"/>
<DataArray type="Int64" Name="offsets" format="ascii"/>
<DataArray type="UInt8" Name="types" format="ascii"/></Cells>)";
    return R"(<?xml version="1.0"?>)" + before_root + "<VTKFile type=\"" + kind + "\" " + root +
           "><" + kind + "><Piece " + piece + cell_count + "><PointData>" + arrays +
           "</PointData><Points><DataArray Name=\"Points\" type=\"" + points_type + "\" " +
           points_format + ">" + points + "</DataArray></Points>" + cells + "</Piece></" + kind +
           ">" + after_data + "</VTKFile>";
  }
};

std::string array(const std::string& name, const std::string& values,
                  const std::string& more = R"(NumberOfComponents="1")") {
  return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"ascii\" " + more + ">" +
         values + "</DataArray>";
}

std::string bytes_of(const auto& values) {
  return {reinterpret_cast<const char*>(values.data()),
          values.size() * sizeof(typename std::remove_cvref_t<decltype(values)>::value_type)};
}

std::string base64(const std::string& bytes) {
  return QByteArray::fromStdString(bytes).toBase64().toStdString();
}

// A compressed array of one block, whose header says `said` bytes.
std::string compressed(const std::string& bytes, std::uint32_t said) {
  // Qt puts the length before it.
  const std::string packed = qCompress(QByteArray::fromStdString(bytes)).mid(4).toStdString();
  const std::vector<std::uint32_t> header{1, said, 0, static_cast<std::uint32_t>(packed.size())};
  return base64(bytes_of(header)) + base64(packed);
}

constexpr const char* zlib_root =
    R"(version="1.0" byte_order="LittleEndian" header_type="UInt32" compressor="vtkZLibDataCompressor")";
constexpr const char* binary = R"(NumberOfComponents="3" format="binary")";

std::string in_binary(std::uint32_t said) {
  return base64(bytes_of(std::vector<std::uint32_t>{said}) + bytes_of(coordinates));
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

struct Damage {
  const char* name;
  std::function<void(Parts&)> change;
  std::function<std::string(std::string)> cut = {};  // of the text that comes of it
};

std::string appended(std::uint64_t offset, const std::string& data) {
  return R"(NumberOfComponents="3" format="appended" offset=")" + std::to_string(offset) + "\"" +
         data;
}

const std::vector<Damage>& damages() {
  static const std::vector<Damage> all{
      {"nested_deeply",
       [](Parts& p) { p.after_data = repeated("<a>", 200'000) + repeated("</a>", 200'000); }},
      {"nested_without_end", [](Parts& p) { p.after_data = repeated("<a>", 100'000); }},
      {"nested_in_points",
       [](Parts& p) { p.points = repeated("<a>", 100'000) + repeated("</a>", 100'000); }},
      {"components_huge",
       [](Parts& p) { p.points_format = R"(NumberOfComponents="1000000000" format="ascii")"; }},
      {"components_of_array_huge",
       [](Parts& p) { p.arrays = array("radius", "1 1", R"(NumberOfComponents="1000000000")"); }},
      {"components_zero",
       [](Parts& p) { p.points_format = R"(NumberOfComponents="0" format="ascii")"; }},
      {"components_negative",
       [](Parts& p) { p.points_format = R"(NumberOfComponents="-3" format="ascii")"; }},
      {"components_two",
       [](Parts& p) { p.points_format = R"(NumberOfComponents="2" format="ascii")"; }},
      {"points_huge", [](Parts& p) { p.piece = R"(NumberOfPoints="1000000000")"; }},
      {"points_beyond_64_bits",
       [](Parts& p) { p.piece = R"(NumberOfPoints="99999999999999999999999")"; }},
      {"points_negative", [](Parts& p) { p.piece = R"(NumberOfPoints="-2")"; }},
      {"points_no_number", [](Parts& p) { p.piece = R"(NumberOfPoints="two")"; }},
      {"points_none", [](Parts& p) { p.piece = R"(NumberOfPoints="0")"; }},
      {"points_unsaid", [](Parts& p) { p.piece = ""; }},
      {"points_too_few", [](Parts& p) { p.piece = R"(NumberOfPoints="3")"; }},
      {"coordinate_nan", [](Parts& p) { p.points = "nan 0 0 1 2 4"; }},
      {"coordinate_infinite", [](Parts& p) { p.points = "0 0 0 1 2 inf"; }},
      {"coordinate_too_far", [](Parts& p) { p.points = "0 0 0 1 2 1e300"; }},
      {"coordinate_no_number", [](Parts& p) { p.points = "0 0 zero 1 2 4"; }},
      {"radius_zero", [](Parts& p) { p.arrays = array("radius", "1 0"); }},
      {"radius_nan", [](Parts& p) { p.arrays = array("radius", "nan 1"); }},
      {"radius_of_two_numbers",
       [](Parts& p) { p.arrays = array("radius", "1 1 1 1", R"(NumberOfComponents="2")"); }},
      {"radius_too_short", [](Parts& p) { p.arrays = array("radius", "1"); }},
      {"density_negative", [](Parts& p) { p.arrays = array("density", "1 -1"); }},
      {"entities_that_multiply",
       [](Parts& p) {
         p.before_root = R"(<!DOCTYPE z [<!ENTITY a "aaaaaaaaaaaaaaaaaaaaaaaaaa">)";
         for (char c = 'b'; c < 'k'; ++c) {
           p.before_root += std::string("<!ENTITY ") + c + " \"" +
                            repeated(std::string("&") + static_cast<char>(c - 1) + ";", 10) + "\">";
         }
         p.before_root += "]>";
         p.points = "&j;";
       }},
      {"entity_of_itself",
       [](Parts& p) {
         p.before_root = R"(<!DOCTYPE z [<!ENTITY a "&a;">]>)";
         p.points = "&a;";
       }},
      {"entity_of_another_file",
       [](Parts& p) {
         p.before_root = R"(<!DOCTYPE z [<!ENTITY a SYSTEM "/dev/zero">]>)";
         p.points = "&a;";
       }},
      {"base64_bad", [](Parts& p) { p.points_format = binary, p.points = "!!!!####"; }},
      {"base64_empty", [](Parts& p) { p.points_format = binary, p.points = ""; }},
      {"binary_cut",
       [](Parts& p) { p.points_format = binary, p.points = in_binary(48).substr(0, 40); }},
      {"binary_longer_than_said",
       [](Parts& p) {
         p.points_format = binary, p.points = in_binary(0xfffffff0);
         p.points.resize(20);
       }},
      {"binary_shorter_than_needed",
       [](Parts& p) { p.points_format = binary, p.points = in_binary(40); }},
      {"compressed_nothing",
       [](Parts& p) { p.root = zlib_root, p.points_format = binary, p.points = ""; }},
      {"compressed_damaged",
       [](Parts& p) {
         p.root = zlib_root, p.points_format = binary;
         p.points =
             base64(bytes_of(std::vector<std::uint32_t>{1, 48, 0, 12})) + base64("no zlib here");
       }},
      {"compressed_length_wrong",
       [](Parts& p) {
         p.root = zlib_root, p.points_format = binary,
         p.points = compressed(bytes_of(coordinates), 40);
       }},
      {"compressed_bomb",
       [](Parts& p) {
         p.root = zlib_root, p.points_format = binary, p.piece = R"(NumberOfPoints="40000000")";
         p.points = compressed(std::string(100'000'000, '\0'), 960'000'000);
       }},
      {"compressed_blocks_huge",
       [](Parts& p) {
         p.root = zlib_root, p.points_format = binary;
         p.points = base64(bytes_of(std::vector<std::uint32_t>{0xfffffff, 0xfffffff, 0, 9}));
       }},
      {"compressor_unknown",
       [](Parts& p) {
         p.root = R"(version="1.0" byte_order="LittleEndian" compressor="vtkNoSuchCompressor")";
         p.points_format = binary, p.points = compressed(bytes_of(coordinates), 48);
       }},
      {"appended_beyond_the_end",
       [](Parts& p) {
         p.points_format = appended(1'000'000'000'000, ""), p.points = "";
         p.after_data = R"(<AppendedData encoding="raw">_abc</AppendedData>)";
       }},
      {"appended_cut",
       [](Parts& p) {
         p.points_format = appended(0, ""), p.points = "";
         p.after_data = R"(<AppendedData encoding="base64">_AA</AppendedData>)";
       }},
      {"appended_nowhere", [](Parts& p) { p.points_format = appended(0, ""), p.points = ""; }},
      {"type_unknown", [](Parts& p) { p.points_type = "Float99"; }},
      {"cut_in_the_middle", [](Parts&) {},
       [](const std::string& text) { return text.substr(0, text.size() / 2); }},
      {"cut_before_the_end", [](Parts&) {},
       [](const std::string& text) { return text.substr(0, text.size() - 12); }},
      {"no_xml", [](Parts&) {}, [](const std::string&) { return std::string("no XML"); }},
      {"empty", [](Parts&) {}, [](const std::string&) { return std::string(); }},
      {"zero_bytes", [](Parts&) {}, [](const std::string&) { return std::string(10'000, '\0'); }},
      {"no_points", [](Parts&) {},
       [](std::string text) {
         const std::size_t at = text.find("<Points>");
         return text.erase(at, text.find("</Points>") + 9 - at);
       }},
      {"no_piece", [](Parts&) {},
       [](std::string text) {
         const std::size_t at = text.find("<Piece");
         return text.erase(at, text.find("</Piece>") + 8 - at);
       }},
  };
  return all;
}

long max_memory_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return usage.ru_maxrss;  // [KiB]
}

}  // namespace

class VtkFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void text_binary_compressed_and_appended_points_are_the_same_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("name");
    const auto add = [](const char* name, const std::string& text, const char* file) {
      QTest::newRow(name) << QString::fromStdString(text) << QString(file);
    };
    Parts parts;
    parts.arrays = array("radius", "0.5 0.25") + array("density", "2 3");
    add("text", parts.text(), "a.vtp");
    add("grid", parts.text("UnstructuredGrid"), "a.vtu");
    parts.points_format = binary;
    parts.points = in_binary(48);
    add("binary", parts.text(), "a.vtp");
    Parts packed = parts;
    packed.root = zlib_root;
    packed.points = compressed(bytes_of(coordinates), 48);
    add("compressed", packed.text(), "a.vtp");
    parts.after_data = "<AppendedData encoding=\"base64\">_" + parts.points + "</AppendedData>";
    parts.points_format = appended(0, "");
    parts.points = "";
    add("appended", parts.text(), "a.vtp");
  }
  void text_binary_compressed_and_appended_points_are_the_same() {
    QFETCH(QString, text);
    QFETCH(QString, name);
    const auto gaussians = read_vtk_points(write(name.toStdString(), text.toStdString()));
    const std::vector<Gaussian> expected{{{0, 0, 0}, 0.5, 2.0}, {{1, 2, 4}, 0.25, 3.0}};
    QVERIFY(gaussians == expected);
  }

  void damaged_files_are_refused_by_name_data() {
    QTest::addColumn<QString>("kind");
    QVERIFY(damages().size() >= 40);
    for (const Damage& damage : damages()) {
      for (const char* kind : {"PolyData", "UnstructuredGrid"}) {
        QTest::addRow("%s of %s", damage.name, kind) << QString(kind);
      }
    }
  }
  // One line that begins with the file's name; the editor lives on, and no process took much
  // memory.
  void damaged_files_are_refused_by_name() {
    QFETCH(QString, kind);
    const QString row = QTest::currentDataTag();
    const auto damage = std::find_if(damages().begin(), damages().end(), [&](const Damage& d) {
      return row.startsWith(QString(d.name) + " of");
    });
    Parts parts;
    damage->change(parts);
    std::string text = parts.text(kind.toStdString());
    if (damage->cut) text = damage->cut(std::move(text));
    const fs::path file = write(kind == "PolyData" ? "a.vtp" : "a.vtu", text);
    std::string problem;
    try {
      read_vtk_points(file);
    } catch (const InputError& error) {
      problem = error.what();
    }
    QVERIFY2(problem.starts_with(file.string() + ": "), problem.c_str());
    QVERIFY2(problem.size() < file.string().size() + 300, problem.c_str());
    QVERIFY2(problem.find('\n') == std::string::npos, problem.c_str());
    QVERIFY2(problem.find(file.string(), 1) == std::string::npos, problem.c_str());
    QVERIFY(max_memory_of_children() < 700 * 1024);
  }

  void more_points_than_are_allowed_are_refused() {
    const fs::path file = write("a.vtp", Parts().text());
    QCOMPARE(read_vtk_points(file, nullptr, 2).size(), 2u);
    QVERIFY_EXCEPTION_THROWN(read_vtk_points(file, nullptr, 1), InputError);
  }

  void ids_are_read_only_if_they_are_wanted() {
    Parts parts;
    parts.arrays = array("id", "7 0.5");
    const fs::path file = write("a.vtp", parts.text());
    QCOMPARE(read_vtk_points(file).size(), 2u);
    std::vector<GaussianNumber> ids;
    QVERIFY_EXCEPTION_THROWN(read_vtk_points(file, &ids), InputError);
    parts.arrays = array("id", "7 5");
    read_vtk_points(write("a.vtp", parts.text()), &ids);
    QVERIFY(ids == (std::vector<GaussianNumber>{7, 5}));
  }

  // Deep nesting keeps VTK busy for long.
  void reading_can_be_stopped() {
    Parts parts;
    parts.after_data = repeated("<a>", 5'000'000);
    const fs::path file = write("a.vtp", parts.text());
    std::stop_source stop;
    std::atomic<bool> ended = false;
    std::vector<Gaussian> gaussians(1);
    std::jthread reading([&] {
      gaussians = read_vtk_points(file, nullptr, 10, stop.get_token());
      ended = true;
    });
    QTest::qWait(100);
    stop.request_stop();
    QVERIFY(QTest::qWaitFor([&] { return ended.load(); }, 60000));
    reading.join();
    QVERIFY(gaussians.empty());
  }

 private:
  fs::path write(const std::string& name, const std::string& text) {
    fs::path file = to_path(folder_.filePath(QString::fromStdString(name)));
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  QTemporaryDir folder_;
};

BRUME_APP_SUITE("vtk_files", VtkFilesTest)
#include "vtk_files_test.moc"
