#include "render/gl/shader_structs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <sstream>

namespace brume::gl {
namespace {

// The GLSL name of a type of C++, and how std430 aligns it. In C++ all are aligned to a word.
struct Type {
  std::string_view name;
  std::string_view glsl_name;
  std::size_t size;
  std::size_t alignment;
};
constexpr Type types[] = {
    {"float", "float", sizeof(float), 4},
    {"std::int32_t", "int", sizeof(std::int32_t), 4},
    {"std::uint32_t", "uint", sizeof(std::uint32_t), 4},
    {"glm::vec3", "vec3", sizeof(glm::vec3), 16},
    {"glm::vec4", "vec4", sizeof(glm::vec4), 16},
    {"glm::ivec4", "ivec4", sizeof(glm::ivec4), 16},
    {"MapData", "DirectionMap", sizeof(MapData), 16},
    {"BvhChild", "BvhChild", sizeof(BvhChild), 16},
};

struct Member {
  Type type{};
  std::string_view name;
  std::size_t count = 0;  // of an array; 0: it is none
  std::size_t offset = 0;
};

// The members of a struct from its text, `{ type name = value; ... }`.
struct Members {
  std::array<Member, 40> members;
  std::size_t count = 0;
  std::size_t size = 0;

  consteval explicit Members(std::string_view text) {
    text = text.substr(1, text.rfind('}') - 1);
    for (std::size_t end; (end = text.find(';')) != text.npos; text.remove_prefix(end + 1)) {
      std::string_view declared = text.substr(0, std::min(end, text.find_first_of("={")));
      declared.remove_prefix(declared.find_first_not_of(' '));
      declared = declared.substr(0, declared.find_last_not_of(' ') + 1);
      const std::size_t name = declared.rfind(' ');
      Member& m = members.at(count++);
      // Other types cannot be compiled.
      m.type = *std::ranges::find(types, declared.substr(0, name), &Type::name);
      m.name = declared.substr(name + 1);
      if (const std::size_t bracket = m.name.find('['); bracket != m.name.npos) {
        m.count = static_cast<std::size_t>(m.name[bracket + 1] - '0');
        m.name = m.name.substr(0, bracket);
      }
      m.offset = size;
      size += m.type.size * std::max(m.count, std::size_t{1});
    }
  }
  // Whether std430 places the members as C++ does, and gives the struct the same size.
  [[nodiscard]] constexpr bool is_std430() const {
    std::size_t alignment = 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Type& type = members[i].type;
      if (members[i].offset % type.alignment != 0) return false;
      // Elements of arrays lie at multiples of their alignment.
      if (members[i].count > 0 && type.size % type.alignment != 0) return false;
      alignment = std::max(alignment, type.alignment);
    }
    return size % alignment == 0;
  }
};

// A struct, or a record of words, as shaders call it.
struct Shared {
  std::string_view name;
  Members members;
  std::size_t size;  // in C++
};

constexpr Shared structs[] = {
    {"DirectionMap", Members(MapData_text), sizeof(MapData)},
    {"Light", Members(LightData_text), sizeof(LightData)},
    {"PaperLight", Members(PaperLightData_text), sizeof(PaperLightData)},
    {"GaussianShape", Members(GaussianShape_text), sizeof(GaussianShape)},
    {"SeenGaussian", Members(SeenGaussian_text), sizeof(SeenGaussian)},
    {"TileTotals", Members(TileTotals_text), sizeof(TileTotals)},
    {"UpsamplingTotals", Members(UpsamplingTotals_text), sizeof(UpsamplingTotals)},
    {"BvhChild", Members(BvhChild_text), sizeof(BvhChild)},
    {"BvhNode", Members(BvhNode_text), sizeof(BvhNode)},
    {"TriangleCorner", Members(TriangleCorner_text), sizeof(TriangleCorner)},
    {"PixelHit", Members(PixelHit_text), sizeof(PixelHit)},
};
static_assert(std::ranges::all_of(structs, [](const Shared& s) {
  return s.members.is_std430() && s.members.size == s.size;
}));

constexpr Shared records[] = {
    {"batch", Members(PixelBatch_text), sizeof(PixelBatch)},
    {"surface", Members(SurfaceRecord_text), sizeof(SurfaceRecord)},
    {"material", Members(MaterialRecord_text), sizeof(MaterialRecord)},
};
static_assert(std::ranges::all_of(records,
                                  [](const Shared& s) { return s.members.size == s.size; }));

}  // namespace

std::string shader_structs() {
  std::ostringstream out;
  for (const Shared& s : structs) {
    out << "struct " << s.name << " {\n";
    for (const Member& m : std::span(s.members.members).first(s.members.count)) {
      out << "  " << m.type.glsl_name << ' ' << m.name;
      if (m.count > 0) out << '[' << m.count << ']';
      out << ";\n";
    }
    out << "};\n";
  }
  constexpr std::size_t word = sizeof(float);
  for (const Shared& s : records) {
    for (const Member& m : std::span(s.members.members).first(s.members.count)) {
      out << "const int " << s.name << '_' << m.name << " = " << m.offset / word << ";\n";
    }
    out << "const int " << s.name << "_size = " << s.size / word << ";\n";
  }
  return out.str();
}

}  // namespace brume::gl
