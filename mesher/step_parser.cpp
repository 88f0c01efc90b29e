#include "mesher/step_parser.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace plica {
namespace {

bool is_upper(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; // small ones are met
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

class Parser {
public:
  explicit Parser(std::string_view text) : text_(text) {}

  void exchange(const std::function<void(const StepEntity&)>& found) {
    expect_word("ISO-10303-21");
    expect(';');
    expect_word("HEADER");
    expect(';');
    bool schema = false;
    while (!is_word("ENDSEC")) {
      const StepValue entry = record();
      schema = schema || entry.text == "FILE_SCHEMA";
      expect(';');
    }
    if (!schema) fail("the header does not name its FILE_SCHEMA");
    expect_word("ENDSEC");
    expect(';');
    int sections = 0;
    while (!is_word("END-ISO-10303-21")) {
      expect_word("DATA");
      if (peek() == '(') list();
      expect(';');
      ++sections;
      while (!is_word("ENDSEC")) found(entity());
      expect_word("ENDSEC");
      expect(';');
    }
    if (sections == 0) fail("there is no DATA section");
    expect_word("END-ISO-10303-21");
    expect(';');
    if (peek() != '\0') fail("something follows END-ISO-10303-21");
  }

private:
  [[noreturn]] void fail(const std::string& what) const { step_error(line_, what); }

  // Over blanks and comments to the next sign, '\0' at the end.
  char peek() {
    for (;;) {
      while (at_ < text_.size() &&
             (text_[at_] == '\0' ||
              std::string_view(" \t\r\n\f\v").find(text_[at_]) != std::string_view::npos))
        step();
      if (text_.substr(at_, 2) != "/*") break;
      const int from = line_;
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) step_error(from, "a comment does not end");
      while (at_ < end + 2) step();
    }
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  std::string here() {
    if (peek() == '\0') return "the end of the file";
    const std::string_view rest = text_.substr(at_, 24);
    std::string shown;
    for (char c : rest.substr(0, rest.find_first_of("\r\n")))
      shown += c >= ' ' && c < 127 ? c : '?';
    return "'" + shown + "'";
  }
  void expect(char sign) {
    if (peek() != sign) fail(std::string("'") + sign + "' is missing before " + here());
    step();
  }
  bool is_word(std::string_view word) {
    peek();
    if (text_.substr(at_, word.size()) != word) return false;
    const char next = at_ + word.size() < text_.size() ? text_[at_ + word.size()] : ';';
    return !is_upper(next) && !is_digit(next) && next != '-';
  }
  void expect_word(std::string_view word) {
    if (!is_word(word)) fail(std::string(word) + " is missing before " + here());
    at_ += word.size();
  }

  StepEntity entity() {
    StepEntity own;
    if (peek() != '#') fail("an entity '#1 = NAME(...);' or ENDSEC is missing before " + here());
    own.line = line_;
    own.number = reference();
    expect('=');
    if (peek() == '(') {
      step();
      while (peek() != ')') own.records.push_back(record());
      step();
      if (own.records.empty()) fail("an entity without a name");
    } else
      own.records.push_back(record());
    expect(';');
    return own;
  }

  StepValue record() {
    StepValue own{.kind = StepValue::Kind::record, .text = name(), .items = {}};
    own.items = list();
    return own;
  }

  std::string_view name() {
    const char first = peek();
    if (!is_upper(first) && first != '!') fail("a name in capitals is missing before " + here());
    const std::size_t from = at_++;
    while (at_ < text_.size() && (is_upper(text_[at_]) || is_digit(text_[at_]))) ++at_;
    return text_.substr(from, at_ - from);
  }

  std::vector<StepValue> list() {
    constexpr int deepest = 100;
    if (++depth_ > deepest) fail("lists within lists, " + std::to_string(deepest) + " deep");
    std::vector<StepValue> items;
    expect('(');
    if (peek() != ')') items.push_back(value());
    while (peek() == ',') {
      step();
      items.push_back(value());
    }
    expect(')');
    --depth_;
    return items;
  }

  StepValue value() {
    StepValue own;
    const char first = peek();
    const std::size_t from = at_;
    if (first == '(') {
      own.kind = StepValue::Kind::list;
      own.items = list();
    } else if (first == '#') {
      own.kind = StepValue::Kind::reference;
      own.reference = reference();
    } else if (first == '\'' || first == '"') {
      own.kind = StepValue::Kind::text;
      quoted(first);
    } else if (first == '.') {
      own.kind = StepValue::Kind::word;
      step();
      own.text = name();
      if (at_ >= text_.size() || text_[at_] != '.') fail("'.' is missing before " + here());
      step();
    } else if (first == '$' || first == '*')
      step();
    else if (is_upper(first) || first == '!')
      own = record();
    else {
      own.kind = StepValue::Kind::number;
      number();
      own.text = text_.substr(from, at_ - from);
    }
    return own;
  }

  void quoted(char quote) {
    const int from = line_;
    step();
    for (;; step()) {
      if (at_ >= text_.size()) step_error(from, "a text does not end");
      if (text_[at_] != quote) continue;
      if (at_ + 1 >= text_.size() || text_[at_ + 1] != quote) break;
      step();
    }
    step();
  }

  void number() {
    const std::size_t from = at_;
    const auto digits = [&] {
      const std::size_t first = at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      return at_ - first;
    };
    if (text_[at_] == '+' || text_[at_] == '-') ++at_;
    std::size_t count = digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      count += digits();
    }
    if (count > 0 && at_ < text_.size() && (text_[at_] == 'E' || text_[at_] == 'e')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      count = digits();
      constexpr std::size_t longest = 3; // digits of an exponent
      if (count > longest) count = 0;
    }
    if (count == 0) {
      at_ = from;
      fail("no value: " + here());
    }
  }

  int reference() {
    step();
    const std::size_t from = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    int number = 0;
    const auto [end, error] = std::from_chars(text_.data() + from, text_.data() + at_, number);
    if (error == std::errc::result_out_of_range)
      fail("entity number #" + std::string(text_.substr(from, at_ - from).substr(0, 30)) +
           " is above 2147483647");
    if (error != std::errc{} || number == 0) fail("a number above 0 is missing after '#'");
    return number;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, depth_ = 0;
};

} // namespace

const StepValue* StepEntity::record(std::string_view name) const {
  const auto found = std::find_if(records.begin(), records.end(),
                                  [&](const StepValue& r) { return r.text == name; });
  return found == records.end() ? nullptr : &*found;
}

void parse_step(std::string_view text, const std::function<void(const StepEntity&)>& found) {
  constexpr std::string_view mark = "\xEF\xBB\xBF"; // of UTF-8
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  Parser(text).exchange(found);
}

void step_error(int line, const std::string& what) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + what);
}

} // namespace plica
