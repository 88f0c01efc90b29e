// Runs the tests with the threads of the program.
#include "solve/blas_kernels.hpp"
#include "solve/sparse_factor.hpp"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
  plica::avoid_faulty_blas_kernels(argv);
  testing::InitGoogleTest(&argc, argv);
  plica::set_threads(0);
  return RUN_ALL_TESTS();
}
