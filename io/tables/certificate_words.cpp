#include "io/tables/certificate_words.hpp"

#include "io/tables/state_words.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plica {

std::vector<CertificateLine> certificate_lines(const Certificate& c) {
  std::vector<CertificateLine> lines{
      {"asymmetry", "asymmetry of K and M", c.asymmetry},
      {"smallest_mass", "smallest eigenvalue of M / largest", c.smallest_mass},
      {"negative_stiffness", "most negative eigenvalue of K / largest", c.negative_stiffness},
      {"grounding",
       c.preloaded ? "force of a rigid motion off that of the preload"
                   : "force of a rigid motion / stiffness",
       c.grounding},
      {"rigid_modes", "lowest six modes off the rigid motions", c.rigid_modes},
      {"coordinates", "coordinates found from K off the drawn ones, m", c.coordinates},
      {"mass", "mass off that of the part", c.mass},
      {"centre", "centre of mass off that of the part, m", c.centre},
      {"inertia", "inertia off that of the part", c.inertia}};
  if (c.preloaded) // no rigid rotation is free
    std::erase_if(lines, [](const CertificateLine& line) {
      return line.key == std::string("rigid_modes") || line.key == std::string("coordinates") ||
             line.key == std::string("negative_stiffness");
    });
  if (std::isfinite(c.statics))
    lines.push_back({"statics", "static stiffness off that of the part", c.statics});
  if (c.statics_known_to > 0)
    lines.push_back({"statics_known_to", "the part's own is known to", c.statics_known_to});
  return lines;
}

std::string reach_of(const ReducedCase& r) {
  const Certificate& c = r.certificate;
  std::string text =
      c.free.empty()
          ? "Good for stiffness and mass; no frequency of the part lies below the cut-off, "
            "so nothing is known of modes."
          : fmt::format("Good up to {} Hz with an error of {} %.", significant(c.good_up_to, 4),
                        significant(100 * c.error, 2));
  if (r.asked > c.good_up_to)
    text += fmt::format(" The case asks for {} Hz: raise the cut-off of {} Hz.",
                        significant(r.asked, 4), significant(r.cutoff, 4));
  return text;
}

std::string certificate_text(const ReducedCase& r) {
  const Certificate& c = r.certificate;
  const Superelement& s = r.element;
  std::string text =
      fmt::format("Superelement {}: {} boundary nodes, {} modes up to {} Hz, {}\n", s.name,
                  s.nodes.size(), s.modal(), significant(r.cutoff, 4), r.route);
  if (r.state) {
    text += "Around the state" + (r.state->name.empty() ? "" : " " + r.state->name) + ": ";
    for (const std::string& sentence : state_sentences(*r.state)) text += sentence + "\n  ";
    text.resize(text.size() - 2);
  }
  text += r.proved ? "Proved, no fixed-interface mode below the cut-off is missing.\n"
                   : "Not proved: " + r.reason + "\n";
  if (r.left_out.count > 0)
    text +=
        fmt::format("Left out: {} modes from {} Hz on that carry at most {} % of the interface "
                    "mass each, {} % together.\n",
                    r.left_out.count, significant(r.left_out.lowest, 4),
                    significant(100 * r.left_out.largest, 2), significant(100 * r.left_out.sum, 2));
  TextRows lines, frequencies;
  for (const CertificateLine& line : certificate_lines(c))
    lines.push_back({line.text, significant(line.value, 2)});
  if (!c.preloaded) lines.push_back({"zero eigenvalues of K", std::to_string(c.zero_stiffness)});
  text += text_table(lines, "<>");
  text += c.preloaded ? "  frequencies with the first cap held, Hz: part, superelement, error %\n"
                      : "  free-interface frequencies, Hz: part, superelement, error %\n";
  for (const FrequencyCheck& f : c.free)
    frequencies.push_back({fmt::format("{:.3f}", f.full), fmt::format("{:.3f}", f.reduced),
                           with_sign(100 * f.error(), 4),
                           f.full > c.good_up_to ? "beyond its band" : ""});
  text += text_table(frequencies, ">>><");
  if (c.free.empty()) text += "  none below the cut-off: nothing compared\n";
  text += reach_of(r) + "\n";
  text += c.passed ? "The certificate is passed.\n" : "The certificate FAILED:\n";
  for (const std::string& failure : c.failures) text += "  " + failure + "\n";
  return text;
}

} // namespace plica
