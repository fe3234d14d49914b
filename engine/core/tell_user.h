// core/tell_user.h: how the program speaks to whoever started it, beside its windows.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Writes one line to standard error. Of what a terminal would act on, such as control characters in a file's or a device's
/// name, ends of lines become blanks and the rest is escaped. What goes beyond 1,000 bytes becomes "..." (in_one_line).
void tell_user(std::string_view line);

/// Writes one line, of any length, to standard output. What a terminal would act on is escaped (printable).
void print_line(std::string_view line);

/// Writes several lines as `print_line` does. The last one may have no end.
void print_lines(std::string_view lines);

/// Words for the exception that is being handled.
std::string words_of_exception();

/// From now on, an exception that no code handles, in whatever thread, is told in one line before it aborts the program.
void tell_unhandled_exceptions();

}  // namespace thaum
