// Files that are read and written whole, or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace plica {

// Makes the folder; InputError with path and reason when that cannot be.
void make_folder(const std::filesystem::path& folder);

// Writes a file that is not there yet: a name that is taken, by a link too, is an error. InputError
// with the reason names `shown`, the file as the user knows it; nothing half-written is left.
void write_new(const std::filesystem::path& file, const std::string& content,
               const std::filesystem::path& shown);

// Writes into a temporary file beside the target and renames it. InputError with path and reason.
void write_whole(const std::filesystem::path& target, const std::string& content);

// Text of a file; std::runtime_error when it cannot be read, and for what is no file: a pipe would
// be waited for, a device may never end.
std::string read_whole(const std::filesystem::path& path);

// Why a file cannot be read ("is a pipe"); empty when it can.
std::string why_unreadable(const std::filesystem::path& path);

} // namespace plica
