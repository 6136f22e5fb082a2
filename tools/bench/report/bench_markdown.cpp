#include "tools/bench/report/bench_markdown.h"

#include "tools/bench/report/bench_tables.h"

namespace brume {
namespace {

void put_row(const std::vector<std::string>& cells, std::string& page) {
  page += '|';
  for (const std::string& cell : cells) page += cell.empty() ? " |" : ' ' + cell + " |";
  page += '\n';
}

void put_markdown(const ReportTable& table, std::string& page) {
  if (!table.title.empty()) page += "\n## " + table.title + '\n';
  if (!table.lead.empty()) page += '\n' + table.lead + '\n';
  page += '\n';
  put_row(table.heads, page);
  page += '|';
  for (std::size_t i = 0; i < table.heads.size(); ++i) page += "---|";
  page += '\n';
  for (const auto& row : table.rows) put_row(row, page);
  if (!table.remark.empty()) page += '\n' + table.remark + '\n';
}

}  // namespace

std::string to_markdown(const BenchReport& report) {
  std::string page = std::string("# ") + bench_title + "\n\n" + bench_lead(report) + '\n';
  for (const ReportTable& table : bench_tables(report)) put_markdown(table, page);
  return page;
}

}  // namespace brume
