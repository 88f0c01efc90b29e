#include "io/write/write_supposition.hpp"

#include "io/write/write_diagnosis.hpp"

namespace plica {

std::vector<std::string> supposition_files() {
  return {"supposed.json"};
}

void write_supposition(const Ledger& ledger, const std::string& case_name,
                       const std::string& plica_version, OutputFolder& out) {
  Json json{{"case", case_name}, {"plica_version", plica_version}, {"version", 1}};
  json.update(ledger_json(ledger));
  out.add("supposed.json", json_text(json));
}

} // namespace plica
