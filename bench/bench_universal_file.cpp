// Reading of universal files: a file of time records is made, read whole and removed; MB/s and the
// peak of the resident memory for each form.
//   bench_universal_file [MB of the file, default 200]
#include "io/universal/reader.hpp"
#include "io/universal/writer.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <random>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using namespace plica;
namespace fs = std::filesystem;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the process, so of all forms up to this one.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) * 1024;
}

UniversalFunction sample(UniversalDataType type, bool binary) {
  constexpr Eigen::Index points = 65536;
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  const auto column = [&] {
    return Eigen::VectorXd::NullaryExpr(points, [&] { return noise(random); }).eval();
  };
  UniversalFunction f;
  f.type = FunctionType::time_response;
  f.data_type = type;
  f.dx = 1. / 4096;
  f.real = column();
  if (is_complex(type)) f.imaginary = column();
  if (binary) f.binary = UniversalBinaryForm{};
  return f;
}

void measure(const char* name, const UniversalFunction& f, double bytes) {
  const fs::path path =
      fs::temp_directory_path() / ("plica_bench_" + std::to_string(getpid()) + ".uff");
  const std::string set = universal_text(f);
  {
    std::ofstream out(path, std::ios::binary);
    for (double written = 0; written < bytes; written += double(set.size())) out << set;
  }
  const double size = double(fs::file_size(path));
  const auto start = std::chrono::steady_clock::now();
  UniversalReader reader(path);
  int sets = 0;
  double sum = 0;
  while (const std::optional<UniversalDataset> read = reader.next()) {
    ++sets;
    sum += std::get<UniversalFunction>(*read).real.sum();
  }
  const double seconds = seconds_since(start);
  fs::remove(path);
  fmt::print("{:<22} {:>8.0f} {:>6} {:>8.0f} {:>8.1f}   {:.6e}\n", name, size / 1e6, sets,
             size / 1e6 / seconds, peak_memory() / 1e6, sum);
}

} // namespace

int main(int argc, char** argv) {
  const double bytes = 1e6 * (argc > 1 ? std::atof(argv[1]) : 200);
  fmt::print("{:<22} {:>8} {:>6} {:>8} {:>8}   {}\n", "form", "MB", "sets", "MB/s", "peak MB",
             "sum");
  measure("ASCII single E13.5", sample(UniversalDataType::real_single, false), bytes);
  measure("ASCII double E20.12", sample(UniversalDataType::complex_double, false), bytes);
  measure("binary double", sample(UniversalDataType::complex_double, true), bytes);
}
