// A complex matrix and texts through a MATLAB file, and that file without its end.
#include "expect.hpp"
#include "plica/io/files/files.hpp"
#include "plica/io/matlab/matlab5_elements.hpp"
#include "plica/io/matlab/matlab_file.hpp"

#include <complex>

int main() {
  using namespace plica;
  const std::filesystem::path path = "consumer.mat";
  Eigen::MatrixXcd H(2, 3);
  H << 1, 2, 3, std::complex<double>(4, -0.1), 5, std::complex<double>(0, 1e-300);
  const std::vector<std::string> channels{"mid.y", "tip.x"};
  {
    MatlabWriter out(path, "written by a consumer");
    out.put(matlab_matrix("H", H));
    out.put(matlab_cell("channels", channels));
  }
  const MatlabReader in(path);
  expect(in.names() == std::vector<std::string>{"H", "channels"}, "names of the variables");
  expect(in.matrix("H") == H, "every bit of the matrix");
  expect(in.cell("channels") == channels, "the texts");

  // MAT-File Format, chapter 1: 124 bytes of text, the version 0x0100, "MI" by its byte order.
  const std::string bytes = read_whole(path);
  expect(bytes.starts_with("written by a consumer"), "the text at its head");
  expect(bytes.substr(124, 4) == std::string("\0\1IM", 4), "version 5, low bytes first");
  expect(fault_of_matlab5(bytes).empty(), "a whole file has no fault");
  expect(!fault_of_matlab5(bytes.substr(0, bytes.size() - 8)).empty(), "a cut one has");
  return differs;
}
