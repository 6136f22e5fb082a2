#pragma once

#include <filesystem>
#include <string_view>

namespace brume {

// Files that are installed with the program or library that holds this code, found from where that
// is: an installation may be moved as a whole. A build folder is laid out like one. What is missing
// is named where it should be.

// A program that this one starts.
std::filesystem::path helper_program(std::string_view name);
// The folder of sample scenes, what they refer to, templates, and pictures of both.
std::filesystem::path resources_folder();
// The folder of the manual as HTML.
std::filesystem::path manual_folder();

}  // namespace brume
