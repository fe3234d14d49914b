// core/tell_user.h: how the program speaks to whoever started it, beside its windows.
#pragma once
#include <string>
#include <string_view>

namespace thaum {

/// Writes one line to standard error. Ends of lines and control characters within it, such as those of a file's or a
/// device's name, become blanks, and what goes beyond 1,000 bytes becomes "..." (in_one_line).
void tell_user(std::string_view line);

/// Words for the exception that is being handled.
std::string words_of_exception();

/// From now on, an exception that no code handles, in whatever thread, is told in one line before it aborts the program.
void tell_unhandled_exceptions();

}  // namespace thaum
