#include "tools/scene_reader/obj_repair.h"

#include <algorithm>
#include <vector>

#include "core/io/mesh/obj_corner.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

class Repair {
 public:
  explicit Repair(std::string& text) : text_(text), scanner_(text, true), all_(count_obj(text)) {}

  ObjRepair run() {
    while (scanner_.next_line()) {
      const std::string_view keyword = scanner_.next_token();
      if (keyword == "f") repair_face(keyword);
      if (keyword == "l" || keyword == "p") blank_element(keyword);
      before_.add(keyword);
    }
    return result_;
  }

 private:
  void repair_face(std::string_view keyword) {
    const std::string line = scanner_.place();
    tokens_.clear();
    corners_.clear();
    bool has_bad_index = false;
    for (std::string_view token = scanner_.next_token(); !token.empty() && token[0] != '#';
         token = scanner_.next_token()) {
      const ObjCorner& corner = corners_.emplace_back(read_obj_corner(token, before_, all_));
      tokens_.push_back(token);
      const auto slashes = std::ranges::count(token, '/');
      const bool has_texcoord = slashes > 0 && token.find("//") == token.npos;
      has_bad_index =
          has_bad_index || (has_texcoord && !corner.texcoord) || (slashes == 2 && !corner.normal);
    }
    const bool is_face = is_obj_face(corners_);
    if (is_face && !has_bad_index) return;
    result_.has_changed = true;
    if (!is_face) {
      blank(keyword);
      if (++result_.bad_faces == 1) result_.first_line = line;
    }
    for (const std::string_view token : tokens_) {
      blank(is_face ? token.substr(std::min(token.find('/'), token.size())) : token);
    }
  }

  void blank_element(std::string_view keyword) {
    result_.has_changed = true;
    for (std::string_view token = keyword; !token.empty(); token = scanner_.next_token()) {
      blank(token);
    }
  }

  void blank(std::string_view part) {
    std::fill_n(text_.begin() + (part.data() - text_.data()), part.size(), ' ');
  }

  std::string& text_;
  TextScanner scanner_;
  ObjCounts all_;
  ObjCounts before_;
  ObjRepair result_;
  std::vector<std::string_view> tokens_;
  std::vector<ObjCorner> corners_;
};

}  // namespace

ObjRepair repair_obj(std::string& text) {
  return Repair(text).run();
}

}  // namespace brume
