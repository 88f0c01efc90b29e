// Records of a universal file in fixed columns, each field checked.
#pragma once

#include <string>

namespace plica::universal {

class Fields {
public:
  // Begins with the -1 and the line of the number, e.g. "    58".
  Fields(std::string set, const std::string& number_line);

  // Errors name it from here on.
  Fields& record(int number);
  [[noreturn]] void fail(const std::string& wrong, const std::string& allowed) const;

  Fields& whole(long value, int width);
  Fields& name(const std::string& text, int width); // left-justified
  // E format. Decimals give way where the field is too narrow; a blank always stands before a
  // positive number.
  Fields& real(double value, int width, int decimals, char letter = 'E');
  // E13.5, or E13.6 where that leaves a blank and tells more.
  Fields& abscissa(double value);
  Fields& id(const std::string& text); // a line of its own
  Fields& end_line();
  Fields& bytes(const std::string& data);

  // All of it with the closing -1.
  std::string closed() const { return text_ + "    -1\n"; }

private:
  std::string set_, text_;
  int record_ = 0;
};

} // namespace plica::universal
