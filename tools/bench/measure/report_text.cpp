#include "tools/bench/measure/report_text.h"

#include <cstdarg>
#include <cstdio>

namespace brume {
namespace {

std::string formatted_list(const char* format, std::va_list arguments) {
  std::va_list again;
  va_copy(again, arguments);
  const int size = std::vsnprintf(nullptr, 0, format, arguments);
  // One more for the zero at the end.
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  std::vsnprintf(text.data(), text.size(), format, again);
  va_end(again);
  text.pop_back();
  return text;
}

}  // namespace

std::string formatted(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text = formatted_list(format, arguments);
  va_end(arguments);
  return text;
}

void put(std::string& text, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  text += formatted_list(format, arguments);
  va_end(arguments);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string with_spread(const Spread& spread, int digits) {
  return formatted("%.*f (%.*f to %.*f)", digits, spread.median, digits, spread.min, digits,
                   spread.max);
}

std::string with_interval(const ErrorEstimate& error) {
  // Two digits, and no exponent.
  const auto percent = [](double x) {
    return x < 0.995 ? formatted("%.2g", 100.0 * x) : formatted("%.0f", 100.0 * x);
  };
  return percent(error.rel_rmse) + "% (" + percent(error.low) + " to " + percent(error.high) + ')';
}

std::string stage_times(const Measurement& measurement) {
  std::string times;
  for (const StageTime& stage : measurement.stages) {
    if (stage.milliseconds < 0.05) continue;
    put(times, "%s%s %.1f", times.empty() ? "" : " ", to_string(stage.stage), stage.milliseconds);
  }
  return times;
}

}  // namespace brume
