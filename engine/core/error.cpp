#include "core/error.h"

#include <algorithm>
#include <optional>

namespace thaum {

void no_value(const Error& error, CodeLine asking) {
    assertion_failed(asking.file, asking.line, error.message);
}

std::vector<std::string> lines_of(const Error& error) {
    std::vector<std::string> lines{error.message};
    lines.insert(lines.end(), error.more.begin(), error.more.end());
    return lines;
}

void add_faults(std::optional<Error>& error, const Error& next) {
    for (const auto& line : lines_of(next)) {
        if (!error) {
            error = Error{line};
        } else if (error->message != line && std::ranges::find(error->more, line) == error->more.end()) {
            error->more.push_back(line);
        }
    }
}

}  // namespace thaum
