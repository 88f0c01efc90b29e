// What Plica wrote into a folder: the file plica_files.json there. A command replaces or removes
// only what stands in it, and only while it is as it was written.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace plica {

constexpr const char* manifest_name = "plica_files.json";

struct WrittenFile {
  std::string command;             // that wrote it
  std::vector<std::string> prints; // fingerprints; two while a new file takes the place of an old
  std::string version = {};        // of the program that wrote it
};

using Manifest = std::map<std::string, WrittenFile>; // by the name below the folder

// Size and a 64-bit FNV-1a hash: tells a file that was changed, not one that was forged.
std::string fingerprint(const std::string& content);

// Of a regular file, links not followed; empty when it is none or cannot be read.
std::string fingerprint_of(const std::filesystem::path& file);

// Of a folder without one it is empty. InputError when it is damaged.
Manifest read_manifest(const std::filesystem::path& folder);

std::string manifest_text(const Manifest& manifest);

} // namespace plica
