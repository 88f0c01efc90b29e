// Equivalent pipes and chains of connectors as beams, springs and masses along the axis.
#pragma once

#include "model/description/case.hpp"
#include "solve/model.hpp"

namespace plica {

// Numbers of the end nodes; all nodes of the part lie between them.
struct AxisNodes {
  int left = 0, right = 0;
};

// Beams of all layers on common nodes.
AxisNodes add_pipe(Model& model, const EquivalentPipe& pipe, const Material& material,
                   int component);

// `name` stands in errors of the couplings of its arms.
AxisNodes add_chain(Model& model, const ConnectorChain& chain, int component,
                    const std::string& name);

} // namespace plica
