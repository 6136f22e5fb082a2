#pragma once

#include <string>
#include <string_view>

namespace brume {

// Escapes text for one line on a terminal: control characters (C0, DEL, C1), bidirectional and line
// controls, and invalid UTF-8 become \u001b or \x9b, so names in hostile files can neither control
// the terminal nor disguise themselves. Idempotent.
std::string printable(std::string_view text);

// The same for text of several lines. JSON stays equivalent JSON.
std::string printable_lines(std::string_view text);

}  // namespace brume
