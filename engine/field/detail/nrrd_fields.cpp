#include "field/detail/nrrd_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/letters.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/utf8.h"

namespace thaum::field {
namespace {

constexpr std::size_t shown = 60;  ///< longest part of a value that a message quotes (bytes)
constexpr std::string_view magic = "NRRD000";

/// Names, without blanks, of all fields that are known: those that are read and those that are skipped.
constexpr std::array<std::string_view, 31> known_fields{"type",
                                                        "dimension",
                                                        "sizes",
                                                        "encoding",
                                                        "endian",
                                                        "spacings",
                                                        "units",
                                                        "kinds",
                                                        "space",
                                                        "spacedimension",
                                                        "spacedirections",
                                                        "spaceorigin",
                                                        "spaceunits",
                                                        "content",
                                                        "datafile",
                                                        "byteskip",
                                                        "measurementframe",
                                                        "sampleunits",
                                                        "blocksize",
                                                        "number",
                                                        "min",
                                                        "max",
                                                        "oldmin",
                                                        "oldmax",
                                                        "thicknesses",
                                                        "axismins",
                                                        "axismaxs",
                                                        "labels",
                                                        "centers",
                                                        "centerings",
                                                        "lineskip"};

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Field name without blanks and capitals: "Data File" -> "datafile".
std::string name_of_field(std::string_view name) {
    std::string out = in_lower_case(name);
    std::erase_if(out, is_blank);
    return out;
}

/// Names of the fields whose names contain blanks, as the format writes them.
constexpr std::array<std::string_view, 14> names_with_blanks{
    "space dimension",   "space directions", "space origin", "space units", "data file",
    "measurement frame", "byte skip",        "line skip",    "axis mins",   "axis maxs",
    "old min",           "old max",          "sample units", "block size"};

/// Field name as the format writes it: "datafile" -> "data file".
std::string_view written_name(std::string_view field) {
    const auto found = std::ranges::find(names_with_blanks, field, name_of_field);
    return found == names_with_blanks.end() ? field : *found;
}

/// Advice for a field of an unknown name: which field its author probably meant.
std::string advice_for_field(std::string_view name) {
    std::array<std::string_view, known_fields.size()> names{};
    std::ranges::transform(known_fields, names.begin(), written_name);
    const auto near = did_you_mean(name, std::span<const std::string_view>(names));
    return near.empty() ? text("; a key of your own is written '", printable(name, shown), ":=value'") : near;
}

std::vector<std::string_view> split(std::string_view s) {
    std::vector<std::string_view> words;
    while (!(s = trimmed(s)).empty()) {
        const std::size_t end = std::min(s.find_first_of(" \t"), s.size());
        words.push_back(s.substr(0, end));
        s.remove_prefix(end);
    }
    return words;
}

bool is_not_given(std::string_view word) {
    const auto lower = in_lower_case(word);
    return lower == "nan" || lower == "-nan" || lower == "none" || lower == "???";
}

/// Reads "none" or "(x,y,z)" from the front of the text and removes it. Returns false if the text begins with
/// neither.
bool take_vector(std::string_view& s, std::optional<vec3>& out) {
    s = trimmed(s);
    if (s.starts_with("none")) {
        s.remove_prefix(4);
        return true;
    }
    const std::size_t end = s.find(')');
    if (!s.starts_with('(') || end == std::string_view::npos) return false;
    std::string_view inner = s.substr(1, end - 1);
    s.remove_prefix(end + 1);
    vec3 v(0);
    int not_given = 0;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = i < 2 ? inner.find(',') : inner.size();
        if (comma == std::string_view::npos) return false;
        v[i] = number_of(inner.substr(0, comma));
        not_given += is_not_given(trimmed(inner.substr(0, comma))) ? 1 : 0;
        inner.remove_prefix(std::min(inner.size(), comma + 1));
    }
    if (not_given == 3) return true;
    out = v;
    return is_finite(v);
}

}  // namespace

std::string in_lower_case(std::string_view s) {
    std::string out(s);
    std::ranges::transform(out, out.begin(), lower_case);
    return out;
}

double number_of(std::string_view word) {
    word = trimmed(word);
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && end == word.data() + word.size() && !word.empty();
    return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

Error NrrdFields::at_line(std::size_t number, std::string_view message) const {
    return {in_one_line(text(name_, ":", number, ": ", message))};
}

Expected<void> NrrdFields::add(std::string_view line, std::size_t number) {
    if (line.starts_with('#')) return {};
    if (trimmed(line).empty())
        return at_line(number, "a line of blanks; take it out, or the blanks if the header ends here");
    const std::size_t colon = line.find(':');
    const bool is_field = colon != std::string_view::npos && colon > 0;
    if (is_field && line.substr(colon).starts_with(":=")) {
        if (line.substr(0, colon) == key_of_save)
            fields_.emplace(key_of_save, Line{std::string(trimmed(line.substr(colon + 2))), number, {}});
        return {};
    }
    if (!is_field)
        return at_line(
            number, text("'", printable(line, shown), "' is no field of a header, such as 'sizes: 8 8 8'"));
    const std::string field = name_of_field(line.substr(0, colon));
    if (std::ranges::find(known_fields, field) == known_fields.end())
        return at_line(number, text("NRRD has no field '", printable(line.substr(0, colon), shown), "'",
                                    advice_for_field(line.substr(0, colon))));
    const bool added = fields_
                           .emplace(field, Line{std::string(trimmed(line.substr(colon + 1))), number,
                                                printable(line.substr(0, colon), shown)})
                           .second;
    if (!added)
        return at_line(
            number, text("field '", printable(line.substr(0, colon), shown), "' stands in the header twice"));
    return {};
}

Expected<NrrdFields> NrrdFields::parse(std::string_view file, std::string name) {
    NrrdFields result(std::move(name));
    const auto first = without_byte_order_mark(file);
    if (!first.starts_with(magic) || first.size() <= magic.size())
        return result.at_line(1, text("not an NRRD file, which begins with ", magic));
    if (first[magic.size()] < '1' || first[magic.size()] > '5')
        return result.at_line(1, "a version of NRRD that is not known; convert the file to NRRD0005");
    // Old Apple computers end lines with \r alone.
    const auto first_end = file.find_first_of("\r\n");
    const bool by_return =
        first_end < file.size() && file[first_end] == '\r' && file.substr(first_end + 1, 1) != "\n";
    const char line_end = by_return ? '\r' : '\n';
    std::size_t at = 0, number = 1;
    for (;; ++number) {
        result.last_line_ = number;
        const std::size_t end = std::min(file.find(line_end, at), file.size());
        if (end > longest_header)
            return fail(text(result.name_, ": the header is longer than ", longest_header, " bytes"));
        std::string_view line = file.substr(at, end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.empty() && end < file.size()) {
            result.end_ = end + 1;
            return result;
        }
        if (result.lists_files()) {
            if (const auto name = trimmed(line); !name.empty())
                result.listed_files_.push_back({std::string(name), number});
        } else if (number > 1 && !line.empty()) {
            if (auto added = result.add(line, number); !added) return added.error();
        }
        if (end == file.size()) return result;
        at = end + 1;
    }
}

bool NrrdFields::lists_files() const {
    const auto of_file = words("datafile");
    return !of_file.empty() && of_file[0] == "LIST";
}

std::map<std::string, std::size_t, std::less<>> NrrdFields::lines() const {
    std::map<std::string, std::size_t, std::less<>> lines;
    for (const auto& [field, line] : fields_) lines.emplace(written_name(field), line.number);
    return lines;
}

std::size_t NrrdFields::line_of(std::string_view field) const {
    const auto found = fields_.find(field);
    return found == fields_.end() ? 0 : found->second.number;
}

std::string_view NrrdFields::text_of(std::string_view field) const {
    const auto found = fields_.find(field);
    return found == fields_.end() ? std::string_view() : found->second.value;
}

void NrrdFields::report(std::string_view field, std::string_view message) {
    if (fault_) return;
    const auto found = fields_.find(field);
    if (found == fields_.end()) {
        fault_ = at_line(last_line_, text("the header, which ends here, has no field '", written_name(field),
                                          "'; ", message));
    } else {
        fault_ = at_line(found->second.number, text("field '", found->second.name, "': ", message));
    }
}

Expected<void> NrrdFields::check() const {
    if (fault_) return *fault_;
    return {};
}

long NrrdFields::integer(std::string_view field, long low, long high, long fallback) {
    if (!has(field)) return fallback;
    const std::string_view value = text_of(field);
    long number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error == std::errc() && end == value.data() + value.size() && number >= low && number <= high)
        return number;
    report(field, text("'", printable(value, shown), "' is not a whole number from ", low, " to ", high));
    return fallback;
}

std::vector<std::string_view> NrrdFields::words(std::string_view field) const {
    return split(text_of(field));
}

std::vector<std::optional<double>> NrrdFields::numbers(std::string_view field, std::size_t count) {
    std::vector<std::optional<double>> result;
    for (const std::string_view word : words(field)) {
        result.emplace_back();
        if (is_not_given(word)) continue;
        result.back() = number_of(word);
        if (!std::isfinite(*result.back()))
            report(
                field,
                text("'", printable(word, shown), "' is no number",
                     word.find(',') == std::string_view::npos ? "" : "; write a point, and blanks between"));
    }
    if (result.size() != count)
        report(field, text(result.size(), " numbers for ", count, " axes; give one for each axis"));
    result.resize(count);
    return result;
}

std::vector<std::string> NrrdFields::quoted(std::string_view field, std::size_t count) {
    std::vector<std::string> result;
    std::string_view remaining = text_of(field);
    while (!(remaining = trimmed(remaining)).empty()) {
        const bool in_quotes = remaining.starts_with('"');
        if (in_quotes) remaining.remove_prefix(1);
        const std::size_t end = std::min(remaining.find_first_of(in_quotes ? "\"" : " \t"), remaining.size());
        result.emplace_back(remaining.substr(0, end));
        remaining.remove_prefix(std::min(remaining.size(), end + 1));
    }
    if (result.size() != count)
        report(field, text(result.size(), " units for ", count, " axes; give one in quotes for each"));
    result.resize(count);
    return result;
}

std::vector<std::optional<vec3>> NrrdFields::vectors(std::string_view field, std::size_t count) {
    std::vector<std::optional<vec3>> result;
    std::string_view remaining = text_of(field);
    while (!(remaining = trimmed(remaining)).empty() && result.size() <= count) {
        result.emplace_back();
        if (!take_vector(remaining, result.back())) {
            report(field, text("'", printable(text_of(field), shown),
                               "' does not consist of vectors of three numbers, such as (1,0,0)"));
            break;
        }
    }
    if (result.size() != count) report(field, text("not one vector for each of ", count, " axes"));
    result.resize(count);
    return result;
}

std::size_t NrrdFields::choice(std::string_view field, std::string_view names_for_message,
                               const std::vector<std::vector<std::string_view>>& names) {
    const std::string_view value = text_of(field);
    const auto is_value = [&](std::string_view name) { return in_lower_case(name) == in_lower_case(value); };
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::any_of(names[i], is_value)) return i;
    }
    if (has(field)) {
        report(field, text("'", printable(value, shown), "' cannot be read; convert to ", names_for_message));
    } else {
        report(field, text("it says ", names_for_message));
    }
    return 0;
}

}  // namespace thaum::field
