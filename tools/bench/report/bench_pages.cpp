#include "tools/bench/report/bench_pages.h"

#include <algorithm>
#include <cstdint>

#include "tools/bench/measure/report_text.h"
#include "tools/bench/report/bench_tables.h"
#include "tools/bench/report/plots.h"

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

namespace {

std::string base64(const std::string& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string picture_cell(const std::string& title, const std::string& png) {
  return "<figure><img src=\"data:image/png;base64," + base64(png) + "\"><figcaption>" + title +
         "</figcaption></figure>";
}

// A plain text as HTML, with its `code`.
std::string marked(const std::string& text) {
  std::string html;
  bool in_code = false;
  for (const char c : escaped(text)) {
    if (c != '`') {
      html += c;
      continue;
    }
    html += in_code ? "</code>" : "<code>";
    in_code = !in_code;
  }
  return html;
}

void put_table(const ReportTable& table, std::string& html) {
  if (!table.title.empty()) html += "<h2>" + marked(table.title) + "</h2>\n";
  if (!table.lead.empty()) html += "<p>" + marked(table.lead) + "</p>\n";
  html += "<table><tr>";
  for (const std::string& head : table.heads) html += "<th>" + marked(head);
  html += '\n';
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += "<td>" + marked(cell);
    html += '\n';
  }
  html += "</table>\n";
  if (!table.remark.empty()) html += "<p>" + marked(table.remark) + "</p>\n";
}

// Every setting that was measured, and other programs' ones.
ReportTable all_settings(const SceneReport& scene) {
  ReportTable table;
  table.heads = {"setting", "frame, ms", "CPU time, ms", "first frame, ms", "error", "stages, ms"};
  const auto add = [&](const std::string& setting, const Measurement& m) {
    table.rows.push_back(
        {setting, formatted("%.2f", m.milliseconds.median), with_spread(m.cpu_milliseconds, 2),
         formatted("%.1f", m.first_milliseconds), with_interval(m.error), stage_times(m)});
  };
  for (const Measurement& m : scene.settings) add(m.setting, m);
  for (const Measurement& m : scene.on_gl) add("OpenGL, " + m.setting, m);
  for (const OtherRendererRow& peer : scene.peers) {
    table.rows.push_back({peer.program + ", " + peer.setting, "",
                          formatted("%.2f", peer.cpu_milliseconds), "",
                          formatted("%.2g%%", 100.0 * peer.rel_rmse), ""});
  }
  return table;
}

void put_scene(const SceneReport& scene, std::string& html) {
  put(html, "<h2>%s</h2>\n<p>%zu Gaussians, %zu lights%s, %d x %d pixels.</p>\n<div class=row>",
      escaped(scene.name).c_str(), scene.gaussians, scene.lights,
      scene.environment ? ", an environment" : "", scene.film.width, scene.film.height);
  html += frontier_plot(scene);
  html += "<div>";
  html += picture_cell(escaped(scene.picture.setting), scene.picture.frame);
  html += picture_cell("reference", scene.picture.reference);
  html += picture_cell(
      formatted("error (white is %.0f%% of the mean)", 100.0 * scene.picture.error_scale),
      scene.picture.error);
  html += "</div></div>\n<details><summary>All settings</summary>";
  put_table(all_settings(scene), html);
  html += "</details>\n";
}

void put_curve(const CostCurve& curve, std::string& html) {
  const auto [fastest, slowest] =
      std::ranges::minmax(curve.points, {}, &CostPoint::cpu_milliseconds);
  LogPlot plot({curve.points.front().size, curve.points.back().size},
               {fastest.cpu_milliseconds, slowest.cpu_milliseconds}, curve.over.c_str(),
               "CPU time per frame [ms]");
  std::vector<std::pair<double, double>> line;
  for (const CostPoint& p : curve.points) {
    line.emplace_back(p.size, p.cpu_milliseconds);
    plot.dot(p.size, p.cpu_milliseconds, "#1f77b4",
             formatted("%g: %.1f ms", p.size, p.cpu_milliseconds));
  }
  plot.line(line, "#1f77b4");
  html += "<h3>Cost over " + curve.over + "</h3>\n" + plot.svg();
}

constexpr char style[] =
    "<style>body{font:14px sans-serif;max-width:1100px;margin:2em auto;padding:0 1em}"
    "table{border-collapse:collapse;margin:1em 0}td,th{border:1px solid #ccc;padding:2px 8px;"
    "text-align:left}.row{display:flex;gap:1em}figure{margin:0 0 .5em}img{width:200px;"
    "image-rendering:pixelated}figcaption{font-size:11px}</style>\n";

}  // namespace

std::string to_html(const BenchReport& report) {
  std::string html = "<!doctype html><meta charset=utf-8><title>Brume: speed against error</title>";
  html += style;
  html += std::string("<h1>") + bench_title + "</h1>\n<p>" + marked(bench_lead(report)) + "</p>\n";
  html +=
      "<p>In the plots, <b style=\"color:#c4a000\">paper</b> and <b "
      "style=\"color:#1f77b4\">sliced</b>, pale at full resolution, other renderers in other "
      "colours; the line is the frontier.</p>\n";
  for (const SceneReport& scene : report.scenes) put_scene(scene, html);
  for (const CostCurve& curve : report.curves) put_curve(curve, html);
  for (const ReportTable& table : bench_tables(report)) put_table(table, html);
  return html;
}

}  // namespace brume
