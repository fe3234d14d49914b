#include "core/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/letters.h"
#include "core/one_line.h"
#include "core/text.h"
#include "core/utf8.h"

namespace thaum {
namespace {

constexpr std::size_t max_columns = 1000;
constexpr std::size_t max_shown = 40;          // longest part of a cell that an error quotes (bytes)
constexpr std::size_t max_titles_shown = 200;  // longest list of titles that an error quotes (bytes)
/// Bytes at the start of a file by which its kind is recognised.
constexpr std::size_t max_looked_at = 64;
constexpr std::string_view separator_line = "sep=";

/// Names the kind of a file that is no table, such as a spreadsheet's own format; empty if it may be a table.
std::string_view no_table(std::string_view text) {
    constexpr std::array<std::string_view, 3> archives{"PK\x03\x04", "\x1f\x8b", "\xd0\xcf\x11\xe0"};
    if (std::ranges::any_of(archives, [&](auto start) { return text.starts_with(start); }))
        return "a workbook or an archive";
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "UTF-16";
    if (text.substr(0, max_looked_at).find('\0') != std::string_view::npos) return "UTF-16, or no text";
    return {};
}

std::string_view without_end(std::string_view line) {
    while (line.ends_with(' ') || line.ends_with('\t') || line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// Finds the separator of a table from its first line: the character that occurs there most often outside of
/// quotes. If `usual_titles` is given, the line holds numbers, whose decimal signs may be commas. Then it is
/// the character that gives as many cells as there are usual titles.
char separator_of(std::string_view line, std::string_view usual_titles) {
    static constexpr std::string_view separators = ",;\t";
    std::array<std::ptrdiff_t, 3> count{};
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        const auto at = separators.find(c);
        if (!quoted && at != std::string_view::npos) ++count.at(at);
    }
    const auto commas = std::ranges::count(usual_titles, ',');
    if (!usual_titles.empty())
        for (const std::size_t other : {1U, 2U})
            if (count.at(other) == commas) return separators[other];
    return separators[static_cast<std::size_t>(std::ranges::max_element(count) - count.begin())];
}

bool has_comma(std::string_view word) { return word.find(',') != std::string_view::npos; }

}  // namespace

TableReader::TableReader(std::string_view csv, std::string_view name, std::string_view usual_titles)
    : remaining_(csv), name_(printable(name, 200)) {
    if (const auto other = no_table(csv); !other.empty()) {
        report(text("this is ", other, "; save the table as CSV in UTF-8"));
        return;
    }
    remaining_ = without_byte_order_mark(remaining_);
    if (remaining_.find('\n') == std::string_view::npos) line_end_ = '\r';
    read_titles(usual_titles);
}

void TableReader::read_titles(std::string_view usual_titles) {
    auto first = without_end(remaining_.substr(0, end_of_line()));
    const bool named = first.size() == separator_line.size() + 1 && first.starts_with(separator_line);
    separator_ = named ? first.back() : separator_of(first, usual_titles);
    if (named) {
        remaining_.remove_prefix(std::min(end_of_line() + 1, remaining_.size()));
        ++lines_read_;
    }
    do read_cells();
    while (good() && !has_content() && !remaining_.empty());
    if (!good()) return;
    first_row_pending_ = !usual_titles.empty() && number_in(cells_.front()).has_value();
    if (first_row_pending_) {
        TableReader titles(usual_titles, name_);
        titles_ = std::move(titles.titles_);
    } else {
        titles_.assign(cells_.begin(), cells_.end());
        while (!titles_.empty() && titles_.back().empty()) titles_.pop_back();
        if (titles_.empty()) report("the file is empty");
    }
}

std::size_t TableReader::column(std::string_view title, bool required) {
    const auto is_it = [&](std::string_view other) { return same_word(other, title); };
    const auto found = std::ranges::find_if(titles_, is_it);
    if (std::ranges::count_if(titles_, is_it) > 1) report(text("two columns have the title '", title, "'"));
    if (found != titles_.end()) return static_cast<std::size_t>(found - titles_.begin());
    if (!required) return no_column;
    std::string all;
    for (const auto& other : titles_) append_text(all, text(all.empty() ? "" : ", ", other));
    report(text("no column '", title, "'; there are: ", printable(all, max_titles_shown)));
    return no_column;
}

bool TableReader::next() {
    if (!good()) return false;
    if (!std::exchange(first_row_pending_, false)) {
        do {
            if (remaining_.empty()) return false;
            read_cells();
        } while (good() && !has_content());
    }
    while (cells_.size() > titles_.size() && cells_.back().empty()) cells_.pop_back();
    if (good() && cells_.size() != titles_.size())
        report(text("the number of cells is ", cells_.size(), ", that of titles ", titles_.size()));
    return good();
}

double TableReader::number(std::size_t column) {
    if (column == no_column) return 0;
    const auto word = cells_[column];
    const auto value = number_in(word);
    if (!value && word.empty())
        report(text("no number in the column '", titles_[column], "'"));
    else if (!value)
        report(text("'", printable(word, max_shown), "' in the column '", titles_[column],
                    "' is not a finite number",
                    separator_ == ',' && has_comma(word) ? "; write a point for the comma" : ""));
    else if (separator_ != ',')
        check_point(word);
    return value.value_or(0);
}

/// All numbers of a table must use the same decimal sign, because the other sign could separate thousands.
void TableReader::check_point(std::string_view word) {
    const auto at = word.find_first_of(",.");
    if (at == std::string_view::npos) return;
    if (point_ == 0) point_ = word[at];
    if (word[at] != point_)
        report(text("'", printable(word, max_shown),
                    "' has another sign for the point than the numbers before it"));
}

std::optional<double> TableReader::number_in(std::string_view word) const {
    std::array<char, 64> with_point{};
    const bool comma = separator_ != ',' && word.find('.') == std::string_view::npos &&
                       std::ranges::count(word, ',') == 1 && word.size() <= with_point.size();
    if (comma) {
        std::ranges::replace_copy(word, with_point.begin(), ',', '.');
        word = {with_point.data(), word.size()};
    }
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    double value = 0;
    const auto* const end = word.data() + word.size();
    const auto [read, code] = std::from_chars(word.data(), end, value);
    if (code != std::errc() || read != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

void TableReader::report(std::string_view what) {
    if (!fault_) fault_ = text(name_, ":", line_, ": ", what);
}

bool TableReader::has_content() const {
    return std::ranges::any_of(cells_, [](std::string_view cell) { return !cell.empty(); });
}

std::size_t TableReader::end_of_line() const {
    return std::min(remaining_.find(line_end_), remaining_.size());
}

bool TableReader::take(char c) {
    if (!remaining_.starts_with(c)) return false;
    remaining_.remove_prefix(1);
    return true;
}

void TableReader::skip_blanks() {
    const auto is_blank = [&](char c) { return c == ' ' || (c == '\t' && separator_ != '\t'); };
    while (!remaining_.empty() && is_blank(remaining_.front())) remaining_.remove_prefix(1);
}

/// Reads the cells of the next row, which spans several lines if a quoted cell contains line breaks.
void TableReader::read_cells() {
    cells_.clear();
    unquoted_.clear();
    line_ = ++lines_read_;
    do {
        if (cells_.size() == max_columns) return report(text("more than ", max_columns, " columns"));
        skip_blanks();
        cells_.push_back(take('"') ? read_quoted() : read_plain());
    } while (good() && take(separator_));
    bool ended = take('\r');
    if (line_end_ == '\n') ended = take('\n');
    if (!ended && !remaining_.empty()) report("text behind a closing quote");
}

std::string_view TableReader::read_plain() {
    std::size_t end = 0;
    while (end < remaining_.size() && remaining_[end] != separator_ && remaining_[end] != line_end_) ++end;
    const auto cell = without_end(remaining_.substr(0, end));
    remaining_.remove_prefix(end);
    return cell;
}

/// Reads a quoted cell. The opening quote has been read already.
std::string_view TableReader::read_quoted() {
    std::string* unquoted = nullptr;
    for (;;) {
        const auto end = remaining_.find('"');
        if (end == std::string_view::npos) {
            report("a quote is opened and not closed");
            return {};
        }
        const auto part = remaining_.substr(0, end);
        lines_read_ += static_cast<std::size_t>(std::ranges::count(part, line_end_));
        remaining_.remove_prefix(end + 1);
        const bool goes_on = take('"');
        if (goes_on && unquoted == nullptr) unquoted = &unquoted_.emplace_back();
        if (unquoted != nullptr) append_text(*unquoted, part);
        if (!goes_on) {
            skip_blanks();
            return unquoted == nullptr ? part : std::string_view(*unquoted);
        }
        *unquoted += '"';
    }
}

void append_cell(std::string& row, std::string_view cell) {
    const bool blanks = cell.starts_with(' ') || cell.ends_with(' ');
    if (!blanks && cell.find_first_of(",;\t\"\r\n") == std::string_view::npos) return append_text(row, cell);
    row += '"';
    for (const char c : cell) {
        if (c == '"') row += '"';
        row += c;
    }
    row += '"';
}

}  // namespace thaum
