#include "core/tell_user.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum {

void tell_user(std::string_view line) { std::fprintf(stderr, "%s\n", in_one_line(line).c_str()); }

void print_line(std::string_view line) { std::printf("%s\n", printable(line, std::string::npos).c_str()); }

void print_lines(std::string_view lines) {
    while (!lines.empty()) {
        const auto end = std::min(lines.find('\n'), lines.size());
        print_line(lines.substr(0, end));
        lines.remove_prefix(std::min(end + 1, lines.size()));
    }
}

std::string words_of_exception() {
    try {
        throw;
    } catch (const std::system_error& refused) {
        return text("the system refused a resource that the program needs: ", refused.what());
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& fault) {
        return text("a fault of the program: ", fault.what());
    } catch (...) {
        return "a fault of the program that says nothing of itself";
    }
}

void tell_unhandled_exceptions() {
    std::set_terminate([] {
        if (std::current_exception() != nullptr) tell_user(text("thaum: ", words_of_exception()));
        std::abort();
    });
}

}  // namespace thaum
