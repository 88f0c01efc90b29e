#include "io/write_results.hpp"

#include "io/report.hpp"
#include "io/results_csv.hpp"
#include "io/results_json.hpp"
#include "io/results_text.hpp"
#include "io/results_vtu.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace plica {
namespace {

namespace fs = std::filesystem;

struct OutputFile {
  fs::path target, temporary;
  std::string content;
};

[[noreturn]] void fail(const std::string& what, const fs::path& path, const std::string& why) {
  throw std::runtime_error("cannot " + what + " " + path.string() + ": " + why);
}

} // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail("make the folder for the results,", folder, error.message());
  if (!fs::is_directory(folder, error)) {
    fail("write the results into", folder, "it is a file, not a folder");
  }
}

namespace {

// Files that some runs write and others do not.
bool is_optional_output(const std::string& name) {
  const auto named = [&](const char* prefix) {
    return name.starts_with(prefix) && name.ends_with(".csv");
  };
  return named("response_") || named("motion_") || named("random_") || name == "stress.csv" ||
         name == "stress.vtu" || name == "error_bars.csv";
}

void remove_stale(const fs::path& folder, const std::vector<OutputFile>& written) {
  std::vector<fs::path> stale;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (is_optional_output(entry.path().filename().string()) &&
        std::none_of(written.begin(), written.end(),
                     [&](const OutputFile& f) { return f.target == entry.path(); }))
      stale.push_back(entry.path());
  std::error_code ignored;
  for (const fs::path& path : stale) fs::remove(path, ignored);
}

void write_temporary(const OutputFile& file) {
  errno = 0;
  std::ofstream stream(file.temporary, std::ios::binary | std::ios::trunc);
  if (stream) stream.write(file.content.data(), static_cast<std::streamsize>(file.content.size()));
  stream.close();
  if (!stream) {
    fail("write", file.target, errno != 0 ? std::strerror(errno) : "the disk may be full");
  }
}

void move_into_place(const OutputFile& file) {
  std::error_code error;
  fs::rename(file.temporary, file.target, error);
  if (error) fail("write", file.target, error.message());
}

std::vector<OutputFile> output_files(const Results& results, const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> contents{
      {"modes.csv", modes_csv(results)},           {"static.csv", static_csv(results)},
      {"comparison.csv", comparison_csv(results)}, {"variants.csv", variants_csv(results)},
      {"modes.vtu", modes_vtu(results)},           {"report.html", report_html(results)},
      {"results.json", results_json(results)}};
  for (const ResponseResult& r : results.responses) {
    contents.emplace_back("response_" + response_name(r) + ".csv", response_csv(r));
    contents.emplace_back("motion_" + response_name(r) + ".csv", motion_csv(r));
    if (r.random) contents.emplace_back("random_" + response_name(r) + ".csv", random_csv(r));
  }
  if (!results.stresses.empty()) {
    contents.emplace_back("stress.csv", stress_csv(results));
    contents.emplace_back("stress.vtu", stress_vtu(results));
  }
  if (!results.error_bars.bars.empty())
    contents.emplace_back("error_bars.csv", error_bars_csv(results));
  std::vector<OutputFile> files;
  files.reserve(contents.size());
  for (auto& [name, content] : contents) {
    files.push_back({folder / name, folder / ("." + name + ".part"), std::move(content)});
  }
  return files;
}

} // namespace

void write_results(const Results& results, const fs::path& out_dir) {
  make_folder(out_dir);
  const std::vector<OutputFile> files = output_files(results, out_dir);
  try {
    for (const OutputFile& file : files) {
      if (fs::is_directory(file.target)) fail("write", file.target, "a folder has this name");
      write_temporary(file);
    }
    for (const OutputFile& file : files) move_into_place(file);
    remove_stale(out_dir, files);
  } catch (...) {
    std::error_code ignored;
    for (const OutputFile& file : files) fs::remove(file.temporary, ignored);
    throw;
  }
}

} // namespace plica
