#include "mesher/surface_frame.hpp"
#include "mesher/surface_words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

namespace plica {
namespace {

struct Property {
  std::string name, type, counted; // counted: type of the count of a list, or empty
};

struct Element {
  std::string name;
  long count = 0;
  std::vector<Property> properties;
};

std::size_t size_of(const TextLine& line, std::string_view type) {
  static const std::map<std::string, std::size_t, std::less<>> sizes{
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  if (found == sizes.end()) surface_error(line.number, shown_word(type) + " is no type of PLY");
  return found->second;
}

class Ply {
public:
  explicit Ply(const std::string& bytes) : bytes_(bytes) {}

  void check() {
    header();
    if (form_ == "ascii")
      text();
    else
      binary();
  }

private:
  void header() {
    const std::size_t found = bytes_.find("end_header");
    if (!bytes_.starts_with("ply") || found == std::string::npos)
      surface_error(1, "is no PLY: ply ... end_header is missing");
    data_ = std::min(bytes_.find('\n', found), bytes_.size() - 1) + 1;
    const std::vector<TextLine> lines = lines_of_words(std::string_view(bytes_).substr(0, data_));
    header_lines_ = int(lines.size());
    for (const TextLine& line : lines) {
      if (line.words.empty()) continue;
      const std::string_view first = line.words[0];
      const std::size_t n = line.words.size();
      if (first == "format" && n == 3 && form_.empty())
        form_ = line.words[1];
      else if (first == "element" && n == 3)
        elements_.push_back({std::string(line.words[1]), whole_number(line, line.words[2]), {}});
      else if (first == "property" && !elements_.empty() && (n == 3 || n == 5))
        property(line);
      else if (!(first == "ply" && n == 1 && line.number == 1) && first != "comment" &&
               first != "obj_info" && !(first == "end_header" && n == 1))
        surface_error(line.number, shown_word(first) + " is no line of a header of PLY");
    }
    if (form_ != "ascii" && form_ != "binary_little_endian" && form_ != "binary_big_endian")
      surface_error(0, shown_word(form_) + " is no format of PLY");
    vertices_ = -1;
    for (const Element& e : elements_) {
      if (e.count < 0) surface_error(0, "counts " + std::to_string(e.count) + " of " + e.name);
      if (e.name == "vertex") vertices_ = e.count;
      for (const char* axis : {"x", "y", "z"})
        if (e.name == "vertex" &&
            std::none_of(e.properties.begin(), e.properties.end(),
                         [&](const Property& p) { return p.name == axis && p.counted.empty(); }))
          surface_error(0, std::string("its vertices have no ") + axis);
    }
    if (vertices_ < 0) surface_error(0, "its header names no vertices");
  }

  void property(const TextLine& line) {
    const bool list = line.words.size() == 5;
    if (list != (line.words[1] == "list")) surface_error(line.number, "is no property of PLY");
    Property p{std::string(line.words.back()), std::string(line.words[list ? 3 : 1]),
               list ? std::string(line.words[2]) : ""};
    size_of(line, p.type);
    if (list) size_of(line, p.counted);
    elements_.back().properties.push_back(std::move(p));
  }

  void check_value(int line, const Property& p, double value) const {
    if (!std::isfinite(value)) surface_error(line, p.name + " is no finite number");
    if (!p.name.starts_with("vertex_ind")) return;
    if (value < 0 || value >= double(vertices_) || value != std::floor(value))
      surface_error(line, "a face names vertex " + std::to_string(long(value)) + " of " +
                              std::to_string(vertices_));
  }

  void text() const {
    const std::vector<TextLine> lines = lines_of_words(std::string_view(bytes_).substr(data_));
    std::size_t at = 0;
    const auto skip = [&] {
      while (at < lines.size() && lines[at].words.empty()) ++at;
    };
    for (const Element& e : elements_)
      for (long i = 0; i < e.count; ++i) {
        skip();
        if (at == lines.size())
          surface_error(0, "ends behind " + std::to_string(i) + " of " + std::to_string(e.count) +
                               " of " + e.name + ": it was cut short");
        TextLine line = lines[at++];
        line.number += header_lines_;
        record(line, e);
      }
    skip();
    if (at < lines.size())
      surface_error(lines[at].number + header_lines_, "stands behind all that its header counts");
  }

  void record(const TextLine& line, const Element& e) const {
    std::size_t word = 0;
    for (const Property& p : e.properties) {
      long count = 1;
      if (!p.counted.empty()) {
        finite_number(line, word);
        count = whole_number(line, line.words[word++]);
      }
      for (long k = 0; k < count; ++k) check_value(line.number, p, finite_number(line, word++));
    }
    if (word != line.words.size())
      surface_error(line.number, "has " + std::to_string(line.words.size()) + " numbers, not " +
                                     std::to_string(word) + " as its header says");
  }

  double value(std::size_t at, const std::string& type) const {
    const TextLine nowhere;
    const std::size_t size = size_of(nowhere, type);
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at, size);
    const bool little = form_ == "binary_little_endian";
    if (little != (std::endian::native == std::endian::little))
      std::reverse(raw.begin(), raw.begin() + std::ptrdiff_t(size));
    const auto as = [&](auto number) {
      std::memcpy(&number, raw.data(), sizeof number);
      return double(number);
    };
    const bool sign = !type.starts_with('u');
    if (type.starts_with("float") || type == "double") return size == 4 ? as(0.F) : as(0.);
    if (size == 1) return sign ? as(std::int8_t(0)) : as(std::uint8_t(0));
    if (size == 2) return sign ? as(std::int16_t(0)) : as(std::uint16_t(0));
    return sign ? as(std::int32_t(0)) : as(std::uint32_t(0));
  }

  void binary() const {
    const TextLine nowhere;
    std::size_t at = data_;
    const auto take = [&](const std::string& type) {
      const std::size_t size = size_of(nowhere, type);
      if (at + size > bytes_.size())
        surface_error(0, "ends before all that its header counts: it was cut short");
      const double v = value(at, type);
      at += size;
      return v;
    };
    for (const Element& e : elements_)
      for (long i = 0; i < e.count; ++i)
        for (const Property& p : e.properties) {
          const double count = p.counted.empty() ? 1 : take(p.counted);
          for (double k = 0; k < count; ++k) check_value(0, p, take(p.type));
        }
    if (at != bytes_.size())
      surface_error(0, std::to_string(bytes_.size() - at) +
                           " bytes stand behind all that its header counts");
  }

  const std::string& bytes_;
  std::string form_;
  std::vector<Element> elements_;
  std::size_t data_ = 0;
  int header_lines_ = 0;
  long vertices_ = 0;
};

} // namespace

void check_ply(const std::string& bytes) {
  Ply(bytes).check();
}

} // namespace plica
