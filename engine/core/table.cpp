#include "core/table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/one_line.h"
#include "core/text.h"

namespace thaum {
namespace {

constexpr std::size_t most_columns = 1000;
constexpr std::size_t most_shown = 40;          // bytes of a cell in an error
constexpr std::size_t most_titles_shown = 200;  // bytes of all titles in an error
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view separator_line = "sep=";

/// Tests whether a text is UTF-16, in which some spreadsheets save "Unicode text".
bool is_utf16(std::string_view text) {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
           text.substr(0, 4).find('\0') != std::string_view::npos;
}

std::string_view without_end(std::string_view line) {
    while (line.ends_with(' ') || line.ends_with('\t') || line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// The separator of a table by its first line: a comma, or if there is none outside of quotes, a semicolon or tab.
char separator_of(std::string_view line) {
    std::array<bool, 3> found{};
    static constexpr std::string_view separators = ",;\t";
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        const auto at = separators.find(c);
        if (!quoted && at != std::string_view::npos) found.at(at) = true;
    }
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found.at(i)) return separators[i];
    return ',';
}

}  // namespace

TableReader::TableReader(std::string_view csv, std::string_view name, std::string_view usual_titles)
    : rest_(csv), name_(printable(name, 200)) {
    if (is_utf16(csv)) {
        report("this is UTF-16; save the table as CSV in UTF-8");
        return;
    }
    if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
    if (rest_.find('\n') == std::string_view::npos) line_end_ = '\r';
    read_titles(usual_titles);
}

void TableReader::read_titles(std::string_view usual_titles) {
    auto first = without_end(rest_.substr(0, end_of_line()));
    const bool named = first.size() == separator_line.size() + 1 && first.starts_with(separator_line);
    separator_ = named ? first.back() : separator_of(first);
    if (named) {
        rest_.remove_prefix(std::min(end_of_line() + 1, rest_.size()));
        ++lines_read_;
    }
    do read_cells();
    while (good() && !has_content() && !rest_.empty());
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
    const auto found = std::ranges::find(titles_, title);
    if (std::ranges::count(titles_, title) > 1) report(text("two columns have the title '", title, "'"));
    if (found != titles_.end()) return static_cast<std::size_t>(found - titles_.begin());
    if (!required) return no_column;
    std::string all;
    for (const auto& other : titles_) append_text(all, text(all.empty() ? "" : ", ", other));
    report(text("no column '", title, "'; there are: ", printable(all, most_titles_shown)));
    return no_column;
}

bool TableReader::next() {
    if (!good()) return false;
    if (!std::exchange(first_row_pending_, false)) {
        do {
            if (rest_.empty()) return false;
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
        report(text("'", printable(word, most_shown), "' is not a finite number"));
    return value.value_or(0);
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

std::size_t TableReader::end_of_line() const { return std::min(rest_.find(line_end_), rest_.size()); }

bool TableReader::take(char c) {
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
}

void TableReader::skip_blanks() {
    const auto is_blank = [&](char c) { return c == ' ' || (c == '\t' && separator_ != '\t'); };
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
}

/// Reads the cells of the next line; of more than one if ends of lines stand in quotes.
void TableReader::read_cells() {
    cells_.clear();
    unquoted_.clear();
    line_ = ++lines_read_;
    do {
        if (cells_.size() == most_columns) return report(text("more than ", most_columns, " columns"));
        skip_blanks();
        cells_.push_back(take('"') ? read_quoted() : read_plain());
    } while (good() && take(separator_));
    bool ended = take('\r');
    if (line_end_ == '\n') ended = take('\n');
    if (!ended && !rest_.empty()) report("text behind a closing quote");
}

std::string_view TableReader::read_plain() {
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != separator_ && rest_[end] != line_end_) ++end;
    const auto cell = without_end(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return cell;
}

/// Reads a cell behind its opening quote.
std::string_view TableReader::read_quoted() {
    std::string* unquoted = nullptr;
    for (;;) {
        const auto end = rest_.find('"');
        if (end == std::string_view::npos) {
            report("a quote is opened and not closed");
            return {};
        }
        const auto part = rest_.substr(0, end);
        lines_read_ += static_cast<std::size_t>(std::ranges::count(part, line_end_));
        rest_.remove_prefix(end + 1);
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
