#pragma once

#include <string_view>

// Declares a struct for C++ and shaders: `Name`, and its text `Name_text`, of which
// render/gl/shader_structs makes the shaders'. One member a declaration.
#define BRUME_SHARED_STRUCT(Name, ...) \
  struct Name __VA_ARGS__;             \
  inline constexpr std::string_view Name##_text = #__VA_ARGS__
