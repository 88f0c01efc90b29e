#include "app/command_line.hpp"
#include "app/describe_app.hpp"
#include "app/terminal.hpp"
#include "io/input/reference.hpp"
#include "io/input/schema.hpp"

namespace plica {
namespace {

struct SchemaOptions {
  std::string kind = "case";
  bool reference = false; // in Markdown
};

int print_schema(const SchemaOptions& options, CLI::App& app) {
  if (options.kind == "commands") {
    print(commands_json(app, PLICA_VERSION) + "\n");
    return 0;
  }
  const std::string schema = options.kind == "measured"    ? measured_schema()
                             : options.kind == "benchmark" ? benchmark_schema()
                                                           : case_schema();
  print((options.reference ? reference_of(schema) : schema) + "\n");
  return 0;
}

} // namespace

void add_schema_command(CommandLine& line) {
  const auto options = std::make_shared<SchemaOptions>();
  CLI::App& command = line.add("schema", "print the JSON Schema of the input files",
                               [options, &line] { return print_schema(*options, line.whole()); });
  command.add_flag("--reference", options->reference, "every key in Markdown instead");
  command
      .add_option("KIND", options->kind,
                  "case, measured or benchmark; or commands: the command line itself")
      ->check(CLI::IsMember({"case", "measured", "benchmark", "commands"}))
      ->capture_default_str();
}

} // namespace plica
