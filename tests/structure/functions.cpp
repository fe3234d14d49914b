// A definition is a function if it ends in a closing brace and no semicolon follows. Classes, enums and
// variables end in a semicolon, and namespaces begin with their keyword. So no grammar is needed, only the text
// without comments, literals and directives.
#include "structure/functions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace thaum::structure {
namespace {

constexpr auto none = std::string_view::npos;

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_hex_digit(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

std::size_t end_or(std::size_t at, std::size_t size) { return std::min(at, size); }

/// End of a literal between two equal quotes, whose first one is at `at`.
std::size_t end_of_quoted(std::string_view s, std::size_t at) {
    const char quote = s[at++];
    while (at < s.size() && s[at] != quote) at += s[at] == '\\' ? 2 : 1;
    return end_or(at + 1, s.size());
}

/// End of a raw string, whose quote is at `at`.
std::size_t end_of_raw_string(std::string_view s, std::size_t at) {
    const auto open = s.find('(', at);
    if (open == none) return s.size();
    const auto close = ")" + std::string(s.substr(at + 1, open - at - 1)) + "\"";
    const auto end = s.find(close, open);
    return end == none ? s.size() : end + close.size();
}

/// End of a directive, which goes on after a line that ends in a backslash.
std::size_t end_of_directive(std::string_view s, std::size_t at) {
    at = end_or(s.find('\n', at), s.size());
    while (at < s.size() && s[at - 1] == '\\') at = end_or(s.find('\n', at + 1), s.size());
    return at;
}

bool is_first_in_line(std::string_view s, std::size_t at) {
    while (at > 0 && s[at - 1] != '\n') {
        if (!is_space(s[--at])) return false;
    }
    return true;
}

/// End of the comment, literal or directive that begins at `at`; `at` itself if none begins there.
std::size_t end_of_other_text(std::string_view s, std::size_t at) {
    const auto rest = s.substr(at);
    const char before = at > 0 ? s[at - 1] : '\n';
    if (rest.starts_with("//")) return end_or(s.find('\n', at), s.size());
    if (rest.starts_with("/*")) return end_or(s.find("*/", at), s.size() - 2) + 2;
    if (rest[0] == '"') return before == 'R' ? end_of_raw_string(s, at) : end_of_quoted(s, at);
    // After a digit the mark separates groups of digits.
    if (rest[0] == '\'' && !is_hex_digit(before)) return end_of_quoted(s, at);
    if (rest[0] == '#' && is_first_in_line(s, at)) return end_of_directive(s, at);
    return at;
}

/// The source with spaces in place of comments, literals and directives. Line ends stay.
std::string without_other_text(std::string source) {
    for (std::size_t at = 0; at < source.size();) {
        const auto end = std::max(end_of_other_text(source, at), at);
        for (std::size_t i = at; i < end; ++i) {
            if (source[i] != '\n') source[i] = ' ';
        }
        at = end > at ? end : at + 1;
    }
    return source;
}

/// Position of the bracket that closes the one at `at`.
std::size_t closing(std::string_view s, std::size_t at, char open, char close) {
    int depth = 0;
    for (; at < s.size(); ++at) {
        depth += s[at] == open ? 1 : s[at] == close ? -1 : 0;
        if (depth == 0) return at;
    }
    return s.size();
}

std::size_t skip_space(std::string_view s, std::size_t at) {
    while (at < s.size() && is_space(s[at])) ++at;
    return at;
}

/// First character of a definition after the spaces and labels of access at `at`.
std::size_t start_of_definition(std::string_view s, std::size_t at) {
    constexpr std::array<std::string_view, 3> labels{"public:", "protected:", "private:"};
    for (;;) {
        at = skip_space(s, at);
        const auto* label = std::find_if(labels.begin(), labels.end(),
                                         [&](std::string_view l) { return s.substr(at).starts_with(l); });
        if (label == labels.end()) return at;
        at += label->size();
    }
}

/// Returns true if a brace after this text opens a namespace, a class or an enum.
bool opens_scope(std::string_view head) {
    if (head.starts_with("template")) {
        const auto end =
            end_or(closing(head, end_or(head.find('<'), head.size()), '<', '>') + 1, head.size());
        head = head.substr(skip_space(head, end));
    }
    if (head.starts_with("inline namespace")) return true;
    const auto word = head.substr(0, head.find_first_of(" \n{"));
    if (word == "extern") return head.find('(') == none;  // extern "C" around several declarations
    constexpr std::array<std::string_view, 5> scopes{"namespace", "class", "struct", "union", "enum"};
    return std::find(scopes.begin(), scopes.end(), word) != scopes.end();
}

/// Returns true if the definition goes on behind a closing brace: a variable, or an initialiser before the
/// body of a constructor.
bool goes_on(std::string_view s, std::size_t brace) {
    const auto next = skip_space(s, brace + 1);
    return next < s.size() && std::string_view(";,{=)").find(s[next]) != none;
}

std::size_t line_of(std::string_view s, std::size_t at) {
    return 1 +
           static_cast<std::size_t>(std::count(s.begin(), s.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace

std::vector<FunctionExtent> functions_in(const std::string& source) {
    const auto text = without_other_text(source);
    const std::string_view s = text;
    std::vector<FunctionExtent> result;
    auto start = start_of_definition(s, 0);
    for (std::size_t at = 0; at < s.size(); ++at) {
        if (s[at] == '(') at = closing(s, at, '(', ')');
        if (at >= s.size()) break;
        bool ends = s[at] == ';' || s[at] == '}';
        if (s[at] == '{') {
            ends = opens_scope(s.substr(start, at - start));
            if (!ends) {
                at = closing(s, at, '{', '}');
                ends = !goes_on(s, at);
                if (ends && at < s.size()) {
                    const auto first = line_of(s, start);
                    result.push_back({first, line_of(s, at) - first + 1});
                }
            }
        }
        if (ends) start = start_of_definition(s, at + 1);
    }
    return result;
}

}  // namespace thaum::structure
