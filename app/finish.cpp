#include "app/finish.hpp"

#include "app/terminal.hpp"
#include "model/shape/doubts.hpp"

#include <fmt/core.h>

namespace plica {

void hand_over(OutputFolder& out) {
  out.commit();
  for (const std::string& name : out.remove_stale())
    say(fmt::format("plica: {} stays: it was changed since plica wrote it\n",
                    (out.path() / name).string()));
  if (speaks_json()) say_written(out.command(), read_manifest(out.path()));
}

void say_doubts(const Case& data) {
  try {
    for (const std::string& doubt : doubts(data, build(data))) say_warning(doubt);
  } catch (const std::exception&) { // nothing could be built: the failure says why
  }
}

} // namespace plica
