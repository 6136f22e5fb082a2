#pragma once

#include <string>
#include <vector>

namespace brume {

// A table of a report, whatever it is written as. Texts are plain, with `code` in backticks.
struct ReportTable {
  std::string title;  // of its section; empty: it belongs to the section of the table before it
  std::string lead;   // what it shows
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;  // of as many cells as there are heads
  std::string remark;                          // below it; empty: none
};

}  // namespace brume
