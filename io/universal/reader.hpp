// Reads a universal file one data set at a time; memory holds one data set.
//
//   UniversalReader reader("measured.uff");
//   while (const std::optional<UniversalDataset> set = reader.next())
//     if (const auto* f = std::get_if<UniversalFunction>(&*set)) use(*f);
//
// What real files do and the standard does not say is read: line ends of either kind, numbers that
// touch, D exponents or none, free format, other widths, shifted headers, text around data sets.
// Counts that the data do not keep are warnings of the set. What would leave data out or make them
// up is refused with InputError: file, line, "data set 58, record 7", what is wrong, what is right.
// After an error the reader is at its end.
#pragma once

#include "io/universal/file.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plica {

namespace universal {
class Lines;
}

class UniversalReader {
public:
  explicit UniversalReader(const std::filesystem::path& path);
  ~UniversalReader();
  UniversalReader(UniversalReader&&) noexcept;
  UniversalReader& operator=(UniversalReader&&) noexcept;

  // The same from memory; the name stands in errors.
  static UniversalReader of_text(std::string text, std::string name);

  // Nothing at the end of the file. A file without any data set is refused.
  std::optional<UniversalDataset> next();

private:
  explicit UniversalReader(std::unique_ptr<universal::Lines> lines);
  std::unique_ptr<universal::Lines> lines_; // none after the end
  bool found_ = false;                      // any data set
};

// All data sets of a file.
std::vector<UniversalDataset> read_universal(const std::filesystem::path& path);

} // namespace plica
