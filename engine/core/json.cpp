#include "core/json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "core/assert.h"
#include "core/text.h"

namespace thaum {

// ---- members ----------------------------------------------------------------------------------------------

JsonMember::JsonMember(std::string_view name, Json content) : key(name), value(std::move(content)) {}
JsonMember::JsonMember(const JsonMember& other) = default;
JsonMember::JsonMember(JsonMember&& other) noexcept = default;
JsonMember::~JsonMember() = default;

JsonMember& JsonMember::operator=(JsonMember other) noexcept {
    key.swap(other.key);
    value = std::move(other.value);
    return *this;
}

namespace {

/// Indices of an object's members, sorted by key; members with equal keys keep their order.
std::vector<std::size_t> order_of_keys(std::span<const JsonMember> members) {
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return members[a].key < members[b].key; });
    return order;
}

/// Merges members with equal keys: the first gives the place and the last the value. They are found by
/// sorting, because comparing all pairs takes minutes for a hostile file.
std::vector<JsonMember> without_equal_keys(std::vector<JsonMember> members) {
    const auto order = order_of_keys(members);
    std::vector<bool> kept(members.size(), true);
    for (std::size_t i = order.size(); i-- > 1;) {
        auto &earlier = members[order[i - 1]], &later = members[order[i]];
        if (earlier.key != later.key) continue;
        earlier.value = std::move(later.value);
        kept[order[i]] = false;
    }
    if (std::find(kept.begin(), kept.end(), false) == kept.end()) return members;
    std::vector<JsonMember> result;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (kept[i]) result.push_back(std::move(members[i]));
    }
    return result;
}

}  // namespace

// ---- values -----------------------------------------------------------------------------------------------

Json::Json(bool value) noexcept : kind_(Kind::boolean) { content_.boolean = value; }
Json::Json(long long value) noexcept : kind_(Kind::integer) { content_.integer = value; }
Json::Json(unsigned long long value) noexcept : kind_(Kind::unsigned_integer) {
    content_.unsigned_integer = value;
}
Json::Json(double value) noexcept : kind_(Kind::real) { content_.real = value; }
Json::Json(std::string value) : kind_(Kind::string) { content_.string = new std::string(std::move(value)); }
Json::Json(std::string_view value) : Json(std::string(value)) {}
Json::Json(const char* value) : Json(std::string(value)) {}
Json::Json(const std::vector<std::string>& values)
    : Json(array(std::vector<Json>(values.begin(), values.end()))) {}
Json::Json(const std::vector<std::uint64_t>& values)
    : Json(array(std::vector<Json>(values.begin(), values.end()))) {}
Json::Json(std::initializer_list<JsonMember> members) : Json(object(std::vector<JsonMember>(members))) {}

Json::Json(const Json& other) {
    switch (other.kind_) {
        case Kind::string: content_.string = new std::string(*other.content_.string); break;
        case Kind::array: content_.array = new std::vector<Json>(*other.content_.array); break;
        case Kind::object: content_.object = new std::vector<JsonMember>(*other.content_.object); break;
        default: content_ = other.content_;
    }
    kind_ = other.kind_;
}

Json::Json(Json&& other) noexcept
    : kind_(std::exchange(other.kind_, Kind::null)), content_(std::exchange(other.content_, {})) {}

Json& Json::operator=(Json other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(content_, other.content_);
    return *this;
}

/// Moves the arrays and objects among the elements of this value to the end of a list.
void Json::move_nested(std::vector<Json>& to) {
    const auto move = [&](Json& value) {
        if (value.is_array() || value.is_object()) to.push_back(std::move(value));
    };
    if (is_array()) std::for_each(content_.array->begin(), content_.array->end(), move);
    if (is_object()) {
        for (auto& member : *content_.object) move(member.value);
    }
}

/// A file may be nested a million times, too deep for destructors that call each other. So nested values are
/// first moved out of their parents, level by level.
Json::~Json() {
    if (is_array() || is_object()) {
        std::vector<Json> nested;
        move_nested(nested);
        while (!nested.empty()) {
            Json last = std::move(nested.back());
            nested.pop_back();
            last.move_nested(nested);
        }
    }
    if (is_string()) delete content_.string;
    if (is_array()) delete content_.array;
    if (is_object()) delete content_.object;
}

Json Json::array(std::initializer_list<Json> elements) { return array(std::vector<Json>(elements)); }

Json Json::array(std::vector<Json> elements) {
    Json result;
    result.content_.array = new std::vector<Json>(std::move(elements));
    result.kind_ = Kind::array;
    return result;
}

Json Json::object() { return object(std::vector<JsonMember>()); }

Json Json::object(std::vector<JsonMember> members) {
    Json result;
    result.content_.object = new std::vector<JsonMember>(without_equal_keys(std::move(members)));
    result.kind_ = Kind::object;
    return result;
}

void Json::push_back(Json value) {
    if (is_null()) *this = array();
    THAUM_ASSERT(is_array(), "an element was added to a value of JSON that is no array");
    content_.array->push_back(std::move(value));
}

void Json::set(std::string_view key, Json value) {
    if (is_null()) *this = object();
    THAUM_ASSERT(is_object(), "a member was added to a value of JSON that is no object");
    auto& members = *content_.object;
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const JsonMember& member) { return member.key == key; });
    if (found == members.end()) {
        members.emplace_back(key, std::move(value));
    } else {
        found->value = std::move(value);
    }
}

bool Json::boolean() const { return is_boolean() && content_.boolean; }

double Json::number() const {
    switch (kind_) {
        case Kind::integer: return static_cast<double>(content_.integer);
        case Kind::unsigned_integer: return static_cast<double>(content_.unsigned_integer);
        case Kind::real: return content_.real;
        default: return 0;
    }
}

std::int64_t Json::integer() const {
    if (is_unsigned()) return static_cast<std::int64_t>(content_.unsigned_integer);
    return kind_ == Kind::integer ? content_.integer : 0;
}

std::uint64_t Json::unsigned_integer() const { return is_unsigned() ? content_.unsigned_integer : 0; }

const std::string& Json::string() const {
    static const std::string none;
    return is_string() ? *content_.string : none;
}

std::span<const Json> Json::elements() const {
    return is_array() ? std::span<const Json>(*content_.array) : std::span<const Json>();
}

std::span<const JsonMember> Json::members() const {
    return is_object() ? std::span<const JsonMember>(*content_.object) : std::span<const JsonMember>();
}

const Json* Json::find(std::string_view key) const {
    for (const auto& member : members()) {
        if (member.key == key) return &member.value;
    }
    return nullptr;
}

namespace {

using Library = nlohmann::ordered_json;  // keeps the order of members

// ---- reading ----------------------------------------------------------------------------------------------

/// Builds a value from what the library's parser reports. The parser stops when a function returns false.
class Builder {
public:
    Json result;
    std::string fault;  ///< what is wrong with the text, for the error

    explicit Builder(std::string_view source) : source_(source) {}

    bool null() { return add({}); }
    bool boolean(bool value) { return add(value); }
    bool number_integer(std::int64_t value) { return add(value); }
    bool number_unsigned(std::uint64_t value) { return add(value); }
    bool number_float(double value, const std::string& /*digits*/) { return add(value); }
    bool string(std::string& value) { return add(std::move(value)); }
    bool binary(Library::binary_t& /*value*/) { return false; }  // JSON text has no binary values
    bool start_array(std::size_t /*size*/) { return open(); }
    bool start_object(std::size_t /*size*/) { return open(); }
    bool key(std::string& name) {
        open_.back().members.emplace_back(name, Json());
        return true;
    }
    bool end_array() { return add(Json::array(take_last().elements)); }
    bool end_object() { return add(Json::object(take_last().members)); }
    bool parse_error(std::size_t byte, const std::string& /*token*/, const Library::exception& error) {
        constexpr int number_overflow = 406;
        fault = error.id == number_overflow ? "is not JSON: a number is too large"
                                            : text("is not JSON from byte ", byte, " on", place_of(byte));
        return false;
    }

private:
    /// An array or object whose end has not been read yet.
    struct Open {
        std::vector<Json> elements{};
        std::vector<JsonMember> members{};  ///< members read so far; the last one still lacks its value
    };

    bool open() {
        open_.emplace_back();
        return true;
    }
    Open take_last() {
        auto last = std::move(open_.back());
        open_.pop_back();
        return last;
    }
    bool add(Json value) {
        if (open_.empty()) {
            result = std::move(value);
        } else if (!open_.back().members.empty()) {
            open_.back().members.back().value = std::move(value);
        } else {
            open_.back().elements.push_back(std::move(value));
        }
        return true;
    }

    /// Words for the place of a byte (counted from 1), such as ", in line 3, column 5".
    std::string place_of(std::size_t byte) const {
        if (byte > source_.size()) return ": it ends before all brackets and quotes are closed";
        const auto before = source_.substr(0, byte - 1);
        const auto line = 1 + std::ranges::count(before, '\n');
        return text(", in line ", line, ", column ", before.size() - (before.rfind('\n') + 1) + 1);
    }

    std::string_view source_;
    std::vector<Open> open_;
};

// ---- writing ----------------------------------------------------------------------------------------------

Library in_library(const Json& json) {
    switch (json.kind()) {
        case Json::Kind::null: break;
        case Json::Kind::boolean: return json.boolean();
        case Json::Kind::integer: return json.integer();
        case Json::Kind::unsigned_integer: return json.unsigned_integer();
        case Json::Kind::real: return json.number();
        case Json::Kind::string: return json.string();
        case Json::Kind::array: {
            auto list = Library::array();
            for (const auto& element : json.elements()) list.push_back(in_library(element));
            return list;
        }
        case Json::Kind::object: {
            Library::object_t members;  // a vector, so members are added without searching for their key
            for (const auto& [key, value] : json.members()) members.emplace_back(key, in_library(value));
            return members;
        }
    }
    return nullptr;
}

}  // namespace

Expected<Json> parse_json(std::string_view source) {
    Builder builder(source);
    if (!Library::sax_parse(source, &builder)) return fail(std::move(builder.fault));
    return std::move(builder.result);
}

std::string dump(const Json& json, int indent) {
    return in_library(json).dump(indent, ' ', false, Library::error_handler_t::replace);
}

}  // namespace thaum
