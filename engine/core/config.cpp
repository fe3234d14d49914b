#include "core/config.h"

#include <cmath>
#include <set>

// Some broken files (such as "x = 1:.2") fail an assertion inside toml++ 3.3. For us they are faults like any other, so
// its assertions throw, in every build, and Config::parse catches.
namespace {
struct ParserLost {};
}  // namespace
#undef NDEBUG
#define TOML_ASSERT(condition)                \
    do {                                      \
        if (!(condition)) throw ParserLost(); \
    } while (false)
#define TOML_EXCEPTIONS 0
#define TOML_MAX_NESTED_VALUES 16
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wterminate"
#include <toml++/toml.h>
#pragma GCC diagnostic pop

#include "core/one_line.h"
#include "core/text.h"

namespace thaum {

struct Config::State {
    toml::table root;
    std::string name;
    std::optional<std::string> fault;
    std::set<const toml::node*> asked;

    void report(const toml::node* where, std::string_view what) {
        if (fault) return;
        fault = where != nullptr && where->source().begin
                    ? text(name, ":", where->source().begin.line, ": ", in_one_line(what))
                    : text(name, ": ", in_one_line(what));
    }
};

namespace {

const toml::table* as_table(const void* table) { return static_cast<const toml::table*>(table); }

/// The first key, depth first, that nobody asked for.
void find_unknown(Config::State& state, const toml::table& table, const std::string& path) {
    for (const auto& [key, node] : table) {
        const auto full = path + std::string(key.str());
        if (!state.asked.contains(&node)) {
            state.report(&node, text("unknown key '", full, "'"));
            return;
        }
        if (const auto* child = node.as_table()) find_unknown(state, *child, full + ".");
        if (const auto* list = node.as_array()) {
            for (const auto& item : *list) {
                if (const auto* child = item.as_table()) find_unknown(state, *child, full + ".");
            }
        }
        if (state.fault) return;
    }
}

/// toml++ destroys nested tables by recursion, and a key such as a.a.a... nests one per dot; so a line may have only
/// so many, decimal points aside.
constexpr std::size_t most_dots = 200;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits before the dot belong to a number, not to a key such as 1.1.1.
bool is_decimal_point(std::string_view line, std::size_t dot) {
    if (dot == 0 || dot + 1 >= line.size() || !is_digit(line[dot - 1]) || !is_digit(line[dot + 1]))
        return false;
    std::size_t first = dot - 1;
    while (first > 0 && is_digit(line[first - 1])) --first;
    return first == 0 || line[first - 1] != '.';
}

bool has_too_many_dots(std::string_view line) {
    std::size_t dots = 0;
    for (auto at = line.find('.'); at != std::string_view::npos; at = line.find('.', at + 1)) {
        if (!is_decimal_point(line, at)) ++dots;
    }
    return dots > most_dots;
}

/// The number of the first line with too many dots, from 1; 0 where there is none.
std::size_t overdotted_line(std::string_view source) {
    std::size_t number = 1;
    while (!source.empty()) {
        const auto end = std::min(source.find('\n'), source.size());
        if (has_too_many_dots(source.substr(0, end))) return number;
        source.remove_prefix(std::min(end + 1, source.size()));
        ++number;
    }
    return 0;
}

Expected<toml::table> parse_toml(std::string_view source, const std::string& name) {
    if (const auto line = overdotted_line(source); line != 0) {
        return fail(text(name, ":", line, ": more than ", most_dots, " dots in one line"));
    }
    try {
        auto result = toml::parse(source, name);
        if (result) return std::move(result).table();
        const auto& error = result.error();
        return fail(text(name, ":", error.source().begin.line, ": ", in_one_line(error.description())));
    } catch (const ParserLost&) {
        return fail(text(name, ": cannot be read as TOML; look for a wrong date or time"));
    }
}

std::string range_text(Range range) { return text("from ", range.low, " to ", range.high); }

/// The low end as a whole number; an open range has one that no integer can hold.
std::int64_t low_end(Range range) {
    return range.low > -9e18 && range.low < 9e18 ? static_cast<std::int64_t>(range.low) : 0;
}

bool in_range(double value, Range range) { return value >= range.low && value <= range.high; }

/// The node at a key, marked as asked for; null where there is none.
const toml::node* ask(Config::State& state, const void* table, std::string_view key) {
    if (table == nullptr) return nullptr;
    const auto* node = as_table(table)->get(key);
    if (node != nullptr) state.asked.insert(node);
    return node;
}

void report_missing(Config::State& state, const void* table, std::string_view key) {
    state.report(as_table(table), text("key '", key, "' is missing"));
}

std::optional<double> number_in(Config::State& state, const toml::node& node, std::string_view key,
                                Range range) {
    const auto value = node.value<double>();
    if (!value || !(node.is_integer() || node.is_floating_point())) {
        state.report(&node, text("'", key, "' must be a number"));
        return std::nullopt;
    }
    if (!in_range(*value, range)) {  // NaN is in no range
        state.report(&node, text("'", key, "' is ", *value, ", must be ", range_text(range)));
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> integer_in(Config::State& state, const toml::node& node, std::string_view key,
                                       Range range) {
    if (!node.is_integer()) {
        state.report(&node, text("'", key, "' must be a whole number"));
        return std::nullopt;
    }
    const auto value = node.as_integer()->get();
    if (!in_range(static_cast<double>(value), range)) {
        state.report(&node, text("'", key, "' is ", value, ", must be ", range_text(range)));
        return std::nullopt;
    }
    return value;
}

std::optional<vec3> vector_in(Config::State& state, const toml::node& node, std::string_view key,
                              Range range) {
    const auto* list = node.as_array();
    if (list == nullptr || list->size() != 3) {
        state.report(&node, text("'", key, "' must be three numbers"));
        return std::nullopt;
    }
    vec3 result{};
    for (int i = 0; i < 3; ++i) {
        const auto value = number_in(state, *list->get(static_cast<std::size_t>(i)), key, range);
        if (!value) return std::nullopt;
        result[i] = *value;
    }
    return result;
}

std::optional<std::size_t> choice_in(Config::State& state, const toml::node& node, std::string_view key,
                                     const std::vector<std::string_view>& names) {
    const auto value = node.value<std::string_view>();
    for (std::size_t i = 0; value && i < names.size(); ++i) {
        if (names[i] == *value) return i;
    }
    std::string all;
    for (const auto name : names) all += text(all.empty() ? "" : ", ", name);
    state.report(&node, text("'", key, "' must be one of: ", all));
    return std::nullopt;
}

}  // namespace

Expected<Config> Config::parse(std::string_view source, std::string name, std::int64_t version) {
    auto table = parse_toml(source, name);
    if (!table) return tl::unexpected(table.error());
    auto state = std::make_shared<State>();
    state->root = std::move(*table);
    state->name = std::move(name);
    Config config(state);
    const auto found = config.root().integer("version", {0, 1e9});
    if (!state->fault && found != version) {
        config.root().report("version", text("version ", found, " cannot be read, only version ", version));
    }
    if (state->fault) return fail(*state->fault);
    return config;
}

Expected<void> Config::replace(std::string_view path, std::string_view value) {
    const auto dot = path.rfind('.');
    auto* table =
        dot == std::string_view::npos ? &state_->root : state_->root.at_path(path.substr(0, dot)).as_table();
    const auto key = path.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (table == nullptr || !table->contains(key))
        return fail(text(state_->name, ": has no key '", path, "'"));
    const auto parsed = toml::parse(text("value = ", value));
    if (!parsed || parsed.table().size() != 1)
        return fail(text(state_->name, ": '", value, "' is no value for '", path, "'"));
    parsed.table().get("value")->visit([&](const auto& node) { table->insert_or_assign(key, node); });
    return {};
}

ConfigTable Config::root() const { return {state_, &state_->root}; }

void Config::report(std::string_view message) const { state_->report(nullptr, message); }

Expected<void> Config::check() const {
    if (!state_->fault) find_unknown(*state_, state_->root, "");
    if (state_->fault) return fail(*state_->fault);
    return {};
}

bool ConfigTable::has(std::string_view key) const {
    return table_ != nullptr && as_table(table_)->contains(key);
}

double ConfigTable::number(std::string_view key, Range range) const {
    if (!has(key)) report_missing(*state_, table_, key);
    return number(key, range, range.low);
}

double ConfigTable::number(std::string_view key, Range range, double fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : number_in(*state_, *node, key, range).value_or(fallback);
}

std::int64_t ConfigTable::integer(std::string_view key, Range range) const {
    if (!has(key)) report_missing(*state_, table_, key);
    return integer(key, range, low_end(range));
}

std::int64_t ConfigTable::integer(std::string_view key, Range range, std::int64_t fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : integer_in(*state_, *node, key, range).value_or(fallback);
}

bool ConfigTable::boolean(std::string_view key, bool fallback) const {
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return fallback;
    if (!node->is_boolean()) {
        state_->report(node, text("'", key, "' must be true or false"));
        return fallback;
    }
    return node->as_boolean()->get();
}

std::string ConfigTable::string(std::string_view key) const {
    if (!has(key)) report_missing(*state_, table_, key);
    return string(key, "");
}

std::string ConfigTable::string(std::string_view key, std::string fallback) const {
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return fallback;
    if (!node->is_string()) {
        state_->report(node, text("'", key, "' must be a text in quotes"));
        return fallback;
    }
    return node->as_string()->get();
}

vec3 ConfigTable::vector(std::string_view key, Range range) const {
    if (!has(key)) report_missing(*state_, table_, key);
    return vector(key, range, vec3(range.low));
}

vec3 ConfigTable::vector(std::string_view key, Range range, vec3 fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : vector_in(*state_, *node, key, range).value_or(fallback);
}

std::size_t ConfigTable::choice(std::string_view key, const std::vector<std::string_view>& names) const {
    if (!has(key)) report_missing(*state_, table_, key);
    return choice(key, names, 0);
}

std::size_t ConfigTable::choice(std::string_view key, const std::vector<std::string_view>& names,
                                std::size_t fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : choice_in(*state_, *node, key, names).value_or(fallback);
}

ConfigTable ConfigTable::table(std::string_view key) const {
    const auto* node = ask(*state_, table_, key);
    if (node != nullptr && !node->is_table()) state_->report(node, text("'", key, "' must be a table"));
    return {state_, node == nullptr ? nullptr : node->as_table()};
}

std::vector<ConfigTable> ConfigTable::tables(std::string_view key) const {
    std::vector<ConfigTable> result;
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return result;
    const auto* list = node->as_array();
    if (list == nullptr) {
        state_->report(node, text("'", key, "' must be a list of tables"));
        return result;
    }
    for (const auto& item : *list) {
        if (!item.is_table()) state_->report(&item, text("'", key, "' must be a list of tables"));
        if (item.is_table()) result.push_back({state_, item.as_table()});
    }
    return result;
}

std::vector<std::string> ConfigTable::keys() const {
    std::vector<std::string> result;
    if (table_ == nullptr) return result;
    for (const auto& [key, node] : *as_table(table_)) {
        state_->asked.insert(&node);
        result.emplace_back(key.str());
    }
    return result;
}

void ConfigTable::report(std::string_view key, std::string_view message) const {
    const auto* node = table_ == nullptr || key.empty() ? nullptr : as_table(table_)->get(key);
    state_->report(node != nullptr ? node : as_table(table_), message);
}

}  // namespace thaum
