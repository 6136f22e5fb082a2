#include "brume/error.h"
#include "core/io/mesh/mesh_readers.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

// Goes to the next line that is neither blank nor a comment.
bool next_content(TextScanner& scanner) {
  while (scanner.next_line()) {
    const std::string_view line = scanner.rest_of_line();
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin != std::string_view::npos && line[begin] != '#') return true;
  }
  return false;
}

}  // namespace

// OFF, with the prefixes ST, C, N of which only N (normals) matters here: colours and texture
// coordinates stand after them and are left out.
RawMesh read_off(const std::filesystem::path& file, std::string_view bytes) {
  TextScanner scanner(bytes);
  const auto fail = [&](const std::string& message) {
    throw InputError(file, scanner.place(), message);
  };
  std::string_view kind = next_content(scanner) ? scanner.next_token() : std::string_view{};
  if (kind != "OFF" && kind != "COFF" && kind != "NOFF" && kind != "CNOFF" && kind != "STOFF" &&
      kind != "STCOFF" && kind != "STNOFF" && kind != "STCNOFF") {
    fail("found " + quoted_text(kind) + "; allowed: OFF, with the prefixes ST, C and N");
  }
  const bool has_normals = kind.find('N') != std::string_view::npos;

  // The counts may follow the keyword or be on the next line.
  std::string_view token = scanner.next_token();
  if ((token.empty() || token[0] == '#') && next_content(scanner)) token = scanner.next_token();
  if (token == "BINARY") fail("binary OFF is not supported");
  std::array<std::int64_t, 2> counts{};  // vertices, faces
  for (std::int64_t& count : counts) {
    const auto parsed = parse_integer(token);
    // Every vertex and every face takes a line of some bytes.
    if (!parsed || *parsed < 0 || static_cast<std::uint64_t>(*parsed) > bytes.size()) {
      fail("found a count of " + quoted_text(token) + "; allowed: as many as the file has lines");
    }
    count = *parsed;
    token = scanner.next_token();
  }

  RawMesh mesh;
  for (std::int64_t i = 0; i < counts[0]; ++i) {
    if (!next_content(scanner)) {
      fail("the file ends after " + std::to_string(i) + " of " + std::to_string(counts[0]) +
           " vertices");
    }
    mesh.points.push_back(read_point(file, scanner));
    if (has_normals) mesh.normals.push_back(read_normal(scanner));
  }
  std::vector<std::uint32_t> face;
  for (std::int64_t i = 0; i < counts[1]; ++i) {
    if (!next_content(scanner)) {
      fail("the file ends after " + std::to_string(i) + " of " + std::to_string(counts[1]) +
           " faces");
    }
    token = scanner.next_token();
    const auto corners = parse_integer(token);
    if (!corners || *corners < 1) {
      fail("found a face of " + quoted_text(token) + " vertices; allowed: 1 or more");
    }
    face.clear();
    for (std::int64_t k = 0; k < *corners; ++k) {
      token = scanner.next_token();
      const auto index = parse_integer(token);
      if (!index || *index < 0 || *index >= counts[0]) {
        fail("found the vertex index " + quoted_text(token) + "; allowed: 0 to " +
             std::to_string(counts[0] - 1));
      }
      face.push_back(static_cast<std::uint32_t>(*index));
    }
    add_polygon(mesh, face);
  }
  return mesh;
}

}  // namespace brume
