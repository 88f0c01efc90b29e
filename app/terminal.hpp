// What the program says: results on standard output, all else on standard error.
//
// Control characters of names and titles (a case file may hold any) are shown, not sent:
// "\x1b[2J". Standard error that cannot be written, as of a terminal that is gone, stops nothing.
#pragma once

#include "io/files/manifest.hpp"
#include "words/input_error.hpp"

#include <string>
#include <string_view>

namespace plica {

// Before anything is opened: standard streams that are closed are given to the null device, so
// that no file of results takes their place, and a reader that has gone is no reason to die.
void open_standard_streams();

// From here on what is said on standard error is one JSON object a line, by its `kind`: progress
// {title, stage, seconds, share, left}, warning {text}, error {file, line, key, wrong, allowed},
// written {command, files: {name: {command, fingerprint}}} (all that Plica has in the folder then),
// failure {text}, note {text}.
void speak_json();
bool speaks_json();

void say(std::string_view text); // a note, on standard error
void say_warning(std::string_view text);
void say_failure(std::string_view text); // why there is no result, or why it is not to be trusted
void say_problems(const InputError& error);
void say_progress(const std::string& title, const std::string& stage, double seconds, double share);
void say_written(const std::string& command, const Manifest& files); // as JSON alone
void say_raw(std::string_view text); // the same, with control characters of our own
void print(std::string_view text);   // standard output

// The exit code, 1 in place of 0 when what was printed did not arrive; says so.
int finished(int exit_code);

// Line breaks and tabs stay; other control characters, and bytes that are no UTF-8, as "\x1b".
std::string printable(std::string_view text);

} // namespace plica
