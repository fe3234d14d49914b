// core/json.h: values of JSON, read from text and written as text.
//
// A library reads and writes the text, but only json.cpp includes that library, because its header takes
// seconds to compile.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace thaum {

struct JsonMember;

/// Any value of JSON. An object keeps the order of its members.
///
/// Any value may appear anywhere in a file, so no read fails: a value that is of another kind than asked for
/// gives false, 0, "" or no elements. Copying works by recursion, so copy only values that the program made
/// itself, which are not deeply nested.
class Json {
public:
    /// Kind of a value. A whole number is `unsigned_integer` if it was read without a sign or made from an
    /// unsigned type, otherwise `integer`.
    enum class Kind : std::uint8_t { null, boolean, integer, unsigned_integer, real, string, array, object };

    Json() noexcept = default;  ///< the value null
    Json(bool value) noexcept;
    Json(long long value) noexcept;
    Json(unsigned long long value) noexcept;
    Json(int value) noexcept : Json(static_cast<long long>(value)) {}
    Json(long value) noexcept : Json(static_cast<long long>(value)) {}
    Json(unsigned value) noexcept : Json(static_cast<unsigned long long>(value)) {}
    Json(unsigned long value) noexcept : Json(static_cast<unsigned long long>(value)) {}
    Json(double value) noexcept;  ///< a number; written as null if it is not finite
    Json(std::string value);
    Json(std::string_view value);
    Json(const char* value);
    Json(const std::vector<std::string>& values);    ///< an array
    Json(const std::vector<std::uint64_t>& values);  ///< an array
    /// An object: {{"name", "a"}, {"count", 3}}.
    Json(std::initializer_list<JsonMember> members);

    Json(const Json& other);
    Json(Json&& other) noexcept;
    Json& operator=(Json other) noexcept;
    ~Json();

    /// An array: array({1, "two"}).
    static Json array(std::initializer_list<Json> elements = {});
    /// An array of these elements.
    static Json array(std::vector<Json> elements);
    /// An empty object.
    static Json object();
    /// Makes an object. Where members have the same key, the first gives the place and the last the value.
    static Json object(std::vector<JsonMember> members);

    /// Adds an element to an array. Null becomes an array.
    void push_back(Json value);
    /// Adds a member to an object, or replaces its value. Null becomes an object.
    void set(std::string_view key, Json value);

    /// Kind of the value.
    Kind kind() const { return kind_; }
    /// @{
    /// Whether the value is of this kind; `is_number` is true of all three kinds of numbers.
    bool is_null() const { return kind_ == Kind::null; }
    bool is_boolean() const { return kind_ == Kind::boolean; }
    bool is_number() const { return is_integer() || kind_ == Kind::real; }
    bool is_integer() const { return kind_ == Kind::integer || is_unsigned(); }
    /// True for a whole number that was read without a sign, or made from an unsigned type.
    bool is_unsigned() const { return kind_ == Kind::unsigned_integer; }
    bool is_string() const { return kind_ == Kind::string; }
    bool is_array() const { return kind_ == Kind::array; }
    bool is_object() const { return kind_ == Kind::object; }
    /// @}

    /// @{
    /// The content of the value; false, 0, "" or no elements if the value is of another kind.
    bool boolean() const;
    double number() const;                   ///< value of any number
    std::int64_t integer() const;            ///< a whole number; one that is too large wraps around
    std::uint64_t unsigned_integer() const;  ///< value of a number for which is_unsigned() holds
    const std::string& string() const;
    std::span<const Json> elements() const;
    std::span<const JsonMember> members() const;
    /// @}
    /// The value of a member; null if this is no object or has no such member.
    const Json* find(std::string_view key) const;

private:
    union Content {
        std::uint64_t unsigned_integer = 0;
        std::int64_t integer;
        bool boolean;
        double real;
        std::string* string;
        std::vector<Json>* array;
        std::vector<JsonMember>* object;
    };

    void move_nested(std::vector<Json>& to);

    Kind kind_ = Kind::null;
    Content content_{};
};

/// One member of a JSON object: a key and its value.
struct JsonMember {
    JsonMember(std::string_view key, Json value);
    JsonMember(const JsonMember& other);
    JsonMember(JsonMember&& other) noexcept;
    JsonMember& operator=(JsonMember other) noexcept;
    ~JsonMember();

    std::string key;
    Json value;
};

/// Reads a text that is one value of JSON, nested to any depth. If several members have the same key, the
/// last one gives the value. The error says what is wrong with the text, without naming it: "is not JSON from
/// byte 12 on".
Expected<Json> parse_json(std::string_view source);

/// Writes a value as text, with `indent` spaces for each level; in one line if it is negative. Numbers take
/// the shortest form that reads back to the same value, and bytes that are not UTF-8 become U+FFFD. It works
/// by recursion, so write only values that the program made itself, which are not deeply nested.
std::string dump(const Json& json, int indent = -1);

}  // namespace thaum
