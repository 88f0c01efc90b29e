// What a writer leaves in a folder, as a command has it.
#pragma once

#include "io/files/output_folder.hpp"

namespace plica::test {

template <class Write> void written(const std::filesystem::path& folder, Write&& write) {
  OutputFolder out(folder, {.command = "test", .inputs = {}, .names = {}});
  write(out);
  out.commit();
  out.remove_stale();
}

} // namespace plica::test
