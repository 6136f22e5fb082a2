#include "tools/brume/request_arguments.h"

#include <algorithm>

#include "core/io/text_scanner.h"
#include "core/number_domain.h"
#include "tools/brume/command.h"

namespace brume {
namespace {

std::string argument(const RequestOption& option) {
  return std::string("--") + option.name;
}

// Types are named as CLI11 does; what values there are follows a colon.
std::string type_name(const RequestOption& option) {
  using Type = RequestOption::Type;
  const std::string type = option.type == Type::whole_number ? "INT"
                           : option.type == Type::number     ? "FLOAT"
                                                             : "TEXT";
  return option.values.empty() ? type : type + ':' + option.values;
}

void set(RenderRequest& request, const RequestOption& option, const std::string& text,
         const Film& film) {
  const std::string why = option.set(request, text, film);
  if (!why.empty()) throw UsageError(argument(option) + ": " + why);
}

}  // namespace

void add_request_options(CLI::App& app) {
  for (const RequestOption& option : request_options()) {
    if (option.type == RequestOption::Type::flag) {
      app.add_flag(argument(option))->description(option.sentence);
      continue;
    }
    app.add_option(argument(option))
        ->description(option.sentence)
        ->type_name(type_name(option))
        ->default_str(option.get ? option.get(RenderRequest{}) : "");
  }
}

RenderRequest request_of(const CLI::App& app, const Film& film) {
  RenderRequest request;
  for (const RequestOption& option : request_options()) {
    const CLI::Option* const given = app.get_option(argument(option));
    if (given->count() > 0) set(request, option, given->results().front(), film);
  }
  return request;
}

void set_option(RenderRequest& request, const std::string& name, const std::string& text) {
  const auto named = [&](const RequestOption& option) { return name == option.name; };
  set(request, *std::ranges::find_if(request_options(), named), text, {});
}

CLI::Validator finite_in(double low, double high) {
  const std::string range = "from " + quoted_text(low) + " to " + quoted_text(high);
  return CLI::Validator(
      [=](const std::string& text) -> std::string {
        double value = 0.0;
        // NaN is in no range.
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
        return "found " + quoted_text(text) + "; allowed: a number " + range;
      },
      range);
}

}  // namespace brume
