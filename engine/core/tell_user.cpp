#include "core/tell_user.h"

#include <cstdio>

#include "core/one_line.h"

namespace thaum {

void tell_user(std::string_view line) { std::fprintf(stderr, "%s\n", in_one_line(line).c_str()); }

}  // namespace thaum
