#include "io/write/explained_case.hpp"

#include "io/tables/effect_words.hpp"

#include <fmt/format.h>

namespace plica {
namespace {

// As a diagnosis shows them: "joint_stiffness at interlock, ratio 0.7".
std::string words_of(const NamedEffect& e) {
  std::string text = effect_label(e);
  for (const EstimatedParameter& p : e.parameters)
    text += fmt::format(", {} {:.4g}{}", p.name, p.value, p.unit.empty() ? "" : " " + p.unit);
  return text;
}

} // namespace

ExplainedCase explained_case(const CaseFile& file, const CaseEdits& fitted, const Diagnosis& d,
                             const std::filesystem::path& measured,
                             const std::filesystem::path& folder) {
  ExplainedCase explained{.data = file.data, .text = {}, .in = {}, .left_out = {}};
  Replacements changes = file.set;
  const auto take = [&](const CaseEdits& edits) {
    for (const CaseEdit& edit : edits) changes[edit.path] = edit.value;
    explained.data = read_case(file, changes).data;
  };
  if (!fitted.empty()) take(fitted);
  for (const LedgerRow& row : d.ledger.rows) { // each into what those before it left
    if (d.effects.empty() || row.effects.empty()) continue;
    const NamedEffect& e = row.effects.front();
    const CaseEdits edits = e.in_case ? e.in_case(explained.data) : CaseEdits();
    (edits.empty() ? explained.left_out : explained.in).push_back(words_of(e));
    if (!edits.empty()) take(edits);
  }
  std::string head = fmt::format("# {}, with the effects in it that its test shows. SI units.\n#\n"
                                 "# {}\n",
                                 d.case_name, d.headline);
  for (const std::string& words : explained.in) head += "# in it: " + words + "\n";
  for (const std::string& words : explained.left_out)
    head += "# not in it, as no key of a case says it: " + words + "\n";
  explained.text = head + "\n" + yaml_of(file, changes, measured, folder);
  return explained;
}

} // namespace plica
