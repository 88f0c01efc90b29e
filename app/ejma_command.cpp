#include "app/chosen_case.hpp"
#include "app/command_line.hpp"
#include "app/finish.hpp"
#include "app/progress.hpp"
#include "app/terminal.hpp"
#include "io/input/case_file.hpp"
#include "io/write/write_ejma.hpp"
#include "solve/sparse_factor.hpp"
#include "words/units.hpp"

#include <fmt/core.h>

namespace plica {
namespace {

struct EjmaOptions {
  ChosenCase chosen;
  Output out;
  int threads = 0;
  bool json = false;
  EjmaRequest request;
};

int ejma(const EjmaOptions& options) {
  set_threads(options.threads);
  const CaseFile file = read_case(options.chosen);
  OutputFolder out(options.out.folder, {.command = "ejma",
                                        .inputs = files_of(file),
                                        .names = ejma_files(),
                                        .json_only = options.out.json_only});
  Progress progress(options.out.quiet);
  progress.title(file.data.name);
  const std::vector<EjmaSheet> sheets = with_doubts(file, [&] {
    return located(file, [&] {
      return ejma_sheets(file.data, options.request,
                         [&](const std::string& s) { progress.stage(s); });
    });
  });
  write_ejma(sheets, file.data.name, out);
  hand_over(out);
  progress.finish();
  if (options.json)
    print(ejma_json(sheets, file.data.name));
  else if (!options.out.quiet)
    print(fmt::format("{}\nTables: {}\n", ejma_text(sheets),
                      out.shown("ejma.csv", "ejma.json").string()));
  return 0;
}

// A number with its unit, as in a case file.
template <class Number>
void add_quantity(CLI::App& command, const std::string& name, Number& value, Quantity quantity,
                  const std::string& type, const std::string& help) {
  command
      .add_option_function<std::string>(
          name,
          [&value, quantity](const std::string& text) {
            value = parse_quantity(text, quantity.unit).value;
          },
          help)
      ->check(CLI::Validator(
          [quantity](std::string& text) -> std::string {
            const ParsedQuantity parsed = parse_quantity(text, quantity.unit);
            const bool low =
                quantity.exclusive_min ? parsed.value <= quantity.min : parsed.value < quantity.min;
            if (parsed.wrong.empty() && !low) return "";
            return "'" + text + "' is not " + describe(quantity, quantity.unit);
          },
          ""))
      ->type_name(type);
}

} // namespace

void add_ejma_command(CommandLine& line) {
  const auto options = std::make_shared<EjmaOptions>();
  CLI::App& command =
      line.add("ejma", "the sheet of EJMA formulas for every bellows, beside its shells",
               [options] { return ejma(*options); });
  add_case(command, options->chosen);
  add_output(command, options->out);
  add_threads(command, options->threads);
  EjmaRequest& request = options->request;
  const Quantity above_zero{.min = 0, .exclusive_min = true};
  const auto of = [](Quantity quantity, Dimension unit) {
    quantity.unit = unit;
    return quantity;
  };
  add_quantity(command, "--pressure", request.pressure, {.unit = Dimension::pressure, .min = 0},
               "PRESSURE", "inside over outside, e.g. 50kPa");
  add_quantity(command, "--axial", request.movement.axial, {.unit = Dimension::length}, "LENGTH",
               "movement along the axis from one end position to the other, e.g. 5mm; "
               "compression below 0");
  add_quantity(command, "--lateral", request.movement.lateral, {.unit = Dimension::length},
               "LENGTH", "the same across the axis, both ends parallel");
  add_quantity(command, "--angular", request.movement.angular, {.unit = Dimension::angle}, "ANGLE",
               "the same as a turn of one end, e.g. 2deg");
  add_quantity(command, "--cycles", request.cycles, of(above_zero, Dimension::number), "NUMBER",
               "asked for, of this movement and pressure");
  add_quantity(command, "--yield", request.yield, of(above_zero, Dimension::pressure), "STRESS",
               "yield stress of the formed wall, for in-plane squirm");
  command.add_option("--Kg", request.Kg, "fatigue strength reduction by notches and welds, 1 to 4")
      ->check(CLI::Range(1., 4.))
      ->capture_default_str();
  command.add_flag_callback(
      "--no-shells", [options] { options->request.shells = false; }, "formulas alone");
  command.add_flag("--json", options->json, "print JSON in place of the table");
}

} // namespace plica
