#include "io/input/supposition_file.hpp"

#include "io/input/field_reader.hpp"
#include "model/description/diagnosis_fields.hpp"

namespace plica {

SuppositionFile read_supposition(const std::string& path) {
  ReadLog log{.file = path};
  const YamlNode root = read_yaml(path, log.problems).root;
  if (root.kind == YamlNode::Kind::null) throw InputError(std::move(log.problems));
  SuppositionFile file{.data = {}, .path = path, .lines = {}};
  FieldReader::read(root, "", file.data, log);
  if (!log.problems.empty()) {
    sort_by_line(log.problems, log.file);
    throw InputError(std::move(log.problems));
  }
  file.lines = std::move(log.lines);
  return file;
}

} // namespace plica
