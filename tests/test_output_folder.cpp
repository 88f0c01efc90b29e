// No file of the user's is lost to a folder of results.
#include "io/files/files.hpp"
#include "io/files/output_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace plica {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

OutputWork work(std::vector<std::string> names, std::vector<fs::path> inputs = {}) {
  return {.command = "run", .inputs = std::move(inputs), .names = std::move(names)};
}

// What a command leaves that writes these files; what stays because it was changed.
std::vector<std::string> run_of(const fs::path& folder,
                                const std::map<std::string, std::string>& files) {
  OutputWork own = work({});
  for (const auto& [name, content] : files) own.names.push_back(name);
  OutputFolder out(folder, own);
  for (const auto& [name, content] : files) out.add(name, content);
  out.commit();
  return out.remove_stale();
}

std::string refusal(const fs::path& folder, const OutputWork& of) {
  return test::error_of([&] { const OutputFolder out(folder, of); });
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

TEST(OutputFolder, removes_only_files_of_its_own_list) {
  const TemporaryFolder folder("output_folder");
  write_whole(folder.path / "random_lab.csv", "lab data");
  write_whole(folder.path / "mode_07.obj", "lab data");
  run_of(folder.path, {{"random_y.csv", "1"}, {"mode_01.obj", "1"}, {"results.json", "1"}});
  const auto changed = run_of(folder.path, {{"results.json", "2"}});
  EXPECT_TRUE(changed.empty());
  EXPECT_EQ(names_in(folder.path), (std::set<std::string>{"random_lab.csv", "mode_07.obj",
                                                          "results.json", manifest_name}));
  EXPECT_EQ(read_whole(folder.path / "random_lab.csv"), "lab data");
  EXPECT_EQ(read_whole(folder.path / "results.json"), "2");
}

TEST(OutputFolder, keeps_and_names_what_was_changed_since) {
  const TemporaryFolder folder("output_folder");
  run_of(folder.path, {{"stress.csv", "old"}, {"results.json", "1"}});
  write_whole(folder.path / "stress.csv", "new");
  EXPECT_EQ(run_of(folder.path, {{"results.json", "2"}}), std::vector<std::string>{"stress.csv"});
  EXPECT_EQ(read_whole(folder.path / "stress.csv"), "new");
  write_whole(folder.path / "results.json", "3");
  EXPECT_NE(refusal(folder.path, work({"results.json"})).find("was changed since"),
            std::string::npos);
}

TEST(OutputFolder, leaves_what_another_command_wrote) {
  const TemporaryFolder folder("output_folder");
  run_of(folder.path, {{"report.html", "of the run"}});
  OutputFolder out(folder.path, {.command = "compare", .inputs = {}, .names = {"pairs.csv"}});
  out.add("pairs.csv", "1");
  out.commit();
  EXPECT_TRUE(out.remove_stale().empty());
  EXPECT_EQ(read_whole(folder.path / "report.html"), "of the run");
}

TEST(OutputFolder, refuses_to_write_over_an_input_by_whatever_name) {
  const TemporaryFolder folder("output_folder");
  const fs::path input = folder.path / "data" / "frf.uff";
  write_whole(input, "lab data");
  for (const char* kind : {"itself", "symlink", "hard link"}) {
    const fs::path out = folder.path / kind;
    fs::create_directories(out);
    if (kind == std::string("symlink")) fs::create_symlink(input, out / "frf.uff");
    if (kind == std::string("hard link")) fs::create_hard_link(input, out / "frf.uff");
    const std::string wrong =
        refusal(kind == std::string("itself") ? input.parent_path() : out,
                work({"frf.uff"}, {folder.path / "data" / ".." / "data" / "frf.uff"}));
    EXPECT_NE(wrong.find("is an input of this command"), std::string::npos) << kind << wrong;
  }
  // Also where plica wrote it.
  run_of(folder.path / "own", {{"frf.uff", "1"}});
  EXPECT_NE(refusal(folder.path / "own", work({"frf.uff"}, {folder.path / "own" / "frf.uff"}))
                .find("is an input"),
            std::string::npos);
  EXPECT_EQ(read_whole(input), "lab data");
}

TEST(OutputFolder, refuses_foreign_files_and_links_before_the_work) {
  const TemporaryFolder folder("output_folder");
  write_whole(folder.path / "stress.csv", "lab data");
  fs::create_symlink(folder.path / "nowhere", folder.path / "modes.csv");
  fs::create_directories(folder.path / "report.html");
  for (const char* name : {"stress.csv", "modes.csv", "report.html"}) {
    const std::string wrong = refusal(folder.path, work({name}));
    EXPECT_NE(wrong.find((folder.path / name).string()), std::string::npos) << wrong;
    EXPECT_NE(wrong.find("is no file that plica wrote"), std::string::npos) << wrong;
  }
  fs::create_directory_symlink(folder.path / "report.html", folder.path / "2");
  EXPECT_NE(refusal(folder.path, work({"2/modes.csv"})).find("is no folder"), std::string::npos);
}

TEST(OutputFolder, a_file_that_appears_during_the_work_costs_neither_it_nor_the_results) {
  const TemporaryFolder folder("output_folder");
  OutputFolder out(folder.path, work({"results.json"}));
  out.add("results.json", "of hours");
  write_whole(folder.path / "results.json", "the user's");
  std::string said;
  try {
    out.commit();
  } catch (const InputError& error) {
    said = error.what();
  }
  EXPECT_EQ(read_whole(folder.path / "results.json"), "the user's");
  const std::string kept = said.substr(said.rfind('/') + 1);
  EXPECT_TRUE(kept.starts_with("kept_")) << said;
  EXPECT_EQ(read_whole(folder.path / kept / "results.json"), "of hours");
}

TEST(OutputFolder, follows_no_link_at_a_temporary_name) {
  const TemporaryFolder folder("output_folder");
  write_whole(folder.path / "victim", "untouched");
  const fs::path out = folder.path / "out";
  fs::create_directories(out);
  for (const char* name : {".results.json.part", ".plica_files.json.part"})
    fs::create_symlink(folder.path / "victim", out / name);
  run_of(out, {{"results.json", "1"}});
  write_whole(out / "results.json", "2");
  EXPECT_EQ(read_whole(folder.path / "victim"), "untouched");
  fs::create_symlink(folder.path / "victim", out / ".plica.lock");
  EXPECT_NE(refusal(out, work({})), "no error");
  EXPECT_EQ(read_whole(folder.path / "victim"), "untouched");
}

TEST(OutputFolder, that_went_half_way_is_known_again) {
  const TemporaryFolder folder("output_folder");
  run_of(folder.path, {{"a", "old"}, {"b", "old"}});
  Manifest manifest = read_manifest(folder.path); // as while the new files take their places
  for (auto& [name, file] : manifest) file.prints.push_back(fingerprint("new"));
  write_whole(folder.path / manifest_name, manifest_text(manifest));
  write_whole(folder.path / "a", "new");
  EXPECT_EQ(refusal(folder.path, work({"a", "b"})), "no error");
}

TEST(OutputFolder, a_list_that_was_tampered_with_reaches_no_other_folder) {
  const TemporaryFolder folder("output_folder");
  write_whole(folder.path / "victim", "x");
  const fs::path out = folder.path / "out";
  write_whole(out / manifest_name,
              manifest_text({{"../victim", {"run", {fingerprint("x")}}},
                             {(folder.path / "victim").string(), {"run", {fingerprint("x")}}}}));
  run_of(out, {{"results.json", "1"}});
  EXPECT_TRUE(fs::exists(folder.path / "victim"));
  write_whole(out / manifest_name, "no list");
  EXPECT_NE(refusal(out, work({})).find("is no list of files"), std::string::npos);
}

// A process that has the folder until it is killed; the parent goes on when it has it.
pid_t holder_of(const fs::path& folder) {
  int ready[2];
  EXPECT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    OutputFolder out(folder, work({}));
    out.add("half", "written");
    [[maybe_unused]] const ssize_t said = write(ready[1], "x", 1);
    while (true) pause();
  }
  char byte = 0;
  EXPECT_EQ(read(ready[0], &byte, 1), 1);
  close(ready[0]);
  close(ready[1]);
  return child;
}

TEST(OutputFolder, is_one_command_s_at_a_time_and_free_when_that_was_killed) {
  const TemporaryFolder folder("output_folder");
  const pid_t child = holder_of(folder.path);
  const std::string wrong = refusal(folder.path, work({}));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_NE(wrong.find("process " + std::to_string(child)), std::string::npos) << wrong;
  run_of(folder.path, {{"results.json", "1"}});
  EXPECT_EQ(names_in(folder.path), (std::set<std::string>{"results.json", manifest_name}));
}

// A limit on the size of files stands for a disk that is full.
TEST(OutputFolder, a_full_disk_is_an_error_that_leaves_nothing_half_written) {
  const TemporaryFolder folder("output_folder");
  run_of(folder.path, {{"results.json", "old"}});
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string wrong;
  try {
    run_of(folder.path, {{"results.json", std::string(5000, 'x')}});
  } catch (const InputError& error) {
    wrong = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(wrong.find((folder.path / "results.json").string()), std::string::npos) << wrong;
  EXPECT_EQ(read_whole(folder.path / "results.json"), "old");
  EXPECT_EQ(names_in(folder.path), (std::set<std::string>{"results.json", manifest_name}));
}

TEST(Files, a_pipe_or_a_device_is_refused_and_not_waited_for) {
  const TemporaryFolder folder("files");
  const fs::path pipe = folder.path / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(read_whole(pipe), std::runtime_error);
  EXPECT_THROW(read_whole("/dev/zero"), std::runtime_error);
  EXPECT_THROW(read_whole(folder.path), std::runtime_error);
  EXPECT_EQ(why_unreadable(pipe), "is a pipe");
  EXPECT_EQ(why_unreadable("/dev/zero"), "is a device");
}

} // namespace
} // namespace plica
