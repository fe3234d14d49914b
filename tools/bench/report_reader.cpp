// Reports come from other machines and versions, so every value is checked before use. A report that would
// be costly to read or print for its length, such as a table of a thousand columns, is refused.
#include <algorithm>
#include <limits>
#include <set>

#include "core/json.h"
#include "core/text.h"
#include "tools/bench/report.h"

namespace thaum::bench {
namespace {

constexpr std::size_t max_rows = 200'000;
constexpr std::size_t max_names = 128;  ///< largest number of different settings and metrics in a report
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

const Json& member(const Json& object, std::string_view key) {
    static const Json nothing;
    const auto* found = object.find(key);
    return found == nullptr ? nothing : *found;
}

/// Members of a JSON object sorted by key, whatever their order in the file.
std::vector<const JsonMember*> sorted_members(const Json& object) {
    std::vector<const JsonMember*> members;
    for (const auto& item : object.members()) members.push_back(&item);
    std::ranges::sort(members, {}, &JsonMember::key);
    return members;
}

Expected<std::string> word(const Json& object, const char* key) {
    const Json& value = member(object, key);
    if (!value.is_string()) return fail(text("'", key, "' must be a text"));
    return value.string();
}

/// Reads a boolean; false if the key is missing.
Expected<bool> mark(const Json& object, const char* key) {
    const Json& value = member(object, key);
    if (value.is_null()) return false;
    if (!value.is_boolean()) return fail(text("'", key, "' must be true or false"));
    return value.boolean();
}

Expected<double> number(const Json& value, std::string_view key) {
    if (value.is_null()) return no_number;
    if (!value.is_number()) return fail(text("'", key, "' must be a number"));
    return value.number();
}

Expected<Value> setting(const Json& value, const std::string& key) {
    if (value.is_string()) return value.string();
    if (value.is_boolean()) return std::string(value.boolean() ? "true" : "false");
    const bool fits = !value.is_unsigned() ||
                      value.unsigned_integer() <= std::uint64_t{std::numeric_limits<std::int64_t>::max()};
    if (value.is_integer() && fits) return value.integer();
    const auto real = number(value, key);
    if (!real) return real.error();
    return *real;
}

/// Reads an object; null if the key is missing.
Expected<const Json*> object(const Json& row, const char* key) {
    const Json& value = member(row, key);
    if (!value.is_null() && !value.is_object()) return fail(text("'", key, "' must be an object"));
    return &value;
}

/// Stores a value that was read in `to`, or returns the error of reading it.
template <class Read, class To>
Expected<void> take(Expected<Read> read, To& to) {
    if (!read) return read.error();
    to = *std::move(read);
    return {};
}

Expected<void> read_times(const Json& from, Row& row) {
    const auto times = object(from, "time_us");
    if (!times) return times.error();
    if ((*times)->is_null()) return {};
    row.time_us.emplace();
    for (const auto& [key, to] : {std::pair{"min", &row.time_us->min},
                                  {"median", &row.time_us->median},
                                  {"p99", &row.time_us->p99}}) {
        if (auto taken = take(number(member(**times, key), text("time_us.", key)), *to); !taken) return taken;
    }
    return {};
}

Expected<void> read_error(const Json& from, Row& row) {
    const auto error = object(from, "error");
    if (!error) return error.error();
    if ((*error)->is_null()) return {};
    const auto name = word(**error, "name");
    if (!name) return Error{text("in 'error': ", name.error().message)};
    const auto value = number(member(**error, "value"), "error.value");
    if (!value) return value.error();
    row.error = ErrorMeasure{*name, *value};
    return {};
}

Expected<void> read_settings(const Json& from, Row& row) {
    const auto settings = object(from, "setting");
    if (!settings) return settings.error();
    for (const auto* item : sorted_members(**settings)) {
        const auto value = setting(item->value, text("setting.", item->key));
        if (!value) return value.error();
        row.setting.emplace_back(item->key, *value);
    }
    return {};
}

Expected<void> read_metrics(const Json& from, Row& row) {
    const auto metrics = object(from, "metrics");
    if (!metrics) return metrics.error();
    for (const auto* item : sorted_members(**metrics)) {
        const auto value = number(item->value, text("metrics.", item->key));
        if (!value) return value.error();
        row.metrics.emplace_back(item->key, *value);
    }
    return {};
}

Expected<void> read_marks(const Json& from, Row& row) {
    if (auto taken = take(mark(from, "front"), row.front); !taken) return taken;
    if (auto taken = take(mark(from, "default"), row.is_default); !taken) return taken;
    if (!member(from, "fault").is_null())
        if (auto taken = take(word(from, "fault"), row.fault); !taken) return taken;
    return member(from, "hash").is_null() ? Expected<void>() : take(word(from, "hash"), row.hash);
}

Expected<Row> read_row(const Json& from) {
    if (!from.is_object()) return fail("it must be an object");
    Row row;
    if (auto taken = take(word(from, "area"), row.area); !taken) return taken.error();
    if (auto taken = take(word(from, "case"), row.name); !taken) return taken.error();
    for (const auto read : {read_settings, read_times, read_error, read_metrics, read_marks}) {
        if (const auto done = read(from, row); !done) return done.error();
    }
    return row;
}

/// Reads the description of the machine. Missing values stay unknown, because only the measurements matter.
Machine read_machine(const Json& json) {
    Machine machine{"unknown", 0, "unknown"};
    const auto from = object(json, "machine");
    if (!from || (*from)->is_null()) return machine;
    if (const auto cpu = word(**from, "cpu")) machine.cpu = *cpu;
    if (const auto build = word(**from, "build")) machine.build = *build;
    const Json& cores = member(**from, "cores");
    if (cores.is_unsigned() && cores.unsigned_integer() < 1'000'000)
        machine.cores = static_cast<unsigned>(cores.unsigned_integer());
    return machine;
}

void note_names(const Row& row, std::set<std::string>& names) {
    for (const auto& item : row.setting) names.insert(item.first);
    for (const auto& item : row.metrics) names.insert(item.first);
}

}  // namespace

Expected<Report> from_json(std::string_view json) {
    const auto parsed = parse_json(json);
    if (!parsed) return parsed.error();
    if (!parsed->is_object() || !member(*parsed, "rows").is_array())
        return fail("is no report: it has no list 'rows'; `thaum bench --json FILE` writes one");
    const auto rows = member(*parsed, "rows").elements();
    if (rows.size() > max_rows) return fail(text("has more than ", max_rows, " rows"));
    Report report{word(*parsed, "thaum").value_or("unknown"), read_machine(*parsed), {}};
    std::set<std::string> names;
    for (const Json& from : rows) {
        auto row = read_row(from);
        if (!row) return fail(text("row ", report.rows.size(), ": ", row.error().message));
        note_names(*row, names);
        if (names.size() > max_names)
            return fail(text("has more than ", max_names, " different settings and metrics"));
        report.rows.push_back(std::move(*row));
    }
    return report;
}

}  // namespace thaum::bench
