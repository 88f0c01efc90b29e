// A folder of results: what was written is known again, what somebody changed stays.
#include "plica/io/files/files.hpp"
#include "expect.hpp"
#include "plica/io/files/fnv.hpp"
#include "plica/io/files/json_text.hpp"
#include "plica/io/files/output_folder.hpp"

int main() {
  using namespace plica;
  const std::filesystem::path folder = "consumer_files";
  std::filesystem::remove_all(folder);
  const auto write = [&](const std::vector<std::string>& names) {
    OutputFolder out(folder, {.command = "run", .inputs = {}, .names = names});
    for (const std::string& name : names) out.add(name, json_text({{"f", json_number(NAN)}}));
    out.commit();
    return out.remove_stale();
  };
  expect(write({"a.json", "b.json", "c.json"}).empty(), "a new folder has nothing stale");
  expect(read_whole(folder / "a.json") == "{\n  \"f\": null\n}\n", "a number that is none is null");
  expect(read_manifest(folder).size() == 3, "three files in the manifest");

  write_whole(folder / "c.json", "by hand");
  expect(write({"a.json"}) == std::vector<std::string>{"c.json"}, "the changed file is named");
  expect(!std::filesystem::exists(folder / "b.json"), "what is stale goes");
  expect(read_whole(folder / "c.json") == "by hand", "what was changed stays");

  Fnv1a hash;
  hash.add("foobar", 6);
  expect(hash.hash() == 0x85944171f73967e8U, "the published hash of foobar");
  return differs;
}
