#include "app/terminal.hpp"

#include "io/files/json_text.hpp"
#include "words/short_text.hpp"
#include "words/utf8.hpp"

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <iostream>
#include <unistd.h>

namespace plica {
namespace {

bool json_lines = false;
int why_not_printed = 0; // errno of the first failure on standard output

void write_to(int handle, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(handle, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      if (handle == STDOUT_FILENO && why_not_printed == 0) why_not_printed = n < 0 ? errno : EIO;
      return;
    }
    text.remove_prefix(std::size_t(n));
  }
}

// C0 and C1 controls, and what turns the direction of writing.
bool is_control(std::string_view letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 1)
    return (byte(0) < 0x20 && letter != "\n" && letter != "\t") || byte(0) == 0x7F;
  if (letter.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
  return letter.size() == 3 && byte(0) == 0xE2 &&
         ((byte(1) == 0x80 && (byte(2) >= 0xAA && byte(2) <= 0xAE)) ||
          (byte(1) == 0x81 && (byte(2) >= 0xA6 && byte(2) <= 0xA9)));
}

// One whole line at once: a reader never sees half of one.
void say_json(const char* kind, const Json& content) {
  Json line{{"kind", kind}};
  line.update(content);
  write_to(STDERR_FILENO, line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

} // namespace

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    const int null = open("/dev/null", O_RDONLY); // writing to it fails, as to the closed one
    if (null >= 0 && null != stream) {
      dup2(null, stream);
      close(null);
    }
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN); // writing fails, with a reason
}

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view letter = text.substr(i, length == 0 ? 1 : length);
    if (length == 0 || is_control(letter))
      for (const char c : letter) shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    else
      shown += letter;
    i += letter.size();
  }
  return shown;
}

void speak_json() {
  json_lines = true;
}

bool speaks_json() {
  return json_lines;
}

void say(std::string_view text) {
  if (json_lines)
    say_json("note", {{"text", trimmed(text)}});
  else
    write_to(STDERR_FILENO, printable(text));
}

void say_warning(std::string_view text) {
  if (json_lines)
    say_json("warning", {{"text", text}});
  else
    say("warning: " + std::string(text) + "\n");
}

void say_failure(std::string_view text) {
  if (json_lines)
    say_json("failure", {{"text", text}});
  else
    say(std::string(text) + "\n");
}

void say_problems(const InputError& error) {
  if (!json_lines) return say(std::string(error.what()) + "\n");
  for (const InputProblem& p : error.problems())
    say_json("error", {{"file", p.file},
                       {"line", p.line},
                       {"key", p.key},
                       {"wrong", p.wrong},
                       {"allowed", p.allowed}});
}

void say_progress(const std::string& title, const std::string& stage, double seconds,
                  double share) {
  const Json known = share > 0 ? Json(share) : Json(nullptr);
  say_json("progress", {{"title", title},
                        {"stage", stage},
                        {"seconds", std::round(1e3 * seconds) / 1e3},
                        {"share", known},
                        {"left", share > 0 ? Json(seconds * (1 - share) / share) : Json(nullptr)}});
}

void say_written(const std::string& command, const Manifest& files) {
  if (!json_lines) return;
  Json known = Json::object();
  for (const auto& [name, file] : files)
    if (!file.prints.empty())
      known[name] = {{"command", file.command}, {"fingerprint", file.prints.back()}};
  say_json("written", {{"command", command}, {"files", known}});
}

void say_raw(std::string_view text) {
  write_to(STDERR_FILENO, text);
}

void print(std::string_view text) {
  write_to(STDOUT_FILENO, printable(text));
}

int finished(int exit_code) {
  errno = 0;
  if (!std::cout.flush() && why_not_printed == 0) // the help, which is not ours
    why_not_printed = errno != 0 ? errno : EIO;
  if (why_not_printed == 0) return exit_code;
  if (why_not_printed != EPIPE) // a reader that has read enough knows
    say(fmt::format("plica: standard output cannot be written: {}; files that were written stay\n",
                    std::strerror(why_not_printed)));
  return exit_code == 0 ? 1 : exit_code;
}

} // namespace plica
