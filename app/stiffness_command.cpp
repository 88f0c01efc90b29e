#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/case_file.hpp"
#include "io/lab_files/stiffness_table.hpp"
#include "io/tables/stiffness_words.hpp"
#include "io/write/write_stiffness.hpp"
#include "run/study/part_stiffness.hpp"
#include "solve/sparse_factor.hpp"
#include "words/directions.hpp"
#include "words/field_types.hpp"
#include "words/units.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace plica {
namespace {

struct StiffnessOptions {
  ChosenCase chosen;
  Output out;
  int threads = 0;
  std::vector<std::string> frequencies{"0:500:2"}, amplitudes, angles, states, offsets;
  std::string measured;
  bool millimetres = false;
  StiffnessRequest request;
};

double number_of(const std::string& text, Dimension dimension, const std::string& option) {
  const ParsedQuantity parsed = parse_quantity(text, dimension);
  if (!parsed.wrong.empty()) input_error(option, parsed.wrong, parsed.allowed);
  return parsed.value;
}

// "10:500:2" or single ones, increasing, each once.
Eigen::VectorXd frequencies(const std::vector<std::string>& texts) {
  constexpr double most = 100000;
  const std::string option = "--frequencies", allowed = "FROM:TO:STEP, or frequencies, in Hz";
  std::vector<double> list;
  for (const std::string& text : texts) {
    const auto first = text.find(':'), second = text.find(':', first + 1);
    if (first == std::string::npos) {
      list.push_back(number_of(text, Dimension::frequency, option));
      continue;
    }
    if (second == std::string::npos) input_error(option, "'" + text + "' has no step", allowed);
    const auto part = [&](std::size_t from, std::size_t to) {
      return number_of(text.substr(from, to - from), Dimension::frequency, option);
    };
    const double low = part(0, first), high = part(first + 1, second),
                 step = part(second + 1, text.size());
    if (!(step > 0) || !(high >= low) || (high - low) / step > most)
      input_error(option, "'" + text + "' is no range", allowed);
    const auto count = long(std::floor((high - low) / step * (1 + 1e-12) + 1e-9));
    for (long k = 0; k <= count; ++k) list.push_back(low + double(k) * step);
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  if (list.empty() || list.front() < 0) input_error(option, "are below zero", allowed);
  return Eigen::Map<Eigen::VectorXd>(list.data(), long(list.size()));
}

std::vector<double> amplitudes(const std::vector<std::string>& texts, Dimension dimension,
                               const std::string& option) {
  std::vector<double> list;
  for (const std::string& text : texts) {
    list.push_back(number_of(text, dimension, option));
    if (!(list.back() > 0))
      input_error(option, "'" + text + "' is not above zero", "amplitudes; small motion is there");
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

std::vector<MotionLevel> levels_of(const StiffnessOptions& options) {
  const auto lengths = amplitudes(options.amplitudes, Dimension::length, "--amplitudes");
  const auto angles = amplitudes(options.angles, Dimension::angle, "--angles");
  if (!lengths.empty() && !angles.empty() && lengths.size() != angles.size())
    input_error("--angles", fmt::format("are {} for {} amplitudes", angles.size(), lengths.size()),
                "as many: they go together, or one of both alone");
  std::vector<MotionLevel> levels(std::max(lengths.size(), angles.size()));
  for (std::size_t k = 0; k < lengths.size(); ++k) levels[k].translation = lengths[k];
  for (std::size_t k = 0; k < angles.size(); ++k) levels[k].rotation = angles[k];
  return levels;
}

// "0", "y=5mm", "rx=2deg".
std::vector<OffsetOfEnd> shifts_of(const std::vector<std::string>& texts) {
  const std::string option = "--offsets",
                    allowed = "0, or DIRECTION=LENGTH or ANGLE: y=5mm, rx=2deg";
  std::vector<OffsetOfEnd> list;
  for (const std::string& text : texts) {
    if (text == "0") {
      list.emplace_back();
      continue;
    }
    const auto at = text.find('=');
    const int direction = place_among(direction_names, text.substr(0, at));
    if (at == std::string::npos || direction < 0)
      input_error(option, "'" + text + "' is no offset", allowed);
    list.push_back(
        {direction, number_of(text.substr(at + 1),
                              direction < 3 ? Dimension::length : Dimension::angle, option)});
  }
  return list;
}

// "0", "hot": names of the case's states.
std::vector<std::string> states_of(const std::vector<std::string>& texts) {
  std::vector<std::string> list;
  for (const std::string& text : texts) {
    const std::string name = text == "0" ? "" : text;
    if (std::find(list.begin(), list.end(), name) != list.end())
      input_error("--states", "'" + text + "' is there twice", "each state once");
    list.push_back(name);
  }
  return list;
}

int stiffness(StiffnessOptions& options) {
  set_threads(options.threads);
  StiffnessRequest& request = options.request;
  request.hertz = frequencies(options.frequencies);
  request.levels = levels_of(options);
  request.states = states_of(options.states);
  request.shifts = shifts_of(options.offsets);
  const CaseFile file = read_case(options.chosen);
  const bool beside = !options.measured.empty();
  const std::vector<MeasuredStiffness> measured =
      beside ? read_stiffness_table(options.measured) : std::vector<MeasuredStiffness>{};
  for (const MeasuredStiffness& m : measured) // modes reach as far as the test
    if (m.hertz > request.hertz.maxCoeff()) request.highest = std::max(request.highest, m.hertz);
  std::vector<std::filesystem::path> inputs = files_of(file);
  if (beside) inputs.emplace_back(options.measured);
  OutputFolder out(options.out.folder,
                   {.command = "stiffness", .inputs = inputs, .names = stiffness_files(beside)});
  Progress progress(options.out.quiet);
  progress.title(file.data.name);
  const EndDynamicStiffness found = with_doubts(file, [&] {
    return located(file, [&] {
      return part_stiffness(file.data, request, [&](const std::string& s) { progress.stage(s); });
    });
  });
  const std::vector<StiffnessComparison> compared =
      beside ? compare_stiffness(found, measured, request.harmonics, request.samples)
             : std::vector<StiffnessComparison>{};
  write_stiffness(found, compared, options.millimetres, out);
  hand_over(out);
  progress.finish();
  if (!options.out.quiet)
    print(fmt::format("{}\nReport: {}\n", stiffness_text(found, compared),
                      (out.path() / "stiffness.html").string()));
  return std::any_of(found.states.begin(), found.states.end(),
                     [](const StateStiffness& s) { return s.over.not_found > 0; })
             ? 2
             : 0;
}

} // namespace

void add_stiffness_command(CommandLine& line) {
  const auto options = std::make_shared<StiffnessOptions>();
  CLI::App& command =
      line.add("stiffness", "dynamic stiffness between two ends over frequency and amplitude",
               [options] { return stiffness(*options); });
  add_case(command, options->chosen);
  add_output(command, options->out);
  add_threads(command, options->threads);
  const auto list = [&](const std::string& name, std::vector<std::string>& into,
                        const std::string& type, const std::string& help) {
    return command.add_option(name, into, help)
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name(type);
  };
  list("--ends", options->request.ends, "NAME,NAME",
       "the end that moves and the one that is held: names of caps; left out: the two of the case");
  list("--frequencies", options->frequencies, "FROM:TO:STEP,HZ,...",
       "ranges and single frequencies, Hz")
      ->capture_default_str();
  list("--amplitudes", options->amplitudes, "LENGTH,...",
       "of the moving end, e.g. 0.1mm,1mm; small motion is always there");
  list("--angles", options->angles, "ANGLE,...", "the same of its rotations, e.g. 0.1deg,1deg");
  list("--offsets", options->offsets, "SHIFT,...",
       "states: 0 as the case has it, y=5mm or rx=2deg with the moving end shifted from there");
  list("--states", options->states, "NAME,...",
       "named states of the case, 0 for its own; the offsets begin at each of them");
  command
      .add_option("--harmonics", options->request.harmonics,
                  "the highest of the harmonic balance of joints with friction")
      ->check(CLI::Range(1, 31))
      ->capture_default_str();
  command.add_option("--measured", options->measured, "table of a rig, set beside it")
      ->type_name("FILE.csv");
  add_choice(command, "--units", options->millimetres, {{"m", false}, {"mm", true}},
             "of the decks: m (kg, s, N) or mm (t, s, N)")
      ->type_name("m|mm");
}

} // namespace plica
