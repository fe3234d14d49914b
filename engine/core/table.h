// core/table.h: reads and writes tables of text (CSV, RFC 4180), also in the forms that spreadsheets write.
//
// The first line names the columns, in any order. Cells are separated by commas, or by semicolons or tabs if
// the first line has more of those; numbers may then have a decimal comma. The following make no difference:
// capitals in titles, a byte order mark, lines that end in CRLF, blanks round a cell, quotes round a cell, a
// first line "sep=;", rows and titles without content at the end, and a plus before a number. A cell in
// quotes may hold separators and ends of lines; two quotes in it stand for one.
#pragma once
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace thaum {

/// Reads a table row by row and keeps the first fault, with its line. After a fault there are no more rows.
class TableReader {
public:
    /// Returned by `column` for an optional column that the table lacks.
    static constexpr std::size_t no_column = static_cast<std::size_t>(-1);

    /// Reads the titles. `csv` must outlive the reader; errors mention `name`. If `usual_titles` is given
    /// (separated by commas), a table that begins with numbers instead of titles gets these titles.
    TableReader(std::string_view csv, std::string_view name, std::string_view usual_titles = {});

    /// Column of a title. If the table lacks it, returns no_column, and reports a fault if the column is
    /// required.
    std::size_t column(std::string_view title, bool required = true);

    /// Goes to the next row that has content. Returns false at the end and after a fault.
    bool next();
    /// A cell of the row, without its quotes; valid until the next row.
    std::string_view cell(std::size_t column) const { return cells_[column]; }
    /// Number in a cell of the row. A cell that holds no finite number is a fault; a column that the table
    /// lacks (no_column) gives 0.
    double number(std::size_t column);

    /// Line in which the row begins, from 1.
    std::size_t line() const { return line_; }

    /// Reports a fault at the current row.
    void report(std::string_view what);
    /// Whether no fault has been found so far.
    bool good() const { return !fault_.has_value(); }
    /// The first fault. Must be called only if `good` is false.
    Error fault() const { return fail(*fault_); }

private:
    void check_point(std::string_view word);
    void read_titles(std::string_view usual_titles);
    void read_cells();
    std::string_view read_plain();
    std::string_view read_quoted();
    bool take(char c);
    void skip_blanks();
    std::size_t end_of_line() const;
    bool has_content() const;
    std::optional<double> number_in(std::string_view word) const;

    std::string_view remaining_;
    std::string name_;
    std::size_t line_ = 1;        ///< line in which the current row begins, from 1
    std::size_t lines_read_ = 0;  ///< number of lines read so far, including the current row
    char separator_ = ',';
    /// Decimal sign, '.' or ',', that the numbers read so far have; 0: none of them has one. Only used in a
    /// table that may have decimal commas.
    char point_ = 0;
    char line_end_ = '\n';
    /// true: the first line held numbers instead of titles, so `next` must return it as the first row.
    bool first_row_pending_ = false;
    std::vector<std::string> titles_{};
    std::vector<std::string_view> cells_{};
    std::deque<std::string> unquoted_{};  ///< storage for cells in which doubled quotes were replaced by one
    std::optional<std::string> fault_{};
};

/// Appends a cell to a row, in quotes if necessary.
void append_cell(std::string& row, std::string_view cell);

}  // namespace thaum
