#include "tools/brume/layer_names.h"

#include <algorithm>
#include <string_view>

#include "core/io/text_scanner.h"
#include "tools/brume/command.h"

namespace brume {

OutputLayers parse_layers(const std::string& text) {
  OutputLayers layers;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = rest.substr(0, comma);
    const auto* known =
        std::ranges::find_if(layer_names, [&](const LayerName& it) { return name == it.name; });
    if (known == layer_names.end()) {
      std::string allowed;
      for (const LayerName& it : layer_names) {
        allowed += (allowed.empty() ? "" : ", ") + std::string(it.name);
      }
      throw UsageError("--layers: found " + quoted_text(name) + "; allowed: " + allowed);
    }
    layers.*known->layer = true;
    if (comma == std::string_view::npos) return layers;
    rest = rest.substr(comma + 1);
  }
}

}  // namespace brume
