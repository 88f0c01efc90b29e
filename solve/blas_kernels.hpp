// A guard against a BLAS that computes wrongly.
#pragma once

namespace plica {

// OpenBLAS 0.3.21, which Debian 12 has, returns numbers that are none from its AVX-512 kernels
// (SkylakeX, Cooperlake) when CHOLMOD factors parts of a bellows; with those for AVX2 the same
// factor is right. The kernels are chosen when the library is loaded, so the program starts itself
// once more with OPENBLAS_CORETYPE=Haswell, unless the user has set that variable. To be called
// first of all.
void avoid_faulty_blas_kernels(char** argv);

} // namespace plica
