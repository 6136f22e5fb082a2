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
  std::string before_root{};
  std::string root = R"(version="1.0" byte_order="LittleEndian" header_type="UInt32")";
  std::string piece = R"(NumberOfPoints="2")";
  std::string arrays{};  // of the points
  std::string points_type = "Float64";
  std::string points_format = R"(NumberOfComponents="3" format="ascii")";
  std::string points = "0 0 0 1 2 4";
  std::string after_data{};

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
  Parts parts{};
  std::function<std::string(std::string)> cut = {};  // of the text that comes of it
};

std::string ascii(const char* components) {
  return std::string("NumberOfComponents=\"") + components + R"(" format="ascii")";
}

std::string points_counted(const char* count) {
  return std::string("NumberOfPoints=\"") + count + '"';
}

Parts in_base64(const std::string& points) {
  return {.points_format = binary, .points = points};
}

Parts compressed_points(const std::string& points, const char* count = "2") {
  return {
      .root = zlib_root, .piece = points_counted(count), .points_format = binary, .points = points};
}

Parts appended_points(std::uint64_t offset, const std::string& data) {
  return {.points_format =
              R"(NumberOfComponents="3" format="appended" offset=")" + std::to_string(offset) + '"',
          .points = "",
          .after_data = data};
}

Parts with_entity(const std::string& entity, const char* points = "&a;") {
  return {.before_root = "<!DOCTYPE z [" + entity + "]>", .points = points};
}

// Ten times as many of each as of the one before.
std::string multiplying_entities() {
  std::string entities = R"(<!ENTITY a "aaaaaaaaaaaaaaaaaaaaaaaaaa">)";
  for (char c = 'b'; c < 'k'; ++c) {
    entities += std::string("<!ENTITY ") + c + " \"" +
                repeated(std::string("&") + static_cast<char>(c - 1) + ";", 10) + "\">";
  }
  return entities;
}

// Without all from one word to another.
auto without(const std::string& first, const std::string& last) {
  return [=](std::string text) {
    const std::size_t begin = text.find(first);
    return text.erase(begin, text.find(last) + last.size() - begin);
  };
}

const std::vector<Damage>& damages() {
  const std::string bytes = bytes_of(coordinates);
  const auto header = [](const std::vector<std::uint32_t>& numbers) {
    return base64(bytes_of(numbers));
  };
  static const std::vector<Damage> all{
      // VTK's stack overflows; it reads half as many levels.
      {"nested_deeply", {.after_data = repeated("<a>", 200'000) + repeated("</a>", 200'000)}},
      {"nested_without_end", {.after_data = repeated("<a>", 100'000)}},
      {"nested_in_points", {.points = repeated("<a>", 100'000) + repeated("</a>", 100'000)}},
      {"components_huge", {.points_format = ascii("1000000000")}},
      {"components_of_array_huge",
       {.arrays = array("radius", "1 1", R"(NumberOfComponents="1000000000")")}},
      {"components_zero", {.points_format = ascii("0")}},
      {"components_negative", {.points_format = ascii("-3")}},
      {"components_two", {.points_format = ascii("2")}},
      {"points_huge", {.piece = points_counted("1000000000")}},
      {"points_beyond_64_bits", {.piece = points_counted("99999999999999999999999")}},
      {"points_negative", {.piece = points_counted("-2")}},
      {"points_no_number", {.piece = points_counted("two")}},
      {"points_none", {.piece = points_counted("0")}},
      {"points_unsaid", {.piece = ""}},
      {"points_too_few", {.piece = points_counted("3")}},
      {"coordinate_nan", {.points = "nan 0 0 1 2 4"}},
      {"coordinate_infinite", {.points = "0 0 0 1 2 inf"}},
      {"coordinate_too_far", {.points = "0 0 0 1 2 1e300"}},
      {"coordinate_no_number", {.points = "0 0 zero 1 2 4"}},
      {"radius_zero", {.arrays = array("radius", "1 0")}},
      {"radius_nan", {.arrays = array("radius", "nan 1")}},
      {"radius_of_two_numbers",
       {.arrays = array("radius", "1 1 1 1", R"(NumberOfComponents="2")")}},
      {"radius_too_short", {.arrays = array("radius", "1")}},
      {"density_negative", {.arrays = array("density", "1 -1")}},
      {"entities_that_multiply", with_entity(multiplying_entities(), "&j;")},
      {"entity_of_itself", with_entity(R"(<!ENTITY a "&a;">)")},
      {"entity_of_another_file", with_entity(R"(<!ENTITY a SYSTEM "/dev/zero">)")},
      {"base64_bad", in_base64("!!!!####")},
      {"base64_empty", in_base64("")},
      {"binary_cut", in_base64(in_binary(48).substr(0, 40))},
      {"binary_longer_than_said", in_base64(in_binary(0xfffffff0).substr(0, 20))},
      {"binary_shorter_than_needed", in_base64(in_binary(40))},
      {"compressed_nothing", compressed_points("")},
      {"compressed_damaged", compressed_points(header({1, 48, 0, 12}) + base64("no zlib here"))},
      {"compressed_length_wrong", compressed_points(compressed(bytes, 40))},
      {"compressed_bomb",
       compressed_points(compressed(std::string(100'000'000, '\0'), 960'000'000), "40000000")},
      {"compressed_blocks_huge", compressed_points(header({0xfffffff, 0xfffffff, 0, 9}))},
      {"compressor_unknown",
       {.root = R"(version="1.0" byte_order="LittleEndian" compressor="vtkNoSuchCompressor")",
        .points_format = binary,
        .points = compressed(bytes, 48)}},
      {"appended_beyond_the_end",
       appended_points(1'000'000'000'000, R"(<AppendedData encoding="raw">_abc</AppendedData>)")},
      {"appended_cut", appended_points(0, R"(<AppendedData encoding="base64">_AA</AppendedData>)")},
      {"appended_nowhere", appended_points(0, "")},
      {"type_unknown", {.points_type = "Float99"}},
      {"cut_in_the_middle", {}, [](auto text) { return text.substr(0, text.size() / 2); }},
      {"cut_before_the_end", {}, [](auto text) { return text.substr(0, text.size() - 12); }},
      {"no_xml", {}, [](const auto&) { return "no XML"; }},
      {"empty", {}, [](const auto&) { return ""; }},
      {"zero_bytes", {}, [](const auto&) { return std::string(10'000, '\0'); }},
      {"no_points", {}, without("<Points>", "</Points>")},
      {"no_piece", {}, without("<Piece", "</Piece>")},
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
    Parts behind = appended_points(
        0, "<AppendedData encoding=\"base64\">_" + parts.points + "</AppendedData>");
    behind.arrays = parts.arrays;
    add("appended", behind.text(), "a.vtp");
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
    std::string text = damage->parts.text(kind.toStdString());
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
