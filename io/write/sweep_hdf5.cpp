#include "io/superelements/hdf5_text.hpp"
#include "io/write/write_sweep.hpp"
#include "run/results/computed_numbers.hpp"

#include <H5Cpp.h>

#include <limits>

namespace plica {
namespace {

// One that grows with its rows is packed: most columns of a grid repeat.
H5::DSetCreatPropList packed(hsize_t rows) {
  H5::DSetCreatPropList list;
  const hsize_t chunk = std::max<hsize_t>(1, std::min<hsize_t>(rows, 65536));
  list.setChunk(1, &chunk);
  list.setShuffle();
  list.setDeflate(4);
  return list;
}

H5::DataSet put(H5::H5File& file, const std::string& name, const std::vector<double>& numbers) {
  const hsize_t rows = numbers.size();
  H5::DataSet set =
      file.createDataSet(name, H5::PredType::IEEE_F64LE, H5::DataSpace(1, &rows), packed(rows));
  set.write(numbers.data(), H5::PredType::NATIVE_DOUBLE);
  return set;
}

H5::DataSet put(H5::H5File& file, const std::string& name, const std::vector<std::string>& texts) {
  const hsize_t rows = texts.size();
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  H5::DataSet set = file.createDataSet(name, type, H5::DataSpace(1, &rows), packed(rows));
  set.write(pointers.data(), type);
  return set;
}

} // namespace

void write_sweep_hdf5(const SweepTable& table, const std::filesystem::path& path) {
  H5::Exception::dontPrint();
  try {
    H5::H5File file(path.string(), H5F_ACC_TRUNC);
    set_text(file, "format", "plica sweep");
    set_text(file, "case", table.case_name);
    std::vector<double> numbers(table.rows.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = double(i + 1);
    put(file, "variant", numbers);
    for (const SweptColumn& column : table.plan.columns) {
      const std::string& name = column.paths.front();
      H5::DataSet set =
          column.numbers.empty() ? put(file, name, column.texts) : put(file, name, column.numbers);
      set_text(set, "unit", column.unit);
      std::string paths;
      for (const std::string& p : column.paths) paths += (paths.empty() ? "" : ",") + p;
      set_text(set, "paths", paths);
    }
    for (const std::string& result : results_of(table)) {
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = std::numeric_limits<double>::quiet_NaN();
        if (table.rows[i])
          for (const auto& [name, value] : table.rows[i]->values)
            if (name == result) numbers[i] = value;
      }
      H5::DataSet set = put(file, result, numbers);
      set_text(set, "unit", unit_of_result(result));
    }
    std::vector<std::string> status, reason;
    for (const auto& row : table.rows) {
      status.emplace_back(!row ? "missing" : row->failure.empty() ? "ok" : "failed");
      reason.push_back(row ? row->failure : "not run yet");
    }
    put(file, "status", status);
    put(file, "reason", reason);
  } catch (const H5::Exception& error) {
    throw std::runtime_error("HDF5: " + error.getDetailMsg());
  }
}

} // namespace plica
