#include "game/command_line/arguments.h"

#include <algorithm>

#include "core/near_name.h"
#include "core/text.h"
#include "core/write_rule.h"

namespace thaum::game::inline command_line {
namespace {

using Given = std::map<std::string, std::vector<std::string>>;

bool is_file(const std::string& name) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(name, unknown);
}

const Option* find_option(std::span<const Option> options, std::string_view name) {
    const auto found =
        std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.name == name; });
    return found == options.end() ? nullptr : &*found;
}

/// Returns an error if another argument names the file that an option will write.
Expected<void> check_written(std::span<const Option> options, const Given& given,
                             const std::vector<std::string>& plain) {
    for (const auto& option : options) {
        const auto written = given.find(std::string(option.name));
        if (!option.writes || written == given.end()) continue;
        const auto& target = written->second.back();
        if (target == "-") continue;
        const auto is_input = [&](const std::string& word) {
            return is_file(word) && same_target(word, target);
        };
        bool is_read = std::any_of(plain.begin(), plain.end(), is_input);
        for (const auto& [name, values] : given) {
            if (name == option.name) continue;
            const bool writes = find_option(options, name)->writes;
            if (writes && same_target(values.back(), target))
                return fail(text(option.name, " and ", name, " both write ", target,
                                 "; give one of them another name"));
            is_read = is_read || (!writes && std::any_of(values.begin(), values.end(), is_input));
        }
        if (is_read)
            return fail(text(target, ": cannot write: it is read by this command; give another name"));
    }
    return {};
}

}  // namespace

// The library CLI11 is not used. It would make this function longer, since its messages differ from Thaum's
// and would have to be translated. This file would compile in 11.4 s instead of 2.0 s, and its code would be
// ten times as large.
Expected<Arguments> Arguments::parse(std::span<const std::string> words, std::span<const Option> options) {
    Arguments result;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto& word = words[i];
        if (word.size() < 2 || word[0] != '-') {
            result.plain_.push_back(word);
            continue;
        }
        const auto* option = find_option(options, word);
        if (option == nullptr)
            return fail(text("unknown option '", word, "'", did_you_mean(word, options, &Option::name)));
        if (result.has(word) && !option->repeats) return fail(text("option '", word, "' is given twice"));
        auto& values = result.given_[word];
        if (words.size() - i - 1 < option->values) {
            return fail(text("option '", word, "' needs ", option->values,
                             option->values == 1 ? " value" : " values"));
        }
        for (std::size_t v = 0; v < option->values; ++v) values.push_back(words[++i]);
    }
    if (auto checked = check_written(options, result.given_, result.plain_); !checked) return checked.error();
    return result;
}

std::optional<std::string> Arguments::value(std::string_view option) const {
    const auto found = given_.find(std::string(option));
    if (found == given_.end() || found->second.empty()) return std::nullopt;
    return found->second.back();
}

std::optional<std::filesystem::path> Arguments::path(std::string_view option) const {
    const auto word = value(option);
    if (!word) return std::nullopt;
    return *word;
}

std::vector<std::string> Arguments::values(std::string_view option) const {
    const auto found = given_.find(std::string(option));
    return found == given_.end() ? std::vector<std::string>{} : found->second;
}

Expected<std::optional<double>> Arguments::number(std::string_view option, double low, double high) const {
    const auto word = value(option);
    if (!word) return std::nullopt;
    const auto read = parse_number(*word, option, low, high);
    if (!read) return read.error();
    return *read;
}

Expected<std::optional<std::uint64_t>> Arguments::whole(std::string_view option, std::uint64_t low,
                                                        std::uint64_t high) const {
    const auto word = value(option);
    if (!word) return std::nullopt;
    const auto read = parse_whole(*word, option, low, high);
    if (!read) return read.error();
    return *read;
}

Expected<double> Arguments::number(std::string_view option, double low, double high, double fallback) const {
    const auto given = number(option, low, high);
    if (!given) return given.error();
    return given->value_or(fallback);
}

Expected<std::uint64_t> Arguments::whole(std::string_view option, std::uint64_t low, std::uint64_t high,
                                         std::uint64_t fallback) const {
    const auto given = whole(option, low, high);
    if (!given) return given.error();
    return given->value_or(fallback);
}

std::vector<std::string> parts_of(std::string_view word, char between) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= word.size();) {
        const auto end = std::min(word.find(between, from), word.size());
        parts.emplace_back(word.substr(from, end - from));
        from = end + 1;
    }
    return parts;
}

Expected<render::Size> parse_size(std::string_view word, std::string_view what) {
    const auto x = word.find('x');
    const auto width = parse_whole(word.substr(0, x), what, 64, 7680);
    const auto height = parse_whole(x == std::string_view::npos ? "" : word.substr(x + 1), what, 64, 4320);
    if (!width || !height)
        return fail(text(what, " '", word, "': must be like 1280x720, from 64x64 to 7680x4320"));
    return render::Size{static_cast<int>(*width), static_cast<int>(*height)};
}

}  // namespace thaum::game::inline command_line
