// Records of a universal file in fixed columns, each field checked.
#pragma once

#include <string>

namespace plica {

class UniversalFields {
public:
  // Begins with the -1 and the line of the number, e.g. "    58".
  UniversalFields(std::string set, const std::string& number_line);

  // Errors name it from here on.
  UniversalFields& record(int number);
  [[noreturn]] void fail(const std::string& wrong, const std::string& allowed) const;

  UniversalFields& whole(long value, int width);
  UniversalFields& name(const std::string& text, int width); // left-justified
  // E format. Decimals give way where the field is too narrow; a blank always stands before a
  // positive number.
  UniversalFields& real(double value, int width, int decimals, char letter = 'E');
  // E13.5, or E13.6 where that leaves a blank and tells more.
  UniversalFields& abscissa(double value);
  UniversalFields& id(const std::string& text); // a line of its own
  UniversalFields& end_line();
  UniversalFields& bytes(const std::string& data);

  // All of it with the closing -1.
  std::string closed() const { return text_ + "    -1\n"; }

private:
  std::string set_, text_;
  int record_ = 0;
};

} // namespace plica
