// tools/bench/report.h: what a benchmark found, as JSON (the page on interfaces) and as a table for the terminal.
//
// Every row is one setting of one case. Rows with a time and an error compete: the Pareto front of a case is made of
// the rows that no other row of that case beats in one of the two without losing in the other.
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

/// In us, of one run.
struct Times {
    double min{};
    double median{};
    double p99{};
};

struct ErrorMeasure {
    std::string name;  ///< "rms_velocity"
    double value{};    ///< not below zero; not finite where the run failed
};

struct Row {
    std::string area{};
    std::string name{};  ///< of the case
    std::vector<std::pair<std::string, Value>> setting{};
    std::optional<Times> time_us{};
    std::optional<ErrorMeasure> error{};
    bool front = false;                                     ///< set by mark_fronts
    bool is_default = false;                                ///< the shipped setting
    std::vector<std::pair<std::string, double>> metrics{};  ///< the names carry the unit
    std::optional<std::string> hash{};                      ///< of what was computed, in hexadecimal
    std::string fault{};  ///< why the row cannot be trusted (invariants.h); empty: it can
};

struct Machine {
    std::string cpu;
    unsigned cores{};
    std::string build;  ///< "Release"
};

struct Report {
    std::string version;
    Machine machine;
    std::vector<Row> rows{};
    std::vector<std::string> faults{};  ///< what must not be, a line each
};

/// No rows yet; this program's version, this machine.
Report empty_report();

/// Sets `front` of every row: median time against error within one case of one area.
void mark_fronts(std::vector<Row>& rows);

/// One object, indented, with a trailing newline. Numbers that are not finite become null.
std::string to_json(const Report& report);

/// What to_json wrote, or another program in its form. null, or a value that is left out, is a number that is not finite; keys
/// that are not known are passed over. The error names the row and the key: not JSON, no rows, a wrong type.
Expected<Report> from_json(std::string_view json);

/// Four significant digits.
std::string shown(double value);
/// A text as it is, an integer in full, another number by four digits.
std::string shown(const Value& value);

/// One table for each area. A column is a setting or a metric that some row of the area has; '*' marks the front, 'd' the default,
/// '!' a row that breaks its own invariant.
std::string to_table(const Report& report);

}  // namespace thaum::bench
