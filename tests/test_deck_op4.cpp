// Matrices of OP4 files: every form they have, as parts of decks with their rows by ASET or by the
// numbers of the points, as external superelements; damaged ones.
#include "io/decks/op4_file.hpp"
#include "io/decks/read_deck.hpp"
#include "io/files/files.hpp"
#include "io/superelements/nastran_dmig.hpp"
#include "io/superelements/op4.hpp"
#include "tests/deck_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <numbers>
#include <random>

namespace plica::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

struct Op4Form {
  bool binary = false, swapped = false, sparse = false, big = false, in_double = true;
  int word = 4;
};

// One matrix as OUTPUT4 writes it.
class Op4Text {
public:
  Op4Text(const std::string& name, const MatrixXd& A, const Op4Form& form) : form_(form) {
    const long rows = form.big ? -A.rows() : A.rows();
    const int type = form.in_double ? 2 : 1;
    if (form.binary) {
      for (const long v : {long(A.cols()), rows, 6L, long(type)}) whole(v);
      record_ += fmt::format("{:<{}}", name, 2 * form.word);
      end_record();
    } else {
      text += fmt::format("{:8}{:8}{:8}{:8}{:<8}1P,3E24.16\n", A.cols(), rows, 6, type, name);
    }
    for (Index j = 0; j < A.cols(); ++j) column(j, A.col(j));
    head(A.cols() + 1, 1, 1);
    numbers({1.});
    end_record();
  }
  std::string text;

private:
  void column(Index j, const Eigen::VectorXd& x) {
    std::vector<std::pair<Index, std::vector<double>>> strings; // of what is not zero
    for (Index i = 0; i < x.size(); ++i) {
      if (x[i] == 0 && (form_.sparse || strings.empty())) continue;
      const bool goes_on =
          !strings.empty() && strings.back().first + Index(strings.back().second.size()) == i;
      if (!goes_on) strings.push_back({i, {}});
      strings.back().second.push_back(x[i]);
    }
    if (strings.empty()) return;
    const Index per = form_.in_double && !(form_.binary && form_.word == 8) ? 2 : 1;
    if (!form_.sparse) {
      const auto& [first, values] = strings.front();
      head(j + 1, first + 1, Index(values.size()) * (form_.binary ? per : 1));
      numbers(values);
      return end_record();
    }
    Index words = 0;
    for (const auto& s : strings) words += Index(s.second.size()) * per + (form_.big ? 2 : 1);
    head(j + 1, 0, words);
    for (const auto& [first, values] : strings) {
      const Index length = Index(values.size()) * per + 1;
      if (form_.big && form_.binary) {
        whole(length);
        whole(first + 1);
      } else if (form_.big) {
        text += fmt::format("{:8}{:8}\n", length, first + 1);
      } else if (form_.binary) {
        whole(first + 1 + 65536 * length);
      } else {
        text += fmt::format("{:12}\n", first + 1 + 65536 * length);
      }
      numbers(values);
    }
    end_record();
  }

  void head(Index column, Index row, Index words) {
    if (!form_.binary) text += fmt::format("{:8}{:8}{:8}\n", column, row, words);
    for (const Index v : {column, row, words})
      if (form_.binary) whole(v);
  }
  void numbers(const std::vector<double>& values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (form_.binary && (form_.in_double || form_.word == 8))
        bytes(values[k]);
      else if (form_.binary)
        bytes(float(values[k]));
      else
        text +=
            fmt::format("{:24.16E}{}", values[k], k % 3 == 2 || k + 1 == values.size() ? "\n" : "");
    }
  }
  template <class T> void bytes(T value) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
    if (form_.swapped) std::reverse(raw.begin(), raw.end());
    record_ += raw;
  }
  void whole(long value) {
    if (form_.word == 8)
      bytes(std::int64_t(value));
    else
      bytes(std::int32_t(value));
  }
  void end_record() {
    if (!form_.binary) return;
    const std::string body = std::move(record_);
    record_.clear();
    bytes(std::int32_t(body.size()));
    const std::string mark = std::move(record_);
    record_.clear();
    text += mark + body + mark;
  }

  Op4Form form_;
  std::string record_;
};

MatrixXd op4_sample() {
  MatrixXd A = MatrixXd::Zero(5, 5);
  A << 3, -1.25, 0, 0.5, 0, -1.25, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0.5, 0, 0, 4, -1, 0, 0, 0, -1, 0.0625;
  return A;
}

std::vector<Op4Form> op4_forms() {
  std::vector<Op4Form> all;
  for (const bool sparse : {false, true})
    for (const bool big : {false, true})
      for (const bool in_double : {false, true}) {
        all.push_back({.sparse = sparse, .big = big, .in_double = in_double});
        for (const bool swapped : {false, true})
          for (const int word : {4, 8})
            all.push_back({true, swapped, sparse, big, in_double, word});
      }
  return all;
}

TEST(Op4, is_read_in_every_form) {
  const TemporaryFolder folder("op4");
  const MatrixXd A = op4_sample();
  for (const Op4Form& form : op4_forms()) {
    const std::string text = Op4Text("OTHER", MatrixXd::Ones(2, 3), form).text +
                             Op4Text("kxx", A, form).text + Op4Text("MXX", 2 * A, form).text;
    write_whole(folder.path / "a.op4", text);
    const auto all = read_op4_file(folder.path / "a.op4", {"KXX", "MXX", "NONE"});
    ASSERT_EQ(all.size(), 2U) << form.binary << form.sparse << form.big << form.word;
    EXPECT_EQ(all.at("KXX"), A) << form.binary << form.sparse << form.big << form.word;
    EXPECT_EQ(all.at("MXX"), 2 * A);
  }
}

TEST(Op4, that_is_damaged_is_read_or_refused) {
  const TemporaryFolder folder("op4");
  std::mt19937 random(11);
  int refused = 0;
  const std::vector<Op4Form> forms = op4_forms();
  for (int i = 0; i < 4000; ++i) {
    std::string text = Op4Text("KXX", op4_sample(), forms[random() % forms.size()]).text;
    for (int k = 0; k < 2; ++k) text[random() % text.size()] = char(random() % 256);
    if (i % 4 == 0) text.resize(random() % text.size());
    write_whole(folder.path / "a.op4", text);
    try {
      for (const auto& [name, A] : read_op4_file(folder.path / "a.op4", {"KXX"}))
        EXPECT_TRUE(A.allFinite());
    } catch (const InputError& error) {
      ++refused;
      EXPECT_FALSE(error.problems()[0].file.empty());
    }
  }
  EXPECT_GT(refused, 1000);
}

std::shared_ptr<const DeckModel> op4_deck(const TemporaryFolder& folder, const std::string& text) {
  write_whole(folder.path / "a.bdf", text);
  return read_deck(folder.path / "a.bdf", UnknownCards::error);
}

// All 16 digits: the DMIG of the same names, beside it, have ten.
TEST(Op4, of_ours_comes_back_by_the_points_of_its_deck) {
  const TemporaryFolder folder("op4");
  Superelement s;
  s.name = "any";
  s.node_names = {"left", "right"};
  s.nodes = {{0, 0, 0}, {0.3, 0.1, 0}};
  std::srand(5);
  const MatrixXd A = MatrixXd::Random(13, 13), B = MatrixXd::Random(13, 13);
  s.K = A * A.transpose();
  s.M = B * B.transpose();
  write_whole(folder.path / "part.bdf", nastran_deck(s, {}));
  write_whole(folder.path / "part.op4", op4_file(s));
  const auto deck = op4_deck(folder, "ASSIGN INPUTT4='part.op4', UNIT=20\nCEND\nK2GG = KPLICA\n"
                                     "M2GG = MPLICA\nBEGIN BULK\nINCLUDE 'part.bdf'\nENDDATA\n");
  ASSERT_EQ(deck->springs.size(), 2U);
  EXPECT_LT((deck->springs[0].K.topLeftCorner(13, 13) - s.K).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((deck->springs[1].M.topLeftCorner(13, 13) - s.M).cwiseAbs().maxCoeff(), 1e-14);
}

// Masses of 2 and 1 on springs of 2000 and 1000 in a row: eigenvalues 500 and 2000.
std::string op4_chain() {
  MatrixXd K(2, 2), M = MatrixXd::Zero(2, 2);
  K << 3000, -1000, -1000, 1000;
  M.diagonal() << 2, 1;
  return Op4Text("KXX", K, {.binary = true}).text + Op4Text("MXX", M, {.binary = true}).text;
}

const std::string op4_grids = "GRID,20,,0.,0.,0.\nGRID,10,,1.,0.,0.\n";
const std::string op4_external = "ASSIGN INPUTT4='part.op4',\n  UNIT=31\nCEND\nBEGIN BULK\n" +
                                 op4_grids +
                                 "SEBULK,9,EXTOP4,,MANUAL,,,31\nSECONCT,9,0,,NO\n"
                                 ",3,20,5,10\n";

void expect_chain(const DeckModel& deck) {
  const Eigen::VectorXd hertz = find_modes(place(deck, {}), 2).hertz;
  ASSERT_EQ(hertz.size(), 2);
  EXPECT_NEAR(hertz[0] * 2 * std::numbers::pi, std::sqrt(500.), 1e-8);
  EXPECT_NEAR(hertz[1] * 2 * std::numbers::pi, std::sqrt(2000.), 1e-8);
}

TEST(Op4, has_the_rows_of_the_analysis_set) {
  const TemporaryFolder folder("op4");
  write_whole(folder.path / "part.op4", op4_chain());
  const std::string head =
      "ASSIGN INPUTT4=\"part.op4\"\nCEND\nK2GG=KXX\nM2GG=MXX\nBEGIN BULK\n" + op4_grids;
  for (const char* rows : {"ASET1,2,10,20\n", "ASET,20,2\nQSET,10,2\n"}) {
    const auto deck = op4_deck(folder, head + rows);
    expect_chain(*deck);
    for (const MatrixElement& e : deck->springs) // the first row is that of point 10
      if (e.M.norm() > 0) {
        const auto ten = std::find(e.nodes.begin(), e.nodes.end(), 1) - e.nodes.begin();
        EXPECT_EQ(e.M(6 * ten + 1, 6 * ten + 1), 2);
      }
  }
}

TEST(Op4, is_the_matrix_of_an_external_superelement) {
  const TemporaryFolder folder("op4");
  write_whole(folder.path / "part.op4", op4_chain());
  const auto deck = op4_deck(folder, op4_external + "BEGIN SUPER=9\nEXTRN,3,1,5,1\n"
                                                    "GRID,3,,0.,0.,0.\nASET1,1,3,5\nENDDATA\n");
  expect_chain(*deck);
  std::string chosen = op4_external;
  chosen.insert(chosen.find("BEGIN BULK"), "MPC = 701\n"); // of a superelement
  expect_chain(*op4_deck(folder, chosen + "MPC,702,20,2,1.,10,2,-1.\nBEGIN SUPER=9\n"
                                          "EXTRN,3,1,5,1\nENDDATA\n"));
  for (const MatrixElement& e : deck->springs) // point 3 of it is point 20 of the deck
    if (e.M.norm() > 0) {
      EXPECT_EQ(e.M(0, 0), 2);
    }
  EXPECT_TRUE(deck->files.contains((folder.path / "part.op4").string()));
}

TEST(Op4, that_does_not_fit_is_refused) {
  const TemporaryFolder folder("op4");
  write_whole(folder.path / "part.op4", op4_chain());
  std::string complex = Op4Text("KXX", op4_sample(), {}).text;
  complex.replace(24, 8, "       4");
  write_whole(folder.path / "complex.op4", complex);
  write_whole(folder.path / "twice.op4", op4_chain() + op4_chain());
  write_whole(folder.path / "cut.op4", op4_chain().substr(0, 90));
  const auto named = [](const std::string& file) {
    return "ASSIGN INPUTT4='" + file + "'\nCEND\nK2GG=KXX\nBEGIN BULK\n" + op4_grids;
  };
  const std::vector<std::pair<std::string, const char*>> all{
      {named("part.op4"), "has 2 rows and 2 columns, the points of the deck have 12;"},
      {named("part.op4") + "ASET1,123,10,20\n", "have 12, those of ASET and its like 6"},
      {named("none.op4"), "none.op4: OP4"},
      {named("complex.op4"), "is complex"},
      {named("twice.op4"), "OP4 KXX: is there twice"},
      {named("cut.op4"), "ends within a matrix"},
      {"CEND\nK2GG=KXX\nBEGIN BULK\n" + op4_grids, "there is no matrix KXX"},
      {op4_external, "SEBULK: has no EXTRN"},
      {op4_external + "BEGIN SUPER=9\nEXTRN,3,123,5,1\n", "EXTRN of superelement 9 names 4"},
      {op4_external + "BEGIN SUPER=9\nEXTRN,3,1,6,1\n", "there is no grid point 6"},
      {op4_external + "BEGIN SUPER=8\nEXTRN,3,1,5,1\n", "BEGIN: is not had"}};
  for (const auto& [text, message] : all) {
    try {
      op4_deck(folder, text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
  }
}

} // namespace
} // namespace plica::test
