// Functions in MATLAB files as Simcenter Testlab exports them.
#include "io/lab_files/measured_data.hpp"
#include "io/matlab/matlab_file.hpp"
#include "tests/matlab_response.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <complex>

namespace plica::test {
namespace {

// A structure with these fields, which it takes over.
MatlabVariable testlab_structure(const char* name,
                                 std::vector<std::pair<const char*, MatlabVariable>> fields) {
  std::vector<const char*> names;
  for (const auto& field : fields) names.push_back(field.first);
  std::array<std::size_t, 2> one{1, 1};
  MatlabVariable made(
      Mat_VarCreateStruct(name, 2, one.data(), names.data(), unsigned(names.size())));
  for (auto& [field, value] : fields)
    Mat_VarSetStructFieldByName(made.get(), field, 0, value.release());
  return made;
}
MatlabVariable testlab_number(double x) {
  return matlab_matrix(nullptr, Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, x)));
}

// As Simcenter Testlab exports a function: no frequencies, but where they begin and how they grow;
// numbers in SI, with the factor that makes those in the unit of the label.
MatlabVariable testlab_function(const char* name, double values_stated, const char* label,
                                std::optional<double> factor, double start = 10) {
  std::vector<std::pair<const char*, MatlabVariable>> x, y, quantity_x, quantity_y, to_label, frf;
  quantity_x.emplace_back("label", matlab_text(nullptr, "Hz"));
  quantity_y.emplace_back("label", matlab_text(nullptr, label));
  if (factor) {
    to_label.emplace_back("offset", testlab_number(0));
    to_label.emplace_back("factor", testlab_number(*factor));
    quantity_y.emplace_back("unit_transformation", testlab_structure(nullptr, std::move(to_label)));
  }
  x.emplace_back("start_value", testlab_number(start));
  x.emplace_back("increment", testlab_number(1));
  x.emplace_back("number_of_values", testlab_number(values_stated));
  x.emplace_back("quantity", testlab_structure(nullptr, std::move(quantity_x)));
  y.emplace_back(
      "values", matlab_matrix(nullptr, Eigen::MatrixXcd(Eigen::Vector3cd({1, 0}, {2, 1}, {3, 0}))));
  y.emplace_back("quantity", testlab_structure(nullptr, std::move(quantity_y)));
  frf.emplace_back("x_values", testlab_structure(nullptr, std::move(x)));
  frf.emplace_back("y_values", testlab_structure(nullptr, std::move(y)));
  return testlab_structure(name, std::move(frf));
}

void expect_testlab_SI(const FrfSet& set, double factor) {
  EXPECT_NEAR(set.H[0](1, 0).real(), 2 * factor, 1e-12 * factor);
  EXPECT_NEAR(set.H[0](1, 0).imag(), factor, 1e-12 * factor);
}

class TestlabFiles : public testing::Test {
protected:
  TemporaryFolder folder_{"testlab"};
  void save(std::vector<MatlabVariable> variables) {
    MatlabWriter mat(folder_.path / "h.mat", "MATLAB 5.0 MAT-file");
    for (const MatlabVariable& v : variables) mat.put(v);
  }
  void save(MatlabVariable variable) {
    std::vector<MatlabVariable> one;
    one.push_back(std::move(variable));
    save(std::move(one));
  }
  std::string refusal_of(const Measured& m) {
    return error_of([&] { load_frfs(m, folder_.path); });
  }
};

TEST_F(TestlabFiles, say_where_the_abscissa_begins_and_how_it_grows) {
  const Measured m = test_by_force({.abscissa = "FRF.x_values", .values = "FRF.y_values.values"});
  save(testlab_function("FRF", 3, "g/N", {}));
  const FrfSet set = load_frfs(m, folder_.path).at(0);
  expect_testlab_SI(set, 9.80665);
  EXPECT_EQ(set.hertz, Eigen::VectorXd(Eigen::Vector3d(10, 11, 12)));
  save(testlab_function("FRF", 4, "g/N", {}));
  EXPECT_NE(refusal_of(m).find("states 4 values"), std::string::npos) << refusal_of(m);
}

TEST_F(TestlabFiles, hold_SI_whatever_their_label_says) {
  for (const MatlabVariables& named :
       {MatlabVariables{},
        MatlabVariables{.abscissa = "", .values = "FRF"},
        {.abscissa = "FRF.x_values", .values = "FRF.y_values.values"}}) {
    save(testlab_function("FRF", 3, "g/N", 0.101971621297793));
    expect_testlab_SI(load_frfs(test_by_force(named), folder_.path).at(0), 1);
    save(testlab_function("FRF", 3, "mm/N", 1000));
    const FrfSet set = load_frfs(test_by_force(named), folder_.path).at(0);
    expect_testlab_SI(set, 1);
    EXPECT_EQ(set.quantity, FrfQuantity::receptance);
  }
  Measured ratio = test_by_force({}); // "/" is the label of a transmissibility
  ratio.frf[0].force.clear();
  ratio.frf[0].base = Axis::y;
  save(testlab_function("FRF", 3, "/", 1));
  EXPECT_EQ(load_frfs(ratio, folder_.path).at(0).quantity, FrfQuantity::transmissibility);
  save(testlab_function("FRF", 3, "g/N", -1));
  EXPECT_NE(refusal_of(test_by_force({})).find("unit_transformation.factor is no factor"),
            std::string::npos);
}

TEST_F(TestlabFiles, are_read_whole_where_no_function_is_named) {
  Measured m = test_by_force({});
  m.frf[0].channels = {"a.z", "b.z"};
  const auto two = [&](double start) {
    std::vector<MatlabVariable> both;
    both.push_back(testlab_function("FRF_1", 3, "g/N", 0.101971621297793));
    both.push_back(testlab_function("FRF_2", 3, "g/N", 0.101971621297793, start));
    save(std::move(both));
  };
  two(10);
  const FrfSet set = load_frfs(m, folder_.path).at(0);
  ASSERT_EQ(set.H[0].cols(), 2);
  EXPECT_EQ(set.H[0].col(0), set.H[0].col(1));
  two(11);
  EXPECT_NE(refusal_of(m).find("FRF_2.y_values.values has another abscissa"), std::string::npos)
      << refusal_of(m);
}

} // namespace
} // namespace plica::test
