#include "io/write/write_identification.hpp"

#include "io/files/json_text.hpp"
#include "io/report/identification.hpp"
#include "io/tables/csv.hpp"
#include "io/tables/text.hpp"
#include "io/tables/text_table.hpp"
#include "io/universal/signals.hpp"
#include "io/universal/writer.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
Json json_of(const Identification& found, const IdentifiedMode& m) {
  Json shape = Json::array(), participation = Json::array();
  for (std::size_t c = 0; c < found.set.responses.size(); ++c)
    shape.push_back({{"channel", found.set.responses[c]},
                     {"real", m.shape[Index(c)].real()},
                     {"imaginary", m.shape[Index(c)].imag()},
                     {"sigma", m.sigma_shape[Index(c)]}});
  for (std::size_t i = 0; i < found.set.references.size(); ++i)
    participation.push_back({{"channel", found.set.references[i]},
                             {"real", m.participation[Index(i)].real()},
                             {"imaginary", m.participation[Index(i)].imag()}});
  return {
      {"frequency", m.frequency},
      {"sigma_frequency", m.sigma_frequency},
      {"damping", m.damping},
      {"sigma_damping", m.sigma_damping},
      {"mass_normalised", m.mass_normalised},
      {"shape", shape},
      {"participation", participation},
      {"collinearity", m.collinearity},
      {"rank", m.rank},
      {"share", m.share},
      {"orders", m.orders},
      {"consistency", json_number(m.consistency)},
      {"strongest", m.strongest},
      {"circle_fit",
       {{"frequency", json_number(m.circle_frequency)},
        {"damping", json_number(m.circle_damping)}}},
      {"peak",
       {{"frequency", json_number(m.peak_frequency)}, {"damping", json_number(m.peak_damping)}}}};
}

// Poles of rising order; "stable" says what holds against the order below.
Json diagram_json(const std::vector<DiagramPole>& diagram) {
  constexpr std::array words{"new", "frequency", "damping", "all"};
  Json poles = Json::array();
  for (const DiagramPole& p : diagram)
    poles.push_back({{"order", p.order},
                     {"frequency", json_number(p.pole.frequency())},
                     {"damping", json_number(p.pole.damping())},
                     {"stable", words[std::size_t(p.stability)]}});
  return poles;
}

// Root of the summed squares of all responses, behind the diagram.
Json indicator_json(const FrfSet& set) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(set.hertz.size());
  for (const Eigen::MatrixXcd& H : set.H) squares += H.rowwise().squaredNorm();
  Json value = Json::array(), hertz = Json::array();
  for (Index k = 0; k < set.hertz.size(); ++k) {
    hertz.push_back(json_number(set.hertz[k]));
    value.push_back(json_number(std::sqrt(squares[k])));
  }
  return {{"frequency", hertz}, {"value", value}};
}

Json json_of(const LinearityOfSet& linearity) {
  Json json{{"reciprocity", Json::array()},
            {"coherence_drops", Json::array()},
            {"distortion", Json::array()}};
  for (const Reciprocity& r : linearity.reciprocity)
    json["reciprocity"].push_back(
        {{"a", r.a}, {"b", r.b}, {"frac", r.frac}, {"difference", r.difference}});
  for (const CoherenceDrop& d : linearity.coherence_drops)
    json["coherence_drops"].push_back(
        {{"response", d.response}, {"frequency", d.frequency}, {"coherence", d.coherence}});
  for (const Distortion& d : linearity.distortion)
    json["distortion"].push_back(
        {{"response", d.response}, {"frequency", d.frequency}, {"distortion", d.distortion}});
  return json;
}

std::string linearity_text(const LinearityOfSet& linearity) {
  std::string text;
  for (const Reciprocity& r : linearity.reciprocity)
    text += fmt::format("Reciprocity of {} and {}: FRAC {}, difference {} %.\n", r.a, r.b,
                        significant(r.frac, 4), significant(100 * r.difference, 2));
  for (const CoherenceDrop& d : linearity.coherence_drops)
    text +=
        fmt::format("Coherence of {} is {} at the peak of {} Hz: a nonlinearity, leakage or a bad "
                    "channel; noise alone shows least where the response is large.\n",
                    d.response, significant(d.coherence, 2), significant(d.frequency, 4));
  for (const Distortion& d : linearity.distortion)
    text += fmt::format("Harmonic distortion of {}: at most {} %, at {} Hz.\n", d.response,
                        significant(100 * d.distortion, 2), significant(d.frequency, 4));
  return text;
}

std::string modes_text(const std::vector<IdentifiedMode>& modes) {
  TextRows rows{{"Hz", "+/-", "damping %", "+/-", "circle fit Hz", "%", "peak Hz", "%", "share %"}};
  const auto cell = [](double x, int decimals) {
    return std::isfinite(x) ? fmt::format("{:.{}f}", x, decimals) : "-";
  };
  for (const IdentifiedMode& m : modes)
    rows.push_back({cell(m.frequency, 4), significant(m.sigma_frequency, 2),
                    cell(100 * m.damping, 4), significant(100 * m.sigma_damping, 2),
                    cell(m.circle_frequency, 3), cell(100 * m.circle_damping, 3),
                    cell(m.peak_frequency, 3), cell(100 * m.peak_damping, 3),
                    cell(100 * m.share, 2)});
  return text_table(rows, ">");
}

} // namespace

std::string identification_json(const Identification& found, const LinearityOfSet& linearity,
                                const std::string& title) {
  Json json;
  constexpr std::array sources{"responses", "free_decay", "output_only"};
  json["title"] = title;
  json["from"] = sources[std::size_t(found.source)];
  json["band"] = {found.set.hertz[0], found.set.hertz[found.set.hertz.size() - 1]};
  json["responses"] = found.set.responses;
  json["references"] = found.set.references;
  json["misfit"] = found.misfit;
  json["modes"] = Json::array();
  for (const IdentifiedMode& m : found.modes) json["modes"].push_back(json_of(found, m));
  json["stabilisation"] = diagram_json(found.diagram);
  json["indicator"] = indicator_json(found.set);
  json["frac"] = Json::array();
  for (Index i = 0; i < found.frac.cols(); ++i)
    for (std::size_t c = 0; c < found.set.responses.size(); ++c)
      json["frac"].push_back({{"response", found.set.responses[c]},
                              {"reference", found.set.references[std::size_t(i)]},
                              {"value", found.frac(Index(c), i)}});
  json["linearity"] = json_of(linearity);
  json["warnings"] = found.warnings;
  return json_text(json);
}

std::string identified_csv(const Identification& found) {
  std::string text =
      "mode,frequency [Hz],sigma [Hz],damping [fraction of critical],sigma of damping,"
      "circle fit [Hz],circle fit damping,peak [Hz],half-power damping,share,"
      "collinearity\n";
  const auto cell = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; };
  for (std::size_t r = 0; r < found.modes.size(); ++r) {
    const IdentifiedMode& m = found.modes[r];
    text += std::to_string(r + 1);
    for (double x : {m.frequency, m.sigma_frequency, m.damping, m.sigma_damping, m.circle_frequency,
                     m.circle_damping, m.peak_frequency, m.peak_damping, m.share, m.collinearity})
      text += "," + cell(x);
    text += "\n";
  }
  return text;
}

std::string measured_modes_yaml(const Identification& found) {
  std::string text =
      "# Modes as entries of a measured.yaml; say of each what shape it is.\nmodes:\n";
  std::string channels;
  for (const std::string& c : found.set.responses) channels += (channels.empty() ? "" : ", ") + c;
  for (const IdentifiedMode& m : found.modes) {
    std::string real, imaginary;
    for (const std::complex<double>& x : m.shape) {
      real += fmt::format("{}{:.6g}", real.empty() ? "" : ", ", x.real());
      imaginary += fmt::format("{}{:.6g}", imaginary.empty() ? "" : ", ", x.imag());
    }
    text += fmt::format("  - frequency: {:.6g} Hz\n    sigma: {:.3g} Hz\n    damping: {:.5g}\n"
                        "    sigma_damping: {:.3g}\n    shape: other\n    note: {}\n"
                        "    vector: {{channels: [{}], real: [{}], imaginary: [{}]}}\n",
                        m.frequency, m.sigma_frequency, m.damping, m.sigma_damping,
                        m.mass_normalised ? "mass-normalised shape, 1/sqrt(kg)"
                                          : "shape with 1 as its largest",
                        channels, real, imaginary);
  }
  return found.modes.empty() ? "# No mode was found.\nmodes: []\n" : text;
}

std::string identification_text(const Identification& found, const LinearityOfSet& linearity,
                                const std::string& title) {
  constexpr std::array kinds{"references", "decays", "excitation that nobody measured"};
  std::string text =
      fmt::format("{}: {} responses, {} {}, {} lines from {} to {} Hz\n\n", title,
                  found.set.responses.size(), found.set.H.size(), kinds[std::size_t(found.source)],
                  found.set.hertz.size(), significant(found.set.hertz[0], 4),
                  significant(found.set.hertz[found.set.hertz.size() - 1], 4));
  text += modes_text(found.modes);
  constexpr std::array whole{"responses", "decays", "correlations"};
  text += fmt::format("\nThe modes leave {} % RMS of the {} unexplained",
                      significant(100 * found.misfit, 3), whole[std::size_t(found.source)]);
  if (found.frac.size() > 0)
    text += fmt::format("; FRAC {} to {}", significant(found.frac.minCoeff(), 4),
                        significant(found.frac.maxCoeff(), 4));
  text += ".\n";
  text += linearity_text(linearity);
  for (const std::string& warning : found.warnings) text += "Warning: " + warning + ".\n";
  return text;
}

std::vector<std::string> identification_files(bool noise, bool time) {
  std::vector<std::string> names{"identified.csv", "measured_modes.yaml", "shapes.uff",
                                 "identification.html", "identification.json"};
  if (!time) names.insert(names.end(), {"frf.uff", "synthesised.uff"});
  if (noise) names.emplace_back("spectra.csv");
  return names;
}

void write_identification(const Identification& found, const LinearityOfSet& linearity,
                          const std::string& title, OutputFolder& out, const std::string& below) {
  out.add(below + "identified.csv", identified_csv(found));
  out.add(below + "measured_modes.yaml", measured_modes_yaml(found));
  const auto text_of = [](const FrfSet& set) {
    std::string text;
    for (const UniversalFunction& f : universal_functions(set)) text += universal_text(f);
    return text;
  };
  std::string shapes;
  for (const UniversalShape& s : universal_shapes(found)) shapes += universal_text(s);
  out.add(below + "shapes.uff", shapes);
  if (found.source == IdentifiedFrom::responses) {
    FrfSet synthesised = found.set;
    synthesised.H = found.synthesised;
    out.add(below + "frf.uff", text_of(found.set));
    out.add(below + "synthesised.uff", text_of(synthesised));
  }
  out.add(below + "identification.html", identification_html(found, title));
  out.add(below + "identification.json", identification_json(found, linearity, title));
}

std::string levels_text(const std::vector<LevelVerdict>& levels,
                        const std::vector<Homogeneity>& homogeneity) {
  std::string text = "\nOver the levels\n";
  for (const LevelVerdict& v : levels) text += "  " + v.what + ": " + v.verdict + "\n";
  for (const Homogeneity& h : homogeneity)
    text += fmt::format("  {}, {}: {:g} against {:g}, FRAC {}, difference {} %\n", h.reference,
                        h.response, h.level_a, h.level_b, significant(h.frac, 4),
                        significant(100 * h.difference, 2));
  return text;
}

void write_levels(const std::vector<LevelVerdict>& levels,
                  const std::vector<Homogeneity>& homogeneity, OutputFolder& out) {
  const auto slope = [](const LevelSlope& s) {
    return Json{
        {"exponent", s.slope}, {"sigma", s.sigma}, {"change", s.change}, {"matters", s.matters}};
  };
  Json json{{"levels", Json::array()}, {"homogeneity", Json::array()}};
  for (const LevelVerdict& v : levels) {
    Json one{{"what", v.what},           {"linear", v.linear},
             {"verdict", v.verdict},     {"level", v.level},
             {"frequency", v.frequency}, {"frequency_slope", slope(v.frequency_slope)}};
    if (v.amplitude_slope) one["amplitude_slope"] = slope(*v.amplitude_slope);
    if (v.damping_slope) one["damping_slope"] = slope(*v.damping_slope);
    json["levels"].push_back(one);
  }
  for (const Homogeneity& h : homogeneity)
    json["homogeneity"].push_back({{"reference", h.reference},
                                   {"response", h.response},
                                   {"levels", {h.level_a, h.level_b}},
                                   {"frac", h.frac},
                                   {"difference", h.difference}});
  out.add(levels_file, json_text(json));
}

std::string spectra_csv(const SignalFrf& frf) {
  std::string text = "frequency [Hz]";
  for (std::size_t c = 0; c < frf.channels.size(); ++c)
    text += "," + csv_cell(fmt::format("density of {} (RMS {}) [unit2/Hz]", frf.channels[c],
                                       significant(frf.rms[Index(c)], 6)));
  for (const std::string& response : frf.set.responses)
    text += "," + csv_cell("coherence of " + response);
  for (Index f = 0; f < frf.set.hertz.size(); ++f) {
    text += fmt::format("\n{}", frf.set.hertz[f]);
    for (Index c = 0; c < frf.density.cols(); ++c) text += fmt::format(",{}", frf.density(f, c));
    for (Index c = 0; c < frf.coherence.cols(); ++c)
      text += fmt::format(",{}", frf.coherence(f, c));
  }
  return text + "\n";
}

} // namespace plica
