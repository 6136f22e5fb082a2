#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brume {

// A PLY file as generic rows of numbers: ascii, binary little-endian or big-endian.
class PlyFile {
 public:
  enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

  struct Property {
    std::string name;
    Type type = Type::float32;
    std::optional<Type> list_count;  // for lists: type of the length
  };

  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    [[nodiscard]] std::optional<std::size_t> property(std::string_view name) const;
  };

  // One row: scalars and lists by property index.
  struct Row {
    std::vector<double> scalars;
    std::vector<std::vector<double>> lists;
  };

  // Rows of one size in a binary file: without lists, or with lists as long as the first row's.
  class EqualRows {
   public:
    // A property's values in a row: one, or those of its list.
    [[nodiscard]] std::size_t length(std::size_t property) const {
      return columns_[property].length;
    }
    [[nodiscard]] double value(std::uint64_t row, std::size_t property, std::size_t i = 0) const;

   private:
    friend class PlyFile;
    struct Column {
      Type type = Type::float32;
      std::size_t begin = 0;  // in the row, in bytes
      std::size_t length = 1;
    };
    std::vector<Column> columns_;
    const char* first_ = nullptr;
    std::size_t stride_ = 0;
    bool swap_ = false;
  };

  // Reads the header; `bytes` must outlive this. Throws InputError.
  PlyFile(std::filesystem::path file, std::string_view bytes);

  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
  [[nodiscard]] const Element* element(std::string_view name) const;
  // One line each, with the file's name: lines of the header that are skipped.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  // Calls `visit` for each row of each element in file order. Throws InputError naming element and
  // row for truncated or invalid data.
  using Visit = std::function<void(const Element& element, std::uint64_t index, const Row& row)>;
  void for_each_row(const Visit& visit) const;

  // Each element's rows, which may then be read in parallel; nullopt where for_each_row() is to
  // read them, or to say what is wrong: in ascii, if rows differ in size, or if some are missing.
  [[nodiscard]] std::optional<std::vector<EqualRows>> equal_rows() const;

 private:
  enum class Format { ascii, little, big };

  [[nodiscard]] bool has_swapped_bytes() const;

  std::filesystem::path file_;
  std::string_view data_;
  Format format_ = Format::ascii;
  std::vector<Element> elements_;
  std::vector<std::string> warnings_;
};

}  // namespace brume
