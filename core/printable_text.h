#pragma once

#include <string>
#include <string_view>

namespace brume {

// A text fit for a terminal and for one line: control characters (C0, DEL, C1), those that change
// the direction or the lines of a text, and bytes that are not UTF-8 are shown as \u001b or \x9b.
// File names and keys of hostile files must neither drive the terminal nor hide what they are.
// Printable text stays as it is, so the function may be applied again.
std::string printable(std::string_view text);

// The same for a text of several lines, whose ends stay. JSON stays the same JSON.
std::string printable_lines(std::string_view text);

}  // namespace brume
