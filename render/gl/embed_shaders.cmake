# Writes OUT, a C++ file that holds the text of every file of SHADERS (cmake -P).
set(entries "")
foreach(file IN LISTS SHADERS)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUT} "// Made by embed_shaders.cmake.
#include \"render/gl/shader_source.h\"

namespace brume::gl {

const char* embedded_shader(std::string_view name) {
  struct Shader {
    std::string_view name;
    const char* text;
  };
  static constexpr Shader shaders[] = {
${entries}  };
  for (const Shader& shader : shaders) {
    if (shader.name == name) return shader.text;
  }
  return nullptr;
}

}  // namespace brume::gl
")
