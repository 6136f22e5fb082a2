#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brume/export.h"
#include "brume/render.h"

namespace brume {

// An option of a RenderRequest. The options of `brume render`, the keywords of Python's render()
// and what the header of a frame's file says of its request follow from these descriptions.
struct BRUME_EXPORT RequestOption {
  enum class Type { flag, whole_number, number, text, list };

  const char* name;  // of the command line, "max-error"
  Type type;
  std::string values;    // "from 4 to 256", "{auto,cpu,gl}"; empty: see the sentence
  const char* sentence;  // what it does

  // Sets it to what a text says: "0.02", "sliced:16", items of a list with `separator` between
  // them; of a flag "true". `film`: the scene's. Returns why it cannot, "found 0; allowed: a number
  // from 1 to 2"; empty if it did.
  std::function<std::string(RenderRequest&, std::string_view text, const Film& film)> set;
  // Its text, as set() takes it; empty: chosen by the renderer, or the scene's. No function: it
  // cannot be told.
  std::function<std::string(const RenderRequest&)> get{};
  // Whether the header of a frame's file has it. No function: never.
  bool (*is_in_header)(const RenderRequest&) = nullptr;
  char separator = ',';

  // Python's keyword: the name with underscores.
  [[nodiscard]] std::string keyword() const;
};

BRUME_EXPORT const std::vector<RequestOption>& request_options();

}  // namespace brume
