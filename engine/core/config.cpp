#include "core/config.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "core/detail/config_state.h"
#include "core/detail/toml_hint.h"
#include "core/detail/toml_parse.h"
#include "core/hash.h"
#include "core/invisible.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/text.h"

namespace thaum {

using detail::ConfigFault;
using detail::FaultKind;

/// Greatest number of faults that are kept for one file. A nonsense file has a fault in every line, and
/// nobody reads them all.
constexpr std::size_t max_faults = 100;

namespace {

const toml::table* as_table(const void* table) { return static_cast<const toml::table*>(table); }

std::size_t line_of(const toml::node* node) {
    return node != nullptr && node->source().begin ? node->source().begin.line : 0;
}

/// Whether `node` is the table or list `outer` or lies within it.
bool is_within(const toml::node& outer, const toml::node* node);

template <class Children>
bool is_among(const Children& children, const toml::node* node) {
    return std::ranges::any_of(children, [&](const toml::node* child) { return is_within(*child, node); });
}

std::vector<const toml::node*> children_of(const toml::node& node) {
    std::vector<const toml::node*> children;
    if (const auto* table = node.as_table())
        for (const auto& [key, child] : *table) children.push_back(&child);
    if (const auto* list = node.as_array())
        for (const auto& child : *list) children.push_back(&child);
    return children;
}

bool is_within(const toml::node& outer, const toml::node* node) {
    return &outer == node || is_among(children_of(outer), node);
}

/// Returns the innermost table that holds a node, or null if none does.
const toml::table* holder_of(const toml::node& outer, const toml::node* node) {
    for (const auto* child : children_of(outer)) {
        if (!is_within(*child, node)) continue;
        const auto* inner = child == node ? nullptr : holder_of(*child, node);
        return inner != nullptr ? inner : outer.as_table();
    }
    return nullptr;
}

/// Keys from the outermost table down to `table`, such as "range.player".
std::string path_of(const toml::table& outer, const toml::table* table) {
    for (const auto& [key, node] : outer) {
        const auto* child = node.as_table();
        if (child == nullptr || !is_within(*child, table)) continue;
        return child == table ? std::string(key.str()) : text(key.str(), ".", path_of(*child, table));
    }
    return "";
}

/// Adds to `found` all keys of a table that no reader asked for. If such a key is a table, the keys in it are
/// not listed.
void find_unknown(const Config::State& state, const toml::table& table, const std::string& path,
                  std::vector<detail::UnknownKey>& found) {
    for (const auto& [key, node] : table) {
        if (found.size() >= max_faults) return;
        const auto full = path + std::string(key.str());
        if (!state.asked.contains(&node)) {
            found.push_back({&table, std::string(key.str()), full, line_of(&node)});
            continue;
        }
        if (const auto* child = node.as_table()) find_unknown(state, *child, full + ".", found);
        if (const auto* list = node.as_array()) {
            for (const auto& item : *list) {
                if (const auto* child = item.as_table()) find_unknown(state, *child, full + ".", found);
            }
        }
    }
}

/// Whether a reader found a wrong value in this table or below it. Later faults that the reader reports there
/// mean nothing, because it worked with a fallback value.
bool is_misread(const Config::State& state, const toml::node& table) {
    return std::ranges::any_of(state.faults, [&](const ConfigFault& fault) {
        return fault.kind != FaultKind::told && fault.table != nullptr &&
               is_within(table, static_cast<const toml::table*>(fault.table));
    });
}

}  // namespace

void Config::State::mark_asked(const toml::node& value) {
    for (const auto* child : children_of(value)) {
        asked.insert(child);
        mark_asked(*child);
    }
}

void Config::State::report(const toml::node* where, FaultKind kind, std::string_view key, std::string what,
                           bool misleads) {
    if (faults.size() >= max_faults) return;
    if (where != nullptr && kind == FaultKind::value) mark_asked(*where);
    const bool is_holder = where != nullptr && where->is_table() && kind != FaultKind::value;
    const auto* table = is_holder ? where->as_table() : holder_of(root, where);
    ConfigFault fault{kind, misleads, table, std::string(key), line_of(where), std::move(what)};
    if (std::ranges::find(faults, fault) == faults.end()) faults.push_back(std::move(fault));
}

namespace {

/// Serialises a value so that equal values give equal bytes. Each value is written as its kind, such as
/// number or text, then its content. Each text is preceded by its length.
class CanonicalForm {
public:
    void add(const toml::node& node) {
        if (const auto* table = node.as_table()) return add_table(*table);
        if (const auto* list = node.as_array()) return add_list(*list);
        if (const auto* word = node.as_string()) return add_text('s', word->get());
        if (const auto* flag = node.as_boolean()) return add_bits('b', flag->get() ? 1 : 0);
        if (const auto* whole = node.as_integer()) return add_whole(whole->get());
        if (const auto* real = node.as_floating_point())
            return add_bits('n', std::bit_cast<std::uint64_t>(real->get()));
        add_bits('d', 0);  // a date or time, which no reader accepts
    }

    /// Adds a table as if it had none of the keys in `without`.
    void add_table(const toml::table& table, std::span<const std::string_view> without = {}) {
        const auto left_out = [&](std::string_view key) {
            return std::find(without.begin(), without.end(), key) != without.end();
        };
        std::size_t size = 0;
        for (const auto& [key, node] : table) size += left_out(key.str()) ? 0 : 1;
        add_bits('t', size);
        for (const auto& [key, node] : table) {  // toml++ keeps the keys sorted
            if (left_out(key.str())) continue;
            add_text('k', key.str());
            add(node);
        }
    }

    std::uint64_t hash() const { return hash_bytes(std::as_bytes(std::span(bytes_.data(), bytes_.size()))); }

private:
    void add_list(const toml::array& list) {
        add_bits('l', list.size());
        for (const auto& node : list) add(node);
    }

    /// Hashes a whole number as a double if a double represents it exactly, since readers treat 1 and 1.0 as
    /// equal.
    void add_whole(std::int64_t value) {
        constexpr std::int64_t exact = std::int64_t{1} << 53;
        if (value < -exact || value > exact) return add_bits('i', static_cast<std::uint64_t>(value));
        add_bits('n', std::bit_cast<std::uint64_t>(static_cast<double>(value)));
    }

    void add_text(char kind, std::string_view words) {
        add_bits(kind, words.size());
        bytes_ += words;
    }

    void add_bits(char kind, std::uint64_t bits) {
        bytes_ += kind;
        for (int i = 0; i < 8; ++i) bytes_ += static_cast<char>((bits >> (8 * i)) & 0xffU);
    }

    std::string bytes_;
};

/// Words for a range: "from 0 to 10".
std::string range_text(Range range) {
    constexpr double huge = std::numeric_limits<double>::max();
    if (range.low <= -huge && range.high >= huge) return "finite";
    if (range.high >= huge) return text("at least ", range.low);
    if (range.low <= -huge) return text("at most ", range.high);
    return text("from ", range.low, " to ", range.high);
}

/// Words for a number in a range: "a number from 0 to 10".
std::string in_range_words(std::string_view what, Range range) {
    const auto limits = range_text(range);
    return limits == "finite" ? std::string(what) : text(what, limits.starts_with("at") ? ", " : " ", limits);
}

std::string listed(const std::vector<std::string_view>& names) {
    std::string all;
    for (const auto name : names) all += text(all.empty() ? "" : ", ", name);
    return all;
}

std::string invisible_words(std::string_view words) {
    const auto found = invisible_character(words);
    return found.empty() ? "" : text(" with ", found);
}

/// Describes a value of a wrong kind, and says how to make it a number.
std::string words_of(const toml::node& node) {
    constexpr std::size_t longest = 40;
    if (const auto* word = node.as_string())
        return text("the text \"", printable(word->get(), longest), "\"", detail::number_hint(word->get()),
                    invisible_words(word->get()));
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* whole = node.as_integer()) return text(whole->get());
    if (const auto* real = node.as_floating_point())
        return text(real->get(),
                    real->get() == std::floor(real->get()) && std::abs(real->get()) < 1e6 ? ".0" : "");
    if (const auto* list = node.as_array()) return text("a list of ", list->size());
    return node.is_table() ? "a table" : "a date or time";
}

/// The low end of a range as a whole number, used in place of a missing or faulty value; 0 if it does not fit
/// an integer.
std::int64_t low_end(Range range) {
    return range.low > -9e18 && range.low < 9e18 ? static_cast<std::int64_t>(range.low) : 0;
}

bool in_range(double value, Range range) { return value >= range.low && value <= range.high; }

/// Returns the value at a key of a table and marks the key as asked for by a reader. Returns null if the
/// table has no such key.
const toml::node* ask(Config::State& state, const void* table, std::string_view key) {
    if (table == nullptr) return nullptr;
    state.asked_keys[table].emplace(key);
    const auto* node = as_table(table)->get(key);
    if (node != nullptr) state.asked.insert(node);
    return node;
}

/// A nonzero quantity nearer to 0 than this is a typing mistake, and dividing by it gives infinities. Lists
/// and ranges with negative numbers are often computed, so they may hold any value.
constexpr double min_quantity = 1e-12;

std::optional<double> number_in(Config::State& state, const toml::node& node, std::string_view key,
                                Range range) {
    const auto value = node.value<double>();
    if (!value || !(node.is_integer() || node.is_floating_point())) {
        state.report(
            &node, FaultKind::value, key,
            text("'", key, "' must be ", in_range_words("a number", range), ", not ", words_of(node)));
        return std::nullopt;
    }
    if (!in_range(*value, range)) {  // NaN is outside every range
        state.report(&node, FaultKind::value, key,
                     text("'", key, "' is ", *value, ", must be ", range_text(range)));
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> integer_in(Config::State& state, const toml::node& node, std::string_view key,
                                       Range range) {
    if (!node.is_integer()) {
        state.report(
            &node, FaultKind::value, key,
            text("'", key, "' must be ", in_range_words("a whole number", range), ", not ", words_of(node)));
        return std::nullopt;
    }
    const auto value = node.as_integer()->get();
    if (!in_range(static_cast<double>(value), range)) {
        state.report(&node, FaultKind::value, key,
                     text("'", key, "' is ", value, ", must be ", range_text(range)));
        return std::nullopt;
    }
    return value;
}

std::optional<vec3> vector_in(Config::State& state, const toml::node& node, std::string_view key,
                              Range range) {
    const auto* list = node.as_array();
    if (list == nullptr || list->size() != 3) {
        const bool has_more = list != nullptr && list->size() > 3 && list->size() <= 6;
        state.report(&node, FaultKind::value, key,
                     text("'", key, "' must be three numbers, not ", words_of(node),
                          has_more ? "; a comma separates numbers, and a decimal point is '.'" : ""));
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

std::optional<std::vector<double>> numbers_in(Config::State& state, const toml::node& node,
                                              std::string_view key, Range range, std::size_t most) {
    const auto* list = node.as_array();
    if (list == nullptr || list->empty() || list->size() > most) {
        state.report(&node, FaultKind::value, key,
                     text("'", key, "' must be a list of 1 to ", most, " numbers, not ", words_of(node)));
        return std::nullopt;
    }
    std::vector<double> result;
    for (const auto& item : *list) {
        const auto value = number_in(state, item, key, range);
        if (!value) return std::nullopt;
        result.push_back(*value);
    }
    return result;
}

std::optional<std::size_t> choice_in(Config::State& state, const toml::node& node, std::string_view key,
                                     const std::vector<std::string_view>& names) {
    const auto value = node.value<std::string_view>();
    for (std::size_t i = 0; value && i < names.size(); ++i) {
        if (names[i] == *value) return i;
    }
    auto message = text("'", key, "' must be one of: ", listed(names), "; it is ", words_of(node));
    if (value) message += did_you_mean(*value, names);
    state.report(&node, FaultKind::value, key, std::move(message), true);
    return std::nullopt;
}

/// All faults of a file, including the keys that no reader asked for.
std::optional<Error> faults_of(const Config::State& state, std::span<const detail::UnknownKey> unknown) {
    return detail::told_faults(state.name, state.faults, {unknown.begin(), unknown.end()}, state.asked_keys);
}

/// Part of a message about a missing `version`: where the key stands below the header of a table, which makes
/// it a key of that table. Empty if it stands nowhere.
std::string place_of_version(const toml::table& root) {
    for (const auto& [key, node] : root) {
        const auto* table = node.as_table();
        const auto* version = table == nullptr ? nullptr : table->get("version");
        if (version != nullptr)
            return text("; line ", line_of(version), " has it in [", key.str(), "]: move it above");
    }
    return "";
}

}  // namespace

Expected<Config> Config::parse(std::string_view source, std::string name, std::int64_t version) {
    if (source.find_first_not_of(" \t\r\n") == source.npos)
        return fail(text(name, ":1: the file is empty; it begins with version = ", version));
    auto table = detail::parse_toml(source, name);
    if (!table) return table.error();
    auto state = std::make_shared<State>();
    state->root = std::move(*table);
    state->name = std::move(name);
    Config config(state);
    config.root().demand("version", text("version = ", version, place_of_version(state->root)));
    const auto found = config.root().integer("version", {0, 1e9}, version);
    if (state->faults.empty() && found != version) {
        config.root().report("version", text("version ", found, " cannot be read, only version ", version));
    }
    if (state->faults.empty()) return config;
    // No reader has asked for the other keys yet, so only a misspelt 'version' is known to be wrong.
    std::vector<detail::UnknownKey> unknown;
    find_unknown(*state, state->root, "", unknown);
    constexpr std::string_view version_key[] = {"version"};
    std::erase_if(unknown, [&](const auto& one) {
        return one.table != &state->root || near_name(one.key, version_key).empty();
    });
    return *faults_of(*state, unknown);
}

Expected<void> Config::replace(std::string_view path, std::string_view value) {
    const auto dot = path.rfind('.');
    auto* table =
        dot == std::string_view::npos ? &state_->root : state_->root.at_path(path.substr(0, dot)).as_table();
    const auto key = path.substr(dot == std::string_view::npos ? 0 : dot + 1);
    if (table == nullptr || !table->contains(key)) {
        std::vector<std::string_view> names;
        for (const auto& [name, node] : table == nullptr ? state_->root : *table) names.push_back(name.str());
        return fail(text(state_->name, ": has no key '", path, "'", did_you_mean(key, names)));
    }
    const auto parsed = toml::parse(text("value = ", value));
    if (!parsed || parsed.table().size() != 1)
        return fail(text(state_->name, ": '", value, "' is no value for '", path, "'"));
    parsed.table().get("value")->visit([&](const auto& node) { table->insert_or_assign(key, node); });
    return {};
}

ConfigTable Config::root() const { return {state_, &state_->root, &state_->root, ""}; }

void Config::report(std::string_view message) const {
    if (!is_misread(*state_, state_->root))
        state_->report(nullptr, FaultKind::told, "", std::string(message));
}

Expected<void> Config::check() const {
    std::vector<detail::UnknownKey> unknown;
    find_unknown(*state_, state_->root, "", unknown);
    if (auto error = faults_of(*state_, unknown)) return std::move(*error);
    return {};
}

bool Config::is_sound() const { return state_->faults.empty(); }

std::uint64_t Config::value_hash(std::span<const std::string_view> without) const {
    CanonicalForm form;
    form.add_table(state_->root, without);
    return form.hash();
}

bool ConfigTable::has(std::string_view key) const {
    if (table_ == nullptr) return false;
    state_->asked_keys[table_].emplace(key);
    return as_table(table_)->contains(key);
}

void ConfigTable::demand(std::string_view key, std::string_view allowed, bool misleads) const {
    if (has(key)) return;
    if (table_ != nullptr) {
        state_->report(as_table(table_), FaultKind::missing, key,
                       text("key '", key, "' is missing: ", allowed), misleads);
        return;
    }
    const auto first = path_.substr(0, path_.find('.'));
    // The key of the table exists but holds another value, which has been reported already.
    if (as_table(holder_)->contains(first)) return;
    const auto path = path_of(state_->root, as_table(holder_));
    state_->report(as_table(holder_), FaultKind::missing, first,
                   text("table '", path.empty() ? "" : text(path, "."), path_, "' is missing"));
}

double ConfigTable::number(std::string_view key, Range range) const {
    demand(key, in_range_words("a number", range));
    return number(key, range, range.low);
}

double ConfigTable::number(std::string_view key, Range range, double fallback) const {
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return fallback;
    const auto value = number_in(*state_, *node, key, range);
    if (value && range.low >= 0 && *value > 0 && *value < min_quantity) {
        state_->report(node, FaultKind::value, key,
                       text("'", key, "' is ", *value, ", must be 0 or at least ", min_quantity, ", ",
                            range_text(range)));
        return fallback;
    }
    return value.value_or(fallback);
}

std::int64_t ConfigTable::integer(std::string_view key, Range range) const {
    demand(key, in_range_words("a whole number", range));
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
        state_->report(node, FaultKind::value, key,
                       text("'", key, "' must be true or false, not ", words_of(*node)));
        return fallback;
    }
    return node->as_boolean()->get();
}

std::string ConfigTable::string(std::string_view key) const {
    demand(key, "a text in quotes", true);
    return string(key, "");
}

std::string ConfigTable::string(std::string_view key, std::string fallback) const {
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return fallback;
    if (!node->is_string()) {
        state_->report(node, FaultKind::value, key,
                       text("'", key, "' must be a text in quotes, not ", words_of(*node)), true);
        return fallback;
    }
    return node->as_string()->get();
}

vec3 ConfigTable::vector(std::string_view key, Range range) const {
    demand(key, in_range_words("three numbers", range));
    return vector(key, range, vec3(range.low));
}

vec3 ConfigTable::vector(std::string_view key, Range range, vec3 fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : vector_in(*state_, *node, key, range).value_or(fallback);
}

std::vector<double> ConfigTable::numbers(std::string_view key, Range range, std::size_t most,
                                         const std::vector<double>& fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : numbers_in(*state_, *node, key, range, most).value_or(fallback);
}

std::size_t ConfigTable::choice(std::string_view key, const std::vector<std::string_view>& names) const {
    demand(key, text("one of: ", listed(names)), true);
    return choice(key, names, 0);
}

std::size_t ConfigTable::choice(std::string_view key, const std::vector<std::string_view>& names,
                                std::size_t fallback) const {
    const auto* node = ask(*state_, table_, key);
    return node == nullptr ? fallback : choice_in(*state_, *node, key, names).value_or(fallback);
}

std::optional<std::uint32_t> ConfigTable::hex_colour(std::string_view key) const {
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr || !node->is_string()) return std::nullopt;
    const auto& words = node->as_string()->get();
    const auto colour = detail::parse_colour(words);
    if (!colour)
        state_->report(node, FaultKind::value, key,
                       text("'", key, "' must be a colour \"#RRGGBB\", not ", words_of(*node)));
    return colour.value_or(0);
}

ConfigTable ConfigTable::table(std::string_view key) const {
    const auto* node = ask(*state_, table_, key);
    if (node != nullptr && !node->is_table())
        state_->report(node, FaultKind::value, key,
                       text("'", key, "' must be a table, [", key, "], not ", words_of(*node)), true);
    if (node != nullptr && node->is_table()) return {state_, node, node, ""};
    return {state_, nullptr, holder_, path_.empty() ? std::string(key) : text(path_, ".", key)};
}

std::vector<ConfigTable> ConfigTable::tables(std::string_view key) const {
    std::vector<ConfigTable> result;
    const auto* node = ask(*state_, table_, key);
    if (node == nullptr) return result;
    const auto wrong = [&](const toml::node& at) {
        state_->report(&at, FaultKind::value, key,
                       text("'", key, "' must be a list of tables, [[", key, "]], not ", words_of(*node)));
    };
    const auto* list = node->as_array();
    if (list == nullptr) {
        wrong(*node);
        return result;
    }
    for (const auto& item : *list) {
        if (item.is_table())
            result.push_back({state_, &item, &item, ""});
        else
            wrong(item);
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
    const auto* table = as_table(table_ != nullptr ? table_ : holder_);
    if (is_misread(*state_, *table)) return;
    const auto* node = table_ == nullptr || key.empty() ? nullptr : table->get(key);
    state_->report(node != nullptr ? node : table, FaultKind::told, key, std::string(message));
}

std::string ConfigTable::place(std::string_view key) const {
    const auto* table = as_table(table_ != nullptr ? table_ : holder_);
    const auto* node = table->get(key);
    return text(state_->name, ":", line_of(node != nullptr ? node : table));
}

}  // namespace thaum
