#include "model/description/deck_model.hpp"

#include "mesh/generation/surface_file.hpp"

namespace plica {

DeckFormat deck_format(const std::filesystem::path& file) {
  const std::string suffix = lower_suffix(file);
  if (suffix == ".inp") return DeckFormat::abaqus;
  const bool nastran = suffix == ".bdf" || suffix == ".dat" || suffix == ".nas" || suffix == ".fem";
  return nastran ? DeckFormat::nastran : DeckFormat::none;
}

} // namespace plica
