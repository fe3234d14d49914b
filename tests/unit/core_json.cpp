// Tests of JSON values. Reading and writing are compared with the JSON library itself, on chosen and on
// generated documents.
#include "core/json.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/random.h"
#include "core/text.h"

namespace thaum {
namespace {

using Oracle = nlohmann::ordered_json;

std::string dump_of(const Oracle& json, int indent = -1) {
    return json.dump(indent, ' ', false, Oracle::error_handler_t::replace);
}

/// Reads a text and writes it again. Returns the result, or the error for a text that cannot be read,
/// including the byte.
std::string reread(std::string_view source) {
    constexpr std::string_view end_of_byte = " on";
    const auto json = parse_json(source);
    if (json) return dump(*json);
    const auto& fault = json.error().message;
    return fault.substr(
        0, std::min(fault.find(end_of_byte), fault.size() - end_of_byte.size()) + end_of_byte.size());
}

std::string fault_of(std::string_view source) { return parse_json(source).error().message; }

/// Reads a text and writes it again by the library itself, for comparison.
std::string reread_by_oracle(std::string_view source) {
    try {
        return dump_of(Oracle::parse(source));
    } catch (const Oracle::parse_error& error) {
        return text("is not JSON from byte ", error.byte, " on");
    } catch (const Oracle::out_of_range&) {
        return "is not JSON: a number is too large";
    }
}

TEST(CoreJson, KeepsWhatItIsGiven) {
    const Json json{{"none", Json()},
                    {"yes", true},
                    {"whole", -3},
                    {"long", std::int64_t{1} << 60},
                    {"unsigned", ~std::uint64_t{0}},
                    {"real", 0.25},
                    {"letters", "abc"},
                    {"view", std::string_view("view")},
                    {"string", std::string("string")},
                    {"list", Json::array({1, "two", Json::array()})},
                    {"words", std::vector<std::string>{"a", "b"}},
                    {"counts", std::vector<std::uint64_t>{1, 2}},
                    {"empty", Json::object()},
                    {"nested", {{"only", 1}}}};
    EXPECT_EQ(
        dump(json),
        R"({"none":null,"yes":true,"whole":-3,"long":1152921504606846976,"unsigned":18446744073709551615,)"
        R"("real":0.25,"letters":"abc","view":"view","string":"string","list":[1,"two",[]],)"
        R"("words":["a","b"],"counts":[1,2],"empty":{},"nested":{"only":1}})");
    EXPECT_EQ(reread(dump(json)), dump(json));
}

TEST(CoreJson, IndentsByLevel) {
    const Json json{{"a", Json::array({1, 2})}, {"b", Json::object()}, {"c", Json::array()}};
    EXPECT_EQ(dump(json, 1), "{\n \"a\": [\n  1,\n  2\n ],\n \"b\": {},\n \"c\": []\n}");
    EXPECT_EQ(dump(json, 0), "{\n\"a\": [\n1,\n2\n],\n\"b\": {},\n\"c\": []\n}");
}

TEST(CoreJson, KeepsTheOrderOfMembers) {
    auto json = Json::object();
    for (const auto* key : {"z", "a", "m", "a", ""}) json.set(key, key);
    json.set("z", 2);
    EXPECT_EQ(dump(json), R"({"z":2,"a":"a","m":"m","":""})");
    EXPECT_EQ(dump(Json{{"b", 1}, {"a", 2}, {"b", 3}}), R"({"b":3,"a":2})");
    EXPECT_EQ(reread(R"({"b":1,"a":2,"c":{"d":1,"d":2},"b":3,"a":[4],"b":{}})"),
              R"({"b":{},"a":[4],"c":{"d":2}})");
}

TEST(CoreJson, BecomesAnArrayOrAnObjectIfItIsNull) {
    Json list, object;
    list.push_back(1);
    list.push_back({{"a", 1}});
    object.set("a", Json::array({2}));
    EXPECT_EQ(dump(list), R"([1,{"a":1}])");
    EXPECT_EQ(dump(object), R"({"a":[2]})");
}

TEST(CoreJsonDeathTest, RefusesElementsAndMembersOfOtherValues) {
    EXPECT_DEATH(Json(1).push_back(2), "no array");
    EXPECT_DEATH(Json::array().set("a", 2), "no object");
}

TEST(CoreJson, CopiesAndMovesWhole) {
    Json first{{"a", Json::array({1, "a long text that is no part of the string itself"})}};
    const auto written = dump(first);
    Json second = first;
    first.set("a", 0);
    EXPECT_EQ(dump(second), written);
    const Json third = std::move(second);
    EXPECT_EQ(dump(third), written);
    first = third;
    EXPECT_EQ(dump(first), written);
    first = Json();
    EXPECT_TRUE(first.is_null());
    first = Json{{"b", third}};
    first = *first.find("b");  // assigns a part of a value to that value
    EXPECT_EQ(dump(first), written);
}

TEST(CoreJson, AnswersWithNothingIfItIsOfAnotherKind) {
    const auto all = parse_json(R"([null, true, -1, 1, 1.5, "1", [1], {"a": 1}])").value();
    const auto e = all.elements();
    ASSERT_EQ(e.size(), 8U);
    for (std::size_t i = 0; i < e.size(); ++i) {
        EXPECT_EQ(e[i].is_null(), i == 0);
        EXPECT_EQ(e[i].is_boolean(), i == 1);
        EXPECT_EQ(e[i].is_integer(), i == 2 || i == 3);
        EXPECT_EQ(e[i].is_unsigned(), i == 3);
        EXPECT_EQ(e[i].is_number(), i >= 2 && i <= 4);
        EXPECT_EQ(e[i].is_string(), i == 5);
        EXPECT_EQ(e[i].is_array(), i == 6);
        EXPECT_EQ(e[i].is_object(), i == 7);
        EXPECT_EQ(e[i].boolean(), i == 1);
        EXPECT_EQ(e[i].integer(), i == 2 ? -1 : i == 3 ? 1 : 0);
        EXPECT_EQ(e[i].unsigned_integer(), i == 3 ? 1U : 0U);
        EXPECT_EQ(e[i].number(), i == 2 ? -1 : i == 3 ? 1 : i == 4 ? 1.5 : 0);
        EXPECT_EQ(e[i].string(), i == 5 ? "1" : "");
        EXPECT_EQ(e[i].elements().size(), i == 6 ? 1U : 0U);
        EXPECT_EQ(e[i].members().size(), i == 7 ? 1U : 0U);
        EXPECT_EQ(e[i].find("a") != nullptr, i == 7);
        EXPECT_EQ(e[i].find("b"), nullptr);
    }
}

TEST(CoreJson, WritesTextAsTheLibraryDoes) {
    std::string all;
    for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
    for (const std::string& words :
         {std::string("\"\\/\b\f\n\r\t\x01\x1f\x7f"), std::string("h\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"),
          std::string("cut \xe2\x82"), std::string("\xff\xfe over\xc0\xaflong \xed\xa0\x80"),
          std::string("a\0b", 3), all}) {
        EXPECT_EQ(dump(Json(words)), dump_of(Oracle(words)));
        EXPECT_EQ(dump(Json{{words, words}}), dump_of(Oracle{{words, words}}));
    }
    EXPECT_EQ(dump(Json("a\xff")), "\"a\xef\xbf\xbd\"");
    EXPECT_EQ(reread(R"("\u0041\u00e9\ud83d\ude00\n\/")"), "\"A\xc3\xa9\xf0\x9f\x98\x80\\n/\"");
}

TEST(CoreJson, WritesNumbersAsTheLibraryDoes) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value :
         {0.0, -0.0, 1.0, 0.1, 1.0 / 3, 1e15, 1e16, 123456789012345680.0, 1e22, 1e-5, 5e-324,
          std::numeric_limits<double>::max(), infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(dump(Json(value)), dump_of(Oracle(value)));
    Random random{1};
    for (int i = 0; i < 5000; ++i) {
        const auto bits = random.below(~std::uint64_t{0});
        const auto real = std::bit_cast<double>(bits);
        EXPECT_EQ(dump(Json(real)), dump_of(Oracle(real)));
        EXPECT_EQ(dump(Json(bits)), text(bits));
        EXPECT_EQ(dump(Json(static_cast<std::int64_t>(bits))), text(static_cast<std::int64_t>(bits)));
    }
    EXPECT_EQ(dump(Json(std::numeric_limits<double>::quiet_NaN())), "null");
    EXPECT_EQ(dump(Json(1.0)), "1.0");
}

TEST(CoreJson, ReadsNumbersWithoutLoss) {
    for (const std::string_view whole :
         {"0", "-1", "9007199254740993", "-9007199254740993", "9223372036854775807", "-9223372036854775808",
          "18446744073709551615"})
        EXPECT_EQ(reread(whole), whole);
    EXPECT_EQ(parse_json("9007199254740993")->integer(), 9007199254740993);
    EXPECT_EQ(parse_json("18446744073709551615")->unsigned_integer(), ~std::uint64_t{0});
    EXPECT_EQ(parse_json("18446744073709551615")->integer(), -1);
    EXPECT_EQ(parse_json("18446744073709551616")->number(), 18446744073709551616.0);
    EXPECT_EQ(parse_json("18446744073709551616")->kind(), Json::Kind::real);
    EXPECT_EQ(parse_json("-9223372036854775809")->kind(), Json::Kind::real);
    EXPECT_EQ(parse_json("-0")->kind(), Json::Kind::integer);
    EXPECT_EQ(parse_json("1e2")->kind(), Json::Kind::real);
    EXPECT_EQ(parse_json("1e-400")->number(), 0);
}

TEST(CoreJson, SaysWhereATextIsWrong) {
    EXPECT_EQ(fault_of(""), "is not JSON from byte 1 on: it ends before all brackets and quotes are closed");
    EXPECT_EQ(fault_of("{\"a\": tru}"), "is not JSON from byte 10 on, in line 1, column 10");
    EXPECT_EQ(fault_of("{\n \"a\": 1,\n}"), "is not JSON from byte 12 on, in line 3, column 1");
    EXPECT_EQ(reread("[1e999]"), "is not JSON: a number is too large");
    for (const std::string_view wrong :
         {" ",        "[",     "]",      "[1,]", "[1 2]",  "{",       "{\"a\"}",     "{\"a\":}", "{\"a\":1,}",
          "{1:2}",    "{a:1}", "'a'",    "\"a",  "\"\n\"", "\"\\x\"", "\"\\ud800\"", "\"\xff\"", "NaN",
          "Infinity", "-",     "+1",     "01",   "1.",     ".5",      "1e",          "-1e999",   "[1e999",
          "1 1",      "// 1",  "1 // 1", "[1]]", "nul",    "True",    "\xef\xbb",    "[\xff]"}) {
        EXPECT_FALSE(parse_json(wrong).has_value()) << wrong;
        EXPECT_EQ(reread(wrong), reread_by_oracle(wrong)) << wrong;
    }
    for (const std::string_view right : {" 1 ", "\xef\xbb\xbf[1]", "\"\x7f\"", "[\t1\r\n]", "-0.0", "1E+2"})
        EXPECT_EQ(reread(right), reread_by_oracle(right));
    EXPECT_EQ(reread(std::string_view("[]\0x", 4)), reread_by_oracle(std::string_view("[]\0x", 4)));
}

TEST(CoreJson, ReadsAnyDepth) {
    constexpr std::size_t deep = 300'000;
    const auto lists = parse_json(std::string(deep, '[') + std::string(deep, ']')).value();
    const Json* at = &lists;
    std::size_t depth = 1;
    for (; !at->elements().empty(); ++depth) at = &at->elements()[0];
    EXPECT_EQ(depth, deep);
    std::string objects;
    for (int i = 0; i < 30'000; ++i) objects += R"({"a":[0,)";
    EXPECT_FALSE(parse_json(objects).has_value());
    objects += "1";
    for (int i = 0; i < 30'000; ++i) objects += "]}";
    EXPECT_TRUE(parse_json(objects).has_value());
    const auto shallow = std::string(500, '[') + std::string(500, ']');
    EXPECT_EQ(reread(shallow), shallow);
}

TEST(CoreJson, ReadsManyMembersInLittleTime) {
    std::string source = "{";
    for (int i = 0; i < 120'000; ++i) source += text(i == 0 ? "" : ",", "\"", i % 100'000, "\":", i);
    const auto json = parse_json(source + "}");
    ASSERT_TRUE(json.has_value());
    ASSERT_EQ(json->members().size(), 100'000U);
    EXPECT_EQ(json->members()[0].key, "0");
    EXPECT_EQ(json->members()[0].value.integer(), 100'000);
    EXPECT_EQ(json->members()[99'999].value.integer(), 99'999);
}

// ---- generated documents ----------------------------------------------------------------------------------

struct Both {
    Json ours;
    Oracle theirs;
};

std::string some_text(Random& random) {
    std::string out;
    for (auto n = random.below(6); n > 0; --n) {
        constexpr std::string_view usual = "ab\"\\/\n\xc3\xa9";
        out += random.below(4) > 0 ? usual[random.below(usual.size())] : static_cast<char>(random.below(256));
    }
    return out;
}

template <class T>
Both same(const T& value) {
    return {Json(value), Oracle(value)};
}

Both some_scalar(Random& random) {
    switch (random.below(6)) {
        case 0: return {};
        case 1: return same(random.below(2) == 0);
        case 2: return same(static_cast<std::int64_t>(random.below(~std::uint64_t{0})) >> random.below(64));
        case 3: return same(random.below(~std::uint64_t{0}) >> random.below(64));
        case 4: return same(std::bit_cast<double>(random.below(~std::uint64_t{0})));
        default: return same(some_text(random));
    }
}

Both some_value(Random& random, int depth) {
    if (depth == 0 || random.below(3) == 0) return some_scalar(random);
    if (random.below(2) == 0) {
        Both list{Json::array(), Oracle::array()};
        for (auto n = random.below(5); n > 0; --n) {
            auto value = some_value(random, depth - 1);
            list.ours.push_back(std::move(value.ours));
            list.theirs.push_back(std::move(value.theirs));
        }
        return list;
    }
    Both object{Json::object(), Oracle::object()};
    for (auto n = random.below(5); n > 0; --n) {
        const auto key = some_text(random);
        auto value = some_value(random, depth - 1);
        object.ours.set(key, std::move(value.ours));
        object.theirs[key] = std::move(value.theirs);
    }
    return object;
}

TEST(CoreJson, WritesGeneratedValuesAsTheLibraryDoes) {
    Random random{2};
    for (int i = 0; i < 1000; ++i) {
        const auto value = some_value(random, 5);
        for (const int indent : {-1, 0, 2}) {
            ASSERT_EQ(dump(value.ours, indent), dump_of(value.theirs, indent));
        }
        const auto copy = value.ours;
        ASSERT_EQ(dump(copy), dump_of(value.theirs));
        ASSERT_EQ(reread(dump(copy)), reread_by_oracle(dump(copy)));
    }
}

/// A text in which a few bytes were changed, removed or doubled.
std::string damaged(std::string source, Random& random) {
    for (auto n = 1 + random.below(3); n > 0 && !source.empty(); --n) {
        const auto at = static_cast<std::size_t>(random.below(source.size()));
        const auto length = 1 + static_cast<std::size_t>(random.below(8));
        constexpr std::string_view marks = "{}[],:\"\\01e-.tn ";
        switch (random.below(4)) {
            case 0: source[at] = static_cast<char>(random.below(256)); break;
            case 1: source[at] = marks[random.below(marks.size())]; break;
            case 2: source.erase(at, length); break;
            default: source.insert(at, source.substr(at, length));
        }
    }
    return source;
}

TEST(CoreJson, ReadsDamagedTextAsTheLibraryDoes) {
    Random random{3};
    int read = 0, refused = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto source = damaged(dump(some_value(random, 3).ours), random);
        const auto said = reread(source);
        ASSERT_EQ(said, reread_by_oracle(source)) << source;
        ++(said.starts_with("is not JSON") ? refused : read);
    }
    EXPECT_GT(read, 500);
    EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace thaum
