// The files that `plica init` writes, every line explained.
#pragma once

#include <string>
#include <vector>

namespace plica {

// A bellows with an interlock; a decoupler between pipes; an exhaust line with hangers and orders
// of the engine, solved with superelements; a beam with a mass; that with measured data beside it.
enum class Starter { bellows, decoupler, line, beam, measured };

struct StarterFile {
  std::string name, text;
};

// `name`: of the case; letters, digits and underscores. The case first.
std::vector<StarterFile> starter_files(Starter kind, const std::string& name);

} // namespace plica
