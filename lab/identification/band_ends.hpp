// What the ends of the band do to modes within it: a mode beyond an end, or at it and missed, is in
// no fit but bends those that are, which no scatter of the lines shows.
//
// Each end is cut off once, up to a tenth of the band and to three half-power bandwidths from the
// outermost mode, and the modes are fitted to the rest. What they move by, beyond what noise makes
// of fewer lines (Hausman, Econometrica 46 (1978) 1251-1271: the variance of the difference is that
// of the differences), s^2 = max(0, (x_cut - x)^2 - (sigma_cut^2 - sigma^2)), is added to their
// variance; of both ends the larger.
#pragma once

#include "lab/identification/identification.hpp"
#include "lab/identification/modal_fit.hpp"

namespace plica {

// `modes`: of the fit to the set, in its order.
void widen_by_band_ends(const FrfSet& set, const ModalFit& fit, std::vector<IdentifiedMode>& modes);

} // namespace plica
