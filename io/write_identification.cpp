#include "io/write_identification.hpp"

#include "io/files.hpp"
#include "io/report_identification.hpp"
#include "io/results_csv.hpp"
#include "io/results_text.hpp"
#include "io/universal_signals.hpp"
#include "io/universal_writer.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace plica {
namespace {

using Eigen::Index;
using Json = nlohmann::ordered_json;

Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

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
  return {{"frequency", m.frequency},
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
          {"strongest", m.strongest},
          {"circle_fit",
           {{"frequency", number(m.circle_frequency)}, {"damping", number(m.circle_damping)}}},
          {"peak", {{"frequency", number(m.peak_frequency)}, {"damping", number(m.peak_damping)}}}};
}

} // namespace

std::string identification_json(const Identification& found, const std::string& title) {
  Json json;
  json["title"] = title;
  json["band"] = {found.set.hertz[0], found.set.hertz[found.set.hertz.size() - 1]};
  json["responses"] = found.set.responses;
  json["references"] = found.set.references;
  json["misfit"] = found.misfit;
  json["modes"] = Json::array();
  for (const IdentifiedMode& m : found.modes) json["modes"].push_back(json_of(found, m));
  json["frac"] = Json::array();
  for (std::size_t i = 0; i < found.set.references.size(); ++i)
    for (std::size_t c = 0; c < found.set.responses.size(); ++c)
      json["frac"].push_back({{"response", found.set.responses[c]},
                              {"reference", found.set.references[i]},
                              {"value", found.frac(Index(c), Index(i))}});
  json["warnings"] = found.warnings;
  return json.dump(2) + "\n";
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
                        "    sigma_damping: {:.3g}\n    shape: other\n"
                        "    vector: {{channels: [{}], real: [{}], imaginary: [{}]}}\n",
                        m.frequency, m.sigma_frequency, m.damping, m.sigma_damping, channels, real,
                        imaginary);
  }
  return found.modes.empty() ? "# No mode was found.\nmodes: []\n" : text;
}

std::string identification_text(const Identification& found, const std::string& title) {
  std::string text = fmt::format("{}: {} responses, {} references, {} lines from {} to {} Hz\n\n",
                                 title, found.set.responses.size(), found.set.H.size(),
                                 found.set.hertz.size(), significant(found.set.hertz[0], 4),
                                 significant(found.set.hertz[found.set.hertz.size() - 1], 4));
  text += "         Hz       +/-   damping %       +/-   circle fit Hz       %    peak Hz       %  "
          "share %\n";
  const auto cell = [](double x, int width, int decimals) {
    return std::isfinite(x) ? fmt::format("{:>{}.{}f}", x, width, decimals)
                            : fmt::format("{:>{}}", "-", width);
  };
  for (const IdentifiedMode& m : found.modes)
    text += cell(m.frequency, 11, 4) + fmt::format("{:>10}", significant(m.sigma_frequency, 2)) +
            cell(100 * m.damping, 12, 4) +
            fmt::format("{:>10}", significant(100 * m.sigma_damping, 2)) +
            cell(m.circle_frequency, 16, 3) + cell(100 * m.circle_damping, 8, 3) +
            cell(m.peak_frequency, 11, 3) + cell(100 * m.peak_damping, 8, 3) +
            cell(100 * m.share, 9, 2) + "\n";
  text += fmt::format("\nThe modes leave {} % RMS of the responses unexplained; FRAC {} to {}.\n",
                      significant(100 * found.misfit, 3), significant(found.frac.minCoeff(), 4),
                      significant(found.frac.maxCoeff(), 4));
  for (const std::string& warning : found.warnings) text += "Warning: " + warning + ".\n";
  return text;
}

void write_identification(const Identification& found, const std::string& title,
                          const std::filesystem::path& folder) {
  FileSet files(folder);
  files.add("identified.csv", identified_csv(found));
  files.add("measured_modes.yaml", measured_modes_yaml(found));
  std::string shapes, responses;
  for (const UniversalShape& s : universal_shapes(found)) shapes += universal_text(s);
  FrfSet synthesised = found.set;
  synthesised.H = found.synthesised;
  for (const UniversalFunction& f : universal_functions(synthesised))
    responses += universal_text(f);
  files.add("shapes.uff", shapes);
  files.add("synthesised.uff", responses);
  files.add("report.html", identification_html(found, title));
  files.add("identification.json", identification_json(found, title));
  files.commit();
}

} // namespace plica
