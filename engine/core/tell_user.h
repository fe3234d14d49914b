// core/tell_user.h: prints messages of the program to standard error and standard output.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Writes one line to standard error. Line breaks become blanks, and other characters that a terminal would
/// act on are escaped, because names of files and devices may contain them. Text beyond 1,000 bytes becomes
/// "..." (in_one_line).
void tell_user(std::string_view line);

/// Writes one line, of any length, to standard output. Characters that a terminal would act on are escaped
/// (printable).
void print_line(std::string_view line);

/// Writes several lines as `print_line` does. The last one may lack its line break.
void print_lines(std::string_view lines);

/// A message for the exception that is being handled.
std::string words_of_exception();

/// From now on, an exception that no code handles, in any thread, is printed in one line before it aborts the
/// program.
void tell_unhandled_exceptions();

}  // namespace thaum
