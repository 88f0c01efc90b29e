// From the poles and residues of a least-squares fit to modes.
#pragma once

#include "lab/identification/identification.hpp"
#include "lab/identification/modal_fit.hpp"
#include "lab/identification/pole_search.hpp"

namespace plica {

// A pole that no response needs (all residues below five of their standard deviations), that the
// fit moved out of the band, or that is known to no better than its own size, is one of the noise.
bool is_noise(const FittedMode& mode, double low, double high);

// Fits until all modes stand out of the noise and no two share a tenth of half their bandwidth;
// `fit` gives what fits from given poles.
ModalFit fit_significant(const std::function<ModalFit(const Poles&)>& fit, Poles poles, double low,
                         double high);

// Frequency, damping and their deviations; shape and participation as the first singular vectors of
// the residues, the shape as real as can be with 1 as its largest.
IdentifiedMode mode_of(const FittedMode& mode);

// Orders of the diagram with a stable pole within a quarter of the mode's bandwidth.
int orders_that_show(const std::vector<DiagramPole>& diagram, const IdentifiedMode& mode);

} // namespace plica
