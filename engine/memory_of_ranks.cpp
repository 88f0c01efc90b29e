#include "engine/memory_of_ranks.hpp"

#include "mesh/machine_memory.hpp"

#include <array>
#include <cmath>
#include <fmt/core.h>

namespace plica {
namespace {

int ranks_of_this_node(const Ranks& ranks) {
  MPI_Comm node = MPI_COMM_NULL;
  int size = 1;
  MPI_Comm_split_type(ranks.comm(), MPI_COMM_TYPE_SHARED, ranks.rank(), MPI_INFO_NULL, &node);
  MPI_Comm_size(node, &size);
  MPI_Comm_free(&node);
  return size;
}

std::string name_of_this_node() {
  std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
  int length = 0;
  MPI_Get_processor_name(name.data(), &length);
  return {name.data(), std::size_t(length)};
}

} // namespace

double memory_of_rank(double unknowns, int ranks) {
  const double entries = 3.4e7 * std::pow(unknowns / 141420, 1.1); // of the factor
  return 1.1e8 + 700 * unknowns + (14 * entries + 5000 * unknowns) / ranks;
}

void require_memory_of_nodes(double unknowns, const Ranks& ranks) {
  require_memory_of_nodes(memory_of_rank(unknowns, ranks.size()), unknowns, ranks);
}

void require_memory_of_nodes(double bytes, double unknowns, const Ranks& ranks) {
  const int here = ranks_of_this_node(ranks);
  const double need = here * bytes;
  const MemoryLimit limit = memory_limit();
  const std::string words =
      need <= limit.bytes
          ? ""
          : fmt::format(
                "{} unknowns on {} rank{} need about {:.2g} GB on node {}, which runs {} of "
                "them; {} is {:.2g} GB. Take more nodes, or fewer ranks on each",
                (long long)unknowns, ranks.size(), ranks.size() == 1 ? "" : "s", need / 1e9,
                name_of_this_node(), here, limit.set_by, limit.bytes / 1e9);
  for (const std::string& text : ranks.everyones(words))
    if (!text.empty()) throw TooLarge(text);
}

} // namespace plica
