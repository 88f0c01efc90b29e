// What a machine grants and what a run needs, known beforehand.
#include "tests/support/fields.hpp"
#include "tests/support/temporary_folder.hpp"

#include "mesh/generation/revolve.hpp"
#include "mesh/machine_memory.hpp"
#include "mesh/plate.hpp"
#include "run/routes/memory_need.hpp"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

namespace plica::test {
namespace {

namespace fs = std::filesystem;

class MachineMemory : public testing::Test {
protected:
  void SetUp() override {
    unsetenv("PLICA_MEMORY");
    write("proc/meminfo", "MemFree:  1 kB\nMemTotal:       8000000 kB\n");
  }
  void TearDown() override { unsetenv("PLICA_MEMORY"); }
  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  double limit() const { return memory_limit(root_).bytes; }

  const TemporaryFolder folder_{"machine"};
  const fs::path& root_ = folder_.path;
};

TEST_F(MachineMemory, is_what_is_installed) {
  EXPECT_EQ(limit(), 8000000. * 1024);
  EXPECT_EQ(memory_limit(root_).set_by, "the memory of this machine");
}

TEST_F(MachineMemory, is_the_least_that_any_control_group_above_grants) {
  write("proc/self/cgroup", "0::/batch/job_7/step\n");
  write("sys/fs/cgroup/batch/job_7/step/memory.max", "max\n");
  write("sys/fs/cgroup/batch/job_7/memory.max", "2000000000\n");
  write("sys/fs/cgroup/batch/memory.max", "3000000000\n");
  EXPECT_EQ(limit(), 2e9);
  EXPECT_EQ(memory_limit(root_).set_by, "the limit of its control group");
  // Within a container the group's own path is not seen; its limit stands at the top.
  write("proc/self/cgroup", "0::/docker/4711\n");
  write("sys/fs/cgroup/memory.max", "1500000000\n");
  EXPECT_EQ(limit(), 1.5e9);
}

TEST_F(MachineMemory, is_found_in_the_first_version_of_control_groups) {
  write("proc/self/cgroup", "5:cpu,cpuacct:/job\n4:memory:/job\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n"); // none
  EXPECT_EQ(limit(), 8000000. * 1024);
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "700000000\n");
  EXPECT_EQ(limit(), 7e8);
}

TEST_F(MachineMemory, is_what_the_user_says) {
  setenv("PLICA_MEMORY", "12.5", 1);
  EXPECT_EQ(limit(), 12.5e9);
  for (const char* wrong : {"", "much", "-1", "0", "4 GB", "nan", "inf"}) {
    setenv("PLICA_MEMORY", wrong, 1);
    EXPECT_THROW(memory_limit(root_), std::runtime_error) << wrong;
  }
}

TEST_F(MachineMemory, unknown_asks_for_the_users_word) {
  fs::remove_all(root_ / "proc");
  EXPECT_THROW(memory_limit(root_), std::runtime_error);
}

TEST_F(MachineMemory, that_a_mesh_outgrows_is_said_before_it_is_made) {
  setenv("PLICA_MEMORY", "1", 1);
  Meridian meridian(0, 0.1);
  meridian.add_cuff(1, 0.1, 1000);
  try {
    revolve(meridian, 4000, [](double) { return 1e-3; });
    FAIL() << "four million nodes in a gigabyte";
  } catch (const TooLarge& error) {
    EXPECT_STREQ(error.what(),
                 "a mesh of 1001 rings of 4000 nodes needs about 9.6 GB; PLICA_MEMORY is 1 GB. "
                 "A coarser mesh needs less. PLICA_MEMORY sets the limit by hand, in GB.");
  }
  const std::array<Eigen::Vector3d, 4> corners{
      Eigen::Vector3d{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_THROW(mesh_plate(corners, 1000, 1000, 1e-3), TooLarge);
}

// Peak memory of runs of bench/a2_peer.yaml, as bench/memory.mjs printed it (docs/speed.md).
TEST_F(MachineMemory, that_a_run_takes_is_foretold) {
  struct Measured {
    double unknowns, bytes;
    int modes;
  };
  for (const auto& [unknowns, bytes, modes] : {Measured{62652, 0.49e9, 10},
                                               {125292, 0.94e9, 10},
                                               {250572, 1.94e9, 10},
                                               {375852, 3.02e9, 10},
                                               {125292, 0.99e9, 30},
                                               {125292, 1.13e9, 60},
                                               {125292, 1.37e9, 100}})
    EXPECT_NEAR(memory_of_full_mesh(unknowns, modes), bytes, 0.12 * bytes) << unknowns << modes;
  for (const auto& [unknowns, bytes, modes] : {Measured{125292, 0.21e9, 10},
                                               {998796, 0.77e9, 10},
                                               {2080812, 1.43e9, 10},
                                               {5202012, 3.30e9, 10},
                                               {998796, 1.46e9, 40},
                                               {998796, 2.91e9, 100}})
    EXPECT_NEAR(memory_by_symmetry(unknowns, modes), bytes, 0.12 * bytes) << unknowns << modes;
}

} // namespace
} // namespace plica::test
