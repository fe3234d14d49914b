// tools/bench/report.h: results of a benchmark, as JSON and as a table for the terminal.
//
// Every row is one setting of one case. Rows with a time and an error are compared. The Pareto front of a
// case holds those rows that no other row of the case beats in time without a larger error, or in error
// without a longer time.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.h"

namespace thaum::bench {

using Value = std::variant<std::int64_t, double, std::string>;

/// Times of one run of a case (us).
struct Times {
    double min{};
    double median{};
    double p99{};
};

struct ErrorMeasure {
    std::string name;  ///< name such as "rms_velocity"
    double value{};    ///< zero or more; not finite if the run failed
    /// true: the method of this row is a baseline that may diverge, and an infinite error is its result.
    bool may_diverge = false;
};

struct Row {
    std::string area{};
    std::string name{};  ///< name of the measured case
    std::vector<std::pair<std::string, Value>> setting{};
    std::optional<Times> time_us{};
    std::optional<ErrorMeasure> error{};
    /// true: the row is on the Pareto front; set by mark_fronts.
    bool front = false;
    bool is_default = false;                                ///< true if the row has the setting that the game
                                                            ///< is shipped with
    std::vector<std::pair<std::string, double>> metrics{};  ///< further figures; each name includes the unit
    std::optional<std::string> hash{};                      ///< hash of the computed result, in hexadecimal
    std::string fault{};  ///< reason why the row cannot be trusted (invariants.h); empty: none
};

struct Machine {
    std::string cpu;
    unsigned cores{};
    std::string build;  ///< build type, such as "Release"
};

struct Report {
    std::string version;
    Machine machine;
    std::vector<Row> rows{};
    std::vector<std::string> faults{};  ///< faults found by the benchmarks, one line each
};

/// A report without rows, with the version of this program and this machine.
Report empty_report();

/// Sets `front` of every row, by median time and error within one case of one area (group of benchmarks).
void mark_fronts(std::vector<Row>& rows);

/// The report as one indented JSON object, ending with a newline. Numbers that are not finite become null.
std::string to_json(const Report& report);

/// Reads JSON in the form in which to_json writes it. A value that is null or missing becomes a number that
/// is not finite. Unknown keys are ignored. The error names the row and the key: no JSON, no rows, or a wrong
/// type.
Expected<Report> from_json(std::string_view json);

/// A number with four significant digits.
std::string shown(double value);
/// A text unchanged, an integer in full, any other number with four significant digits.
std::string shown(const Value& value);

/// One table per area (group of benchmarks), with a column for each setting and metric that some row of the
/// area has. '*' marks the Pareto front, 'd' the shipped setting, '!' a row that breaks an invariant.
std::string to_table(const Report& report);

}  // namespace thaum::bench
