#include "core/io/ply.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "brume/error.h"
#include "core/io/text_scanner.h"

namespace brume {
namespace {

using Type = PlyFile::Type;

std::optional<Type> type_named(std::string_view name) {
  static constexpr std::pair<std::string_view, Type> names[] = {
      {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
      {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
      {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
      {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
      {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
      {"float64", Type::float64}};
  for (const auto& [known, type] : names) {
    if (known == name) return type;
  }
  return std::nullopt;
}

std::size_t size_of(Type type) {
  switch (type) {
    case Type::int8:
    case Type::uint8:
      return 1;
    case Type::int16:
    case Type::uint16:
      return 2;
    case Type::int32:
    case Type::uint32:
    case Type::float32:
      return 4;
    case Type::float64:
      return 8;
  }
  return 8;
}

template <typename Number>
double decode(const char* bytes, bool swap) {
  char ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof(Number));
  if (swap) std::reverse(std::begin(ordered), std::end(ordered));
  Number value;
  std::memcpy(&value, ordered, sizeof(Number));
  return static_cast<double>(value);
}

double decode(Type type, const char* bytes, bool swap) {
  switch (type) {
    case Type::int8:
      return decode<std::int8_t>(bytes, swap);
    case Type::uint8:
      return decode<std::uint8_t>(bytes, swap);
    case Type::int16:
      return decode<std::int16_t>(bytes, swap);
    case Type::uint16:
      return decode<std::uint16_t>(bytes, swap);
    case Type::int32:
      return decode<std::int32_t>(bytes, swap);
    case Type::uint32:
      return decode<std::uint32_t>(bytes, swap);
    case Type::float32:
      return decode<float>(bytes, swap);
    case Type::float64:
      return decode<double>(bytes, swap);
  }
  return 0.0;
}

bool is_list_length(double value) {
  return value >= 0.0 && value == std::floor(value);
}

// The values of the data section one after the other.
class Values {
 public:
  Values(std::string_view data, bool ascii, bool swap)
      : text_(data), data_(data), ascii_(ascii), swap_(swap) {}

  // nullopt at the end of data or for invalid numbers; found() then quotes what is there.
  std::optional<double> next(Type type) {
    if (ascii_) {
      token_ = text_.token_ahead();
      return parse_number(token_);
    }
    const std::size_t size = size_of(type);
    if (data_.size() < size) return std::nullopt;
    const double value = decode(type, data_.data(), swap_);
    data_.remove_prefix(size);
    return value;
  }

  // Whether the remaining bytes can hold `count` values of this type: an ascii value needs a
  // character and, except the last, a separator.
  [[nodiscard]] bool can_hold(double count, std::size_t size) const {
    if (!ascii_) return count * static_cast<double>(size) <= static_cast<double>(data_.size());
    const std::size_t left = text_.rest_of_line().size() + text_.rest_of_text().size() + 1;
    return count * 2.0 <= static_cast<double>(left) + 1.0;
  }

  [[nodiscard]] std::string found() const {
    return ascii_ && !token_.empty() ? "found " + quoted_text(token_) : "the file ends here";
  }

 private:
  TextScanner text_;
  std::string_view data_;
  std::string_view token_;
  bool ascii_;
  bool swap_;
};

}  // namespace

std::optional<std::size_t> PlyFile::Element::property(std::string_view wanted) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == wanted) return i;
  }
  return std::nullopt;
}

const PlyFile::Element* PlyFile::element(std::string_view name) const {
  const auto it = std::find_if(elements_.begin(), elements_.end(),
                               [&](const Element& element) { return element.name == name; });
  return it == elements_.end() ? nullptr : &*it;
}

PlyFile::PlyFile(std::filesystem::path file, std::string_view bytes) : file_(std::move(file)) {
  TextScanner header(bytes);
  const auto fail = [&](const std::string& message) {
    throw InputError(file_, header.place(), message);
  };
  if (!header.next_line() || header.next_token() != "ply") fail("not a PLY file");
  bool have_format = false;
  std::string first_skipped;  // its line and keyword
  std::size_t skipped = 0;
  for (;;) {
    if (!header.next_line()) fail("the header ends without end_header");
    const std::string_view keyword = header.next_token();
    if (keyword == "end_header") break;
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") continue;
    if (keyword == "format") {
      const std::string_view name = header.next_token();
      have_format = true;
      if (name == "ascii") {
        format_ = Format::ascii;
      } else if (name == "binary_little_endian") {
        format_ = Format::little;
      } else if (name == "binary_big_endian") {
        format_ = Format::big;
      } else {
        fail("found format " + quoted_text(name) +
             "; allowed: ascii, binary_little_endian, binary_big_endian");
      }
    } else if (keyword == "element") {
      Element element;
      element.name = header.next_token();
      const std::string_view count = header.next_token();
      const std::optional<std::int64_t> parsed = parse_integer(count);
      if (!parsed || *parsed < 0)
        fail("found a count of " + quoted_text(count) + "; allowed: >= 0");
      element.count = static_cast<std::uint64_t>(*parsed);
      elements_.push_back(std::move(element));
    } else if (keyword == "property") {
      if (elements_.empty()) fail("a property before any element");
      Property property;
      std::string_view type = header.next_token();
      if (type == "list") {
        const std::string_view count_type = header.next_token();
        property.list_count = type_named(count_type);
        if (!property.list_count) fail("unknown type " + quoted_text(count_type));
        type = header.next_token();
      }
      const std::optional<Type> known = type_named(type);
      if (!known) fail("unknown type " + quoted_text(type));
      property.type = *known;
      property.name = header.next_token();
      if (property.name.empty()) fail("a property without a name");
      elements_.back().properties.push_back(std::move(property));
    } else if (++skipped == 1) {  // as other readers do: some programs write comments so
      first_skipped =
          InputError(file_, header.place(), "found the unknown keyword " + quoted_text(keyword))
              .what();
    }
  }
  if (skipped > 0) {
    const std::string more =
        skipped > 1 ? ", as are " + std::to_string(skipped - 1) + " more" : std::string();
    warnings_.push_back(first_skipped + "; the line is skipped" + more);
  }
  if (!have_format) fail("the header has no format line");
  data_ = header.rest_of_text();
}

bool PlyFile::has_swapped_bytes() const {
  return (format_ == Format::big) != (std::endian::native == std::endian::big);
}

double PlyFile::EqualRows::value(std::uint64_t row, std::size_t property, std::size_t i) const {
  const Column& column = columns_[property];
  return decode(column.type, first_ + row * stride_ + column.begin + i * size_of(column.type),
                swap_);
}

std::optional<std::vector<PlyFile::EqualRows>> PlyFile::equal_rows() const {
  if (format_ == Format::ascii) return std::nullopt;
  std::vector<EqualRows> result;
  std::string_view rest = data_;
  for (const Element& element : elements_) {
    EqualRows rows;
    rows.first_ = rest.data();
    rows.swap_ = has_swapped_bytes();
    EqualRows lengths = rows;  // of the lists
    for (const Property& property : element.properties) {
      EqualRows::Column column{property.type, rows.stride_, 1};
      if (property.list_count) {
        column.begin += size_of(*property.list_count);
        if (element.count == 0 || column.begin > rest.size()) return std::nullopt;
        lengths.columns_.push_back({*property.list_count, rows.stride_, 1});
        const double length = lengths.value(0, lengths.columns_.size() - 1);
        // The next property of the row must be within the file.
        if (!is_list_length(length) || length > static_cast<double>(rest.size()))
          return std::nullopt;
        column.length = static_cast<std::size_t>(length);
      }
      rows.stride_ = column.begin + column.length * size_of(column.type);
      rows.columns_.push_back(column);
    }
    if (element.count > 0 && (rows.stride_ == 0 || element.count > rest.size() / rows.stride_)) {
      return std::nullopt;
    }
    lengths.stride_ = rows.stride_;
    std::atomic<bool> are_equal = true;
    tbb::parallel_for(
        tbb::blocked_range<std::uint64_t>(0, lengths.columns_.empty() ? 0 : element.count, 4096),
        [&](const auto& range) {
          if (!are_equal) return;
          for (std::uint64_t row = range.begin(); row < range.end(); ++row) {
            for (std::size_t k = 0; k < lengths.columns_.size(); ++k) {
              if (lengths.value(row, k) != lengths.value(0, k)) are_equal = false;
            }
          }
        });
    if (!are_equal) return std::nullopt;
    rest.remove_prefix(element.count * rows.stride_);
    result.push_back(std::move(rows));
  }
  return result;
}

void PlyFile::for_each_row(const Visit& visit) const {
  const bool ascii = format_ == Format::ascii;
  Values values(data_, ascii, has_swapped_bytes());
  Row row;
  for (const Element& element : elements_) {
    std::size_t row_size = 0;
    for (const Property& property : element.properties) {
      row_size += ascii ? 1 : size_of(property.list_count.value_or(property.type));
    }
    // Checked before anything is reserved or looped over.
    if (element.count > 0 &&
        (row_size == 0 ||
         !values.can_hold(static_cast<double>(element.count) * static_cast<double>(row_size), 1))) {
      throw InputError(
          file_, "element " + quoted_text(element.name),
          "found a count of " + std::to_string(element.count) + "; the file is too short for it");
    }
    row.scalars.assign(element.properties.size(), 0.0);
    row.lists.resize(element.properties.size());
    for (std::uint64_t index = 0; index < element.count; ++index) {
      const auto fail = [&](const Property& property, const std::string& message) {
        throw InputError(file_, quoted_text(element.name) + " " + std::to_string(index),
                         quoted_text(property.name) + ": " + message);
      };
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        const std::optional<double> first =
            values.next(property.list_count.value_or(property.type));
        if (!first) fail(property, values.found() + "; allowed: a number");
        if (!property.list_count) {
          row.scalars[p] = *first;
          continue;
        }
        if (!is_list_length(*first) || !values.can_hold(*first, size_of(property.type))) {
          fail(property, "found a list of " + std::to_string(*first) +
                             " values; the file is too short for it");
        }
        row.lists[p].clear();
        for (std::size_t i = 0; i < static_cast<std::size_t>(*first); ++i) {
          const std::optional<double> value = values.next(property.type);
          if (!value) fail(property, values.found() + "; allowed: a number");
          row.lists[p].push_back(*value);
        }
      }
      visit(element, index, row);
    }
  }
}

}  // namespace brume
