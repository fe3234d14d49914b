#include "core/config.h"

#include <gtest/gtest.h>

#include "core/near_name.h"
#include "core/one_line.h"
#include "core/random.h"
#include "core/text.h"
#include "unit/message_of.h"

namespace thaum {
namespace {

Config parsed(std::string_view body) {
    return Config::parse(text("version = 1\n", body), "wand.toml", 1).value();
}

/// Error of `parse` for a whole file; empty: none.
std::string parse_fault(std::string_view file) { return message_of(Config::parse(file, "wand.toml", 1)); }

/// Error of `check` after `read` has asked for its keys; empty: none.
std::string fault_of(std::string_view body, const std::function<void(const ConfigTable&)>& read) {
    const auto config = parsed(body);
    read(config.root());
    return message_of(config.check());
}

std::string number_fault(std::string_view body, Range range = {0, 10}) {
    return fault_of(body, [range](const ConfigTable& t) { t.number("x", range); });
}

TEST(CoreConfig, ReadsEveryKind) {
    const auto config = parsed(R"(
        force = 2.5
        count = 7
        on = true
        name = "lift"
        at = [1, 2.5, -3]
        kind = "line"
        [inner]
        deep = { x = 1 }
        [[ring]]
        n = 1
        [[ring]]
        n = 2
    )");
    const auto root = config.root();
    EXPECT_EQ(root.number("force", {0, 10}), 2.5);
    EXPECT_EQ(root.integer("count", {0, 10}), 7);
    EXPECT_TRUE(root.boolean("on", false));
    EXPECT_EQ(root.string("name"), "lift");
    EXPECT_EQ(root.vector("at", {-5, 5}), vec3(1, 2.5, -3));
    EXPECT_EQ(root.choice("kind", {"point", "line"}), 1);
    EXPECT_EQ(root.table("inner").table("deep").number("x", {}), 1);
    const auto rings = root.tables("ring");
    ASSERT_EQ(rings.size(), 2);
    EXPECT_EQ(rings[0].integer("n", {}), 1);
    EXPECT_EQ(rings[1].integer("n", {}), 2);
    EXPECT_TRUE(config.check().has_value());
}

TEST(CoreConfig, ReadsListsOfNumbers) {
    const auto config = parsed("a = [1, 2.5]\nb = [7]");
    EXPECT_EQ(config.root().numbers("a", {0, 3}, 2, {}), (std::vector<double>{1, 2.5}));
    EXPECT_EQ(config.root().numbers("b", {0, 9}, 2, {}), (std::vector<double>{7}));
    EXPECT_EQ(config.root().numbers("none", {0, 9}, 2, {4, 5}), (std::vector<double>{4, 5}));
    EXPECT_TRUE(config.check().has_value());
    const auto fault = [](std::string_view body) {
        return fault_of(body, [](const ConfigTable& t) { t.numbers("x", {0, 10}, 2, {}); });
    };
    EXPECT_EQ(fault("x = 3"), "wand.toml:2: 'x' must be a list of 1 to 2 numbers, not 3");
    EXPECT_EQ(fault("x = []"), "wand.toml:2: 'x' must be a list of 1 to 2 numbers, not a list of 0");
    EXPECT_EQ(fault("x = [1, 2, 3]"), "wand.toml:2: 'x' must be a list of 1 to 2 numbers, not a list of 3");
    EXPECT_EQ(fault("x = [1, 11]"), "wand.toml:2: 'x' is 11, must be from 0 to 10");
    EXPECT_EQ(fault("x = [1, nan]"), "wand.toml:2: 'x' is nan, must be from 0 to 10");
    EXPECT_EQ(fault("x = [1, true]"), "wand.toml:2: 'x' must be a number from 0 to 10, not true");
}

TEST(CoreConfig, FallbacksStandInForMissingKeys) {
    const auto config = parsed("");
    const auto root = config.root();
    EXPECT_EQ(root.number("a", {0, 1}, 0.5), 0.5);
    EXPECT_EQ(root.integer("a", {0, 9}, 4), 4);
    EXPECT_TRUE(root.boolean("a", true));
    EXPECT_EQ(root.string("a", "b"), "b");
    EXPECT_EQ(root.vector("a", {}, vec3(1)), vec3(1));
    EXPECT_EQ(root.choice("a", {"x", "y"}, 1), 1);
    EXPECT_TRUE(root.tables("a").empty());
    EXPECT_EQ(root.table("a").table("b").number("c", {}, 3), 3);
    EXPECT_FALSE(root.table("a").has("b"));
    EXPECT_TRUE(root.table("a").keys().empty());
    EXPECT_TRUE(config.check().has_value());
}

TEST(CoreConfig, TheVersionIsDemanded) {
    EXPECT_EQ(parse_fault("\n"), "wand.toml:1: the file is empty; it begins with version = 1");
    EXPECT_EQ(parse_fault("# nothing"), "wand.toml:1: key 'version' is missing: version = 1");
    EXPECT_EQ(parse_fault("version = 2"), "wand.toml:1: version 2 cannot be read, only version 1");
    EXPECT_EQ(parse_fault("\nversion = '1'"),
              "wand.toml:2: 'version' must be a whole number from 0 to 1e+09, "
              "not the text \"1\"; write 1 without quotes");
    EXPECT_EQ(parse_fault("version = 1.0"),
              "wand.toml:1: 'version' must be a whole number from 0 to 1e+09, not 1.0");
    EXPECT_NE(parse_fault("version = -1"), "");
    EXPECT_NE(parse_fault("version = 9223372036854775807"), "");
}

TEST(CoreConfig, BrokenTomlNamesTheLine) {
    EXPECT_TRUE(parse_fault("version = 1\nx = = 2").starts_with("wand.toml:2: "));
    EXPECT_TRUE(parse_fault("version = 1\n\nversion = 1").starts_with("wand.toml:3: "));
    EXPECT_EQ(parse_fault("version = 1\nx = 'open\ny = 1").find('\n'), std::string::npos);
}

TEST(CoreConfig, MissingKeysAreNamed) {
    EXPECT_EQ(number_fault(""), "wand.toml:1: key 'x' is missing: a number from 0 to 10");
    EXPECT_EQ(fault_of("[inner]\n", [](const auto& t) { t.table("inner").integer("n", {}); }),
              "wand.toml:2: key 'n' is missing: a whole number");
    EXPECT_EQ(fault_of("", [](const auto& t) { t.table("inner").string("n"); }),
              "wand.toml:1: table 'inner' is missing");
    EXPECT_NE(fault_of("", [](const auto& t) { t.vector("v", {}); }), "");
    EXPECT_NE(fault_of("", [](const auto& t) { t.choice("c", {"a"}); }), "");
}

TEST(CoreConfig, UnknownKeysAreNamedWithTheirPath) {
    EXPECT_EQ(fault_of("a = 1\n", [](const auto&) {}), "wand.toml:2: unknown key 'a'");
    EXPECT_EQ(fault_of("[a]\nb.c = 1\n", [](const auto& t) { t.table("a").table("b"); }),
              "wand.toml:3: unknown key 'a.b.c'");
    EXPECT_EQ(fault_of("[[a]]\nx = 1\n[[a]]\ny = 1\n",
                       [](const auto& t) {
                           for (const auto& item : t.tables("a")) item.number("x", {}, 0);
                       }),
              "wand.toml:5: unknown key 'a.y'; known here: x");
}

TEST(CoreConfig, AskingWhetherAKeyIsThereIsNotReadingIt) {
    EXPECT_NE(fault_of("a = 1", [](const auto& t) { EXPECT_TRUE(t.has("a")); }), "");
}

TEST(CoreConfig, KeysComeSortedAndCountAsAsked) {
    const auto config = parsed("b = 1\na = 2\nc = 3");
    EXPECT_EQ(config.root().keys(), (std::vector<std::string>{"a", "b", "c", "version"}));
    EXPECT_TRUE(config.check().has_value());
}

TEST(CoreConfig, WrongTypesAreNamed) {
    for (const auto* value : {"true", "'1'", "[1]", "{a = 1}", "2020-01-01"}) {
        const auto fault = number_fault(text("x = ", value));
        EXPECT_TRUE(fault.starts_with("wand.toml:2: 'x' must be a number from 0 to 10, not ")) << fault;
    }
    const auto said = [](std::string_view value, auto read) {
        return fault_of(text("x = ", value), [&](const ConfigTable& t) { read(t); });
    };
    EXPECT_EQ(said("1.5", [](auto& t) { t.integer("x", {}); }),
              "wand.toml:2: 'x' must be a whole number, not 1.5");
    EXPECT_EQ(said("1", [](auto& t) { t.boolean("x", false); }),
              "wand.toml:2: 'x' must be true or false, not 1");
    EXPECT_EQ(said("1", [](auto& t) { t.string("x"); }), "wand.toml:2: 'x' must be a text in quotes, not 1");
    EXPECT_EQ(said("[1, 2]", [](auto& t) { t.vector("x", {}); }),
              "wand.toml:2: 'x' must be three numbers, not a list of 2");
    EXPECT_EQ(said("[1, 2, 'a']", [](auto& t) { t.vector("x", {}); }),
              "wand.toml:2: 'x' must be a number, not the text \"a\"");
    EXPECT_EQ(said("'c'",
                   [](auto& t) {
                       t.choice("x", {"a", "b"});
                   }),
              "wand.toml:2: 'x' must be one of: a, b; it is the text \"c\"");
    EXPECT_EQ(said("3",
                   [](auto& t) {
                       t.choice("x", {"a", "b"});
                   }),
              "wand.toml:2: 'x' must be one of: a, b; it is 3");
    EXPECT_EQ(said("1", [](auto& t) { t.table("x"); }), "wand.toml:2: 'x' must be a table, [x], not 1");
    EXPECT_EQ(said("{}", [](auto& t) { t.tables("x"); }),
              "wand.toml:2: 'x' must be a list of tables, [[x]], not a table");
    EXPECT_EQ(said("[1, 2]", [](auto& t) { t.tables("x"); }),
              "wand.toml:2: 'x' must be a list of tables, [[x]], not a list of 2");
}

TEST(CoreConfig, RangesHoldAtBothEnds) {
    EXPECT_EQ(number_fault("x = 0"), "");
    EXPECT_EQ(number_fault("x = 10"), "");
    EXPECT_EQ(number_fault("x = 10.5"), "wand.toml:2: 'x' is 10.5, must be from 0 to 10");
    EXPECT_EQ(number_fault("x = -1e-9"), "wand.toml:2: 'x' is -1e-09, must be from 0 to 10");
    EXPECT_EQ(number_fault("x = 1e-300"),
              "wand.toml:2: 'x' is 1e-300, must be 0 or at least 1e-12, from 0 to 10");
    EXPECT_EQ(number_fault("x = nan"), "wand.toml:2: 'x' is nan, must be from 0 to 10");
    EXPECT_NE(number_fault("x = nan", {}), "");
    EXPECT_NE(number_fault("x = inf", {}), "");
    EXPECT_NE(number_fault("x = -inf", {}), "");
    EXPECT_EQ(number_fault("x = inf", {0, std::numeric_limits<double>::infinity()}), "");
    EXPECT_NE(fault_of("x = 11", [](const auto& t) { t.integer("x", {0, 10}); }), "");
    EXPECT_NE(fault_of("x = [1, 2, 11]", [](const auto& t) { t.vector("x", {0, 10}); }), "");
}

TEST(CoreConfig, IntegersReachTheirEnds) {
    const auto config = parsed("low = -9223372036854775808\nhigh = 9223372036854775807");
    EXPECT_EQ(config.root().integer("low", {}), std::numeric_limits<std::int64_t>::min());
    EXPECT_EQ(config.root().integer("high", {}), std::numeric_limits<std::int64_t>::max());
    EXPECT_TRUE(config.check().has_value());
}

TEST(CoreConfig, AfterAFaultReadsStayInRange) {
    const auto config = parsed("x = 99\nn = 99\nv = [99, 0, 0]");
    const auto root = config.root();
    EXPECT_EQ(root.number("x", {1, 2}), 1);
    EXPECT_EQ(root.integer("n", {1, 2}), 1);
    EXPECT_EQ(root.vector("v", {1, 2}), vec3(1));
    EXPECT_EQ(root.integer("missing", {}), 0);
    EXPECT_FALSE(config.check().has_value());
}

/// All messages about a file after `read` has asked for its keys.
std::vector<std::string> faults_of(std::string_view body,
                                   const std::function<void(const ConfigTable&)>& read) {
    const auto config = parsed(body);
    read(config.root());
    const auto checked = config.check();
    return checked ? std::vector<std::string>() : lines_of(checked.error());
}

/// A fault that a reader reports about a table with a wrong value is left out, because the reader worked with
/// a fallback value.
TEST(CoreConfig, AllFaultsAreKeptInTheOrderOfReading) {
    EXPECT_EQ(faults_of("x = 'a'\ny = 'b'\nz = 1",
                        [](const auto& t) {
                            t.number("y", {});
                            t.number("x", {});
                            t.number("x", {});
                            t.report("x", "later");
                        }),
              (std::vector<std::string>{"wand.toml:3: 'y' must be a number, not the text \"b\"",
                                        "wand.toml:2: 'x' must be a number, not the text \"a\"",
                                        "wand.toml:4: unknown key 'z'; known here: x, y"}));
}

TEST(CoreConfig, AMisspeltKeyIsNamedInPlaceOfTheMissingOne) {
    const auto read = [](const ConfigTable& t) {
        t.number("damage", {});
        t.number("speed", {});
    };
    EXPECT_EQ(faults_of("damge = 1\nspeed = 2", read),
              (std::vector<std::string>{"wand.toml:2: unknown key 'damge'; did you mean 'damage'?"}));
    EXPECT_EQ(faults_of("harm = 1\nspeed = 2", read),
              (std::vector<std::string>{"wand.toml:2: unknown key 'harm'; known here: damage, speed",
                                        "wand.toml:1: key 'damage' is missing: a number"}));
    EXPECT_EQ(faults_of("[schot]\nx = 1", [](const auto& t) { t.table("shot").number("x", {}); }),
              (std::vector<std::string>{"wand.toml:2: unknown key 'schot'; did you mean 'shot'?"}));
}

/// Which keys a reader asks for may depend on a word in the file, here the shape. If that word is wrong, the
/// reader takes another one and asks for keys that do not belong to the intended word. The keys of the
/// intended word must not be reported as unknown.
TEST(CoreConfig, AfterAWrongWordOnlyNearKeysAreUnknown) {
    const auto read = [](const ConfigTable& t) {
        if (t.choice("shape", {"ball", "rod"}) == 0)
            t.number("radius", {});
        else
            t.number("length", {});
    };
    EXPECT_EQ(
        faults_of("shape = 'rood'\nlength = 1\nradiuss = 1", read),
        (std::vector<std::string>{
            "wand.toml:2: 'shape' must be one of: ball, rod; it is the text \"rood\"; did you mean 'rod'?",
            "wand.toml:4: unknown key 'radiuss'; did you mean 'radius'?"}));
}

TEST(NearName, AFewChangesLeadToTheName) {
    const std::vector<std::string_view> names{"damage", "speed_m_s", "x", "to", "boiling_court"};
    for (const auto* slip : {"damge", "damagee", "dmaage", "Damage", "bamage"})
        EXPECT_EQ(near_name(slip, names), "damage") << slip;
    EXPECT_EQ(near_name("speed-m-s", names), "speed_m_s");
    EXPECT_EQ(near_name("boilin_curt", names), "boiling_court");
    for (const auto* other : {"damage", "dommoge", "y", "ot", "", "colour"})
        EXPECT_EQ(near_name(other, names), "") << other;
    EXPECT_EQ(near_name(std::string(100'000, 'a'), names), "") << "nobody means a name by that";
    EXPECT_EQ(did_you_mean("damge", names), "; did you mean 'damage'?");
    EXPECT_EQ(did_you_mean("colour", names), "");
}

struct Slip {
    std::string written;  ///< the keys as text, from line 2 on
    std::size_t line;
    std::string explained;
};

void expect_explained(std::initializer_list<Slip> slips) {
    for (const auto& slip : slips) {
        const auto fault = parse_fault(text("version = 1\n", slip.written));
        EXPECT_TRUE(fault.starts_with(text("wand.toml:", slip.line, ": "))) << slip.written << ": " << fault;
        EXPECT_NE(fault.find(slip.explained), std::string::npos) << slip.written << ": " << fault;
        EXPECT_EQ(fault.find("Error while parsing"), std::string::npos)
            << "the parser's words mislead: " << fault;
    }
}

TEST(CoreConfig, SlipsInNumbersAreExplained) {
    expect_explained({{"x = 1,5", 2, "a number has a point, not a comma: write 1.5"},
                      {"x = 1,500", 2, "write 1500 or 1.500"},
                      {"x = 1 500", 2, "no blanks: write 1500"},
                      {"x = 1'500  # many", 2, "without a sign between them"},
                      {"x = 5 m", 2, "no unit"},
                      {"x = 5.5m", 2, "no unit: write 5.5"},
                      {"x = 50%", 2, "no unit: write 50"},
                      {"x = three", 2, "'three' is no number, and a text stands in quotes: \"three\""},
                      {"x = 1;", 2, "leave out the ';'"},
                      {"x = 1 // one", 2, "a comment begins with '#'"},
                      {"x = 1 y = 2", 2, "a line has one KEY = VALUE"},
                      {"x = 4 * 60", 2, "write its result"},
                      {"x = 4:00", 2, "no ':'"},
                      {"x = --4", 2, "one sign"},
                      {"x = 1.2.3", 2, "one point"},
                      {"x = 1e", 2, "digits after its 'e'"},
                      {"x = 03", 2, "does not begin with a zero"},
                      {"x = -03", 2, "does not begin with a zero"},
                      {"x = 99999999999999999999", 2, "is at most 9223372036854775807"},
                      {"x = -9223372036854775809", 2, "is at most 9223372036854775807"},
                      {"x = 1e400", 2, "is below 1.8e308"},
                      {"x = -1.5E+400", 2, "is below 1.8e308"},
                      {"x = \u22123", 2, "write '-'"},
                      {"x = \uff13", 2, "write '3'"}});
}

TEST(CoreConfig, SlipsInWordsAreExplained) {
    expect_explained({{"x = box", 2, "a text stands in quotes: \"box\""},
                      {"x = box\"", 2, "a text stands in quotes: \"box\""},
                      {"x = \"box", 2, "a quote is not closed"},
                      {"x = \"b\"ox\"", 2, "a quote within \"...\""},
                      {"x = \"C:\\Users\"", 2, "has \\\\ for each backslash"},
                      {"x = \u201cbox\u201d", 2, "straight quotes"},
                      {"x = `box`", 2, "straight quotes"},
                      {"x = yes", 2, "write true or false"},
                      {"x = FALSE", 2, "write true or false"},
                      {"x = null", 2, "leave out the line"},
                      {"x = #8A5E3A  # brown", 2, "a colour stands in quotes: \"#8A5E3A\""}});
}

TEST(CoreConfig, SlipsInKeysListsAndTablesAreExplained) {
    expect_explained({{"x : 5", 2, "write '=' in place of ':'"},
                      {"x := 5", 2, "write '=' in place of ':='"},
                      {"x == 5", 2, "one '='"},
                      {"x 5", 2, "'=' is missing: write x = 5"},
                      {"= 5", 2, "a key is missing"},
                      {"x =\n5", 2, "a value is missing"},
                      {"x y = 5", 2, "a key has no blanks"},
                      {"k\u00e4se = 5", 2, "only letters a-z"},
                      {"x = 5\nx = 6", 3, "'x' is there twice, first in line 2"},
                      {"[a]\nx = 1\n[a]", 4, "[a] is there twice, first in line 2"},
                      {"[a]\nx = 1\n[[a]]\nx = 2", 2, "[a] here and [[a]] in line 4: each entry of a list"},
                      {"[[a]]\nx = 1\n[a]\nx = 2", 4, "[a] here and [[a]] in line 2: each entry of a list"},
                      {"x = [1 2]", 2, "commas"},
                      {"x = [1, 2\ny = 3", 2, "']' is missing"},
                      {"x = [1,\n2 3]", 3, "commas"},
                      {"x = 1, 2]", 2, "begins with '['"},
                      {"x = (1, 2)", 2, "stands in [ ]"},
                      {"x = {1, 2}", 2, "stands in [ ]"},
                      {"x = [a, b]", 2, "a text in a list stands in quotes"},
                      {"x = {a = 1,}", 2, "without a comma at its end"},
                      {"[a", 2, "a table is [name]"},
                      {"// words", 2, "a comment begins with '#'"},
                      {"Some words: many", 2, "a comment, which begins with '#'"},
                      {"<<<<<<< HEAD", 2, "not merged"}});
    EXPECT_EQ(parse_fault("\xef\xbb\xbfversion = 1\r\n\tx = 1\r\n"), "") << "BOM, CRLF and tabs are no slips";
    EXPECT_NE(parse_fault("{\"version\": 1}").find("this is JSON"), std::string::npos);
    EXPECT_NE(parse_fault("version = 1\nx = '\xfc'").find("wand.toml:2: a character is not UTF-8"),
              std::string::npos);
}

TEST(CoreConfig, InvisibleCharactersAreNamed) {
    expect_explained({{"x\u00a0= 1", 2, "U+00A0 (no-break space)"},
                      {"x\u200b = 1", 2, "U+200B (zero-width space)"},
                      {"\ufeffx = 1", 2, "U+FEFF (byte order mark)"}});
    EXPECT_NE(fault_of("x = \"li\u00adne\"", [](const auto& t) { t.choice("x", {"line"}); })
                  .find("U+00AD (soft hyphen)"),
              std::string::npos);
}

TEST(CoreConfig, AKeyInAnotherTableIsFound) {
    EXPECT_EQ(fault_of("[inner]\ny = 1\nx = 2\n",
                       [](const auto& t) {
                           t.number("x", {0, 9});
                           t.table("inner").number("y", {0, 9});
                       }),
              "wand.toml:1: key 'x' is missing: a number from 0 to 9; line 4 has it in another table, as "
              "'inner.x': move it");
    EXPECT_NE(parse_fault("[inner]\nversion = 1\n").find("line 2 has it"), std::string::npos);
}

TEST(CoreConfig, OneFaultIsToldOfATableInPlaceOfNumbers) {
    const auto config = parsed("x = {a = 1, b = 2}\n");
    config.root().vector("x", {0, 9});
    const auto fault = config.check().error();
    EXPECT_EQ(fault.message, "wand.toml:2: 'x' must be three numbers, not a table");
    EXPECT_TRUE(fault.more.empty());
}

/// The TOML parser stops at the value 1:.2 with an assertion that names no line.
TEST(CoreConfig, AWrongTimeNamesItsLine) {
    EXPECT_TRUE(parse_fault("version = 1\n\nx = 1:.2\ny = 2\n").starts_with("wand.toml:3: "));
}

TEST(CoreConfig, ReadersMayReportFaultsOfTheirOwn) {
    EXPECT_EQ(fault_of("x = 1\n", [](const auto& t) { t.report("x", "clashes with y"); }),
              "wand.toml:2: clashes with y");
    const auto config = parsed("");
    config.report("no wand at all");
    EXPECT_EQ(config.check().error().message, "wand.toml: no wand at all");
}

TEST(CoreConfig, TablesOutliveTheConfig) {
    const auto table = [] { return parsed("[a]\nx = 3").root().table("a"); }();
    EXPECT_EQ(table.number("x", {}), 3);
}

TEST(CoreConfig, EqualValuesHashEqually) {
    const auto hash = [](std::string_view body) { return parsed(body).value_hash(); };
    const auto as_written = hash("a = 1\nb = 'x'\n[inner]\nc = [1, 2.5]\nd = true\n");
    EXPECT_EQ(as_written,
              hash("# words\nb = \"x\"   # more\na = 1.0\ninner = { d = true, c = [1.0, 2.50] }\n"));
    for (const auto* other :
         {"a = 2\nb = 'x'\n[inner]\nc = [1, 2.5]\nd = true\n",
          "a = 1\nb = 'y'\n[inner]\nc = [1, 2.5]\nd = true\n",
          "a = 1\nb = 'x'\n[inner]\nc = [2.5, 1]\nd = true\n",
          "a = 1\nb = 'x'\n[inner]\nc = [1, 2.5]\nd = false\n",
          "a = 1\nb = 'x'\n[outer]\nc = [1, 2.5]\nd = true\n", "a = 1\nb = 'x'\n[inner]\nc = [1, 2.5]\n",
          "a = '1'\nb = 'x'\n[inner]\nc = [1, 2.5]\nd = true\n",
          "a = 1\nb = 'x'\n[inner]\nc = [[1], 2.5]\nd = true\n"}) {
        EXPECT_NE(as_written, hash(other)) << other;
    }
    // A double could not distinguish these numbers beyond 2^53.
    EXPECT_NE(hash("a = 9007199254740993"), hash("a = 9007199254740994"));
}

/// Nesting that would exhaust the stack of a recursive parser is reported like any other fault.
TEST(CoreConfig, DeepNestingIsRefused) {
    constexpr std::size_t depth = 300'000;
    std::string dotted = "a";
    for (std::size_t i = 1; i < depth; ++i) dotted += ".a";
    EXPECT_NE(parse_fault("version = 1\nx = " + std::string(depth, '[')), "");
    EXPECT_NE(parse_fault("version = 1\n" + dotted + " = 1"), "");
    EXPECT_NE(parse_fault("version = 1\n[" + dotted + "]"), "");
    EXPECT_NE(parse_fault("version = 1\n[[" + dotted + "]]"), "");
    std::string braces;
    for (std::size_t i = 0; i < depth; ++i) braces += "{a=";
    EXPECT_NE(parse_fault("version = 1\nx = " + braces), "");
}

/// The limit on the number of dots is for keys. Lists of decimal numbers may have any length.
TEST(CoreConfig, LongListsOfNumbersAreFine) {
    std::string list = "[0.5";
    for (int i = 0; i < 5000; ++i) list += ", 12.5";
    EXPECT_EQ(parse_fault("version = 1\nx = " + list + "]"), "");
    std::string key = "1";
    for (int i = 0; i < 5000; ++i) key += ".1";
    EXPECT_EQ(parse_fault("version = 1\n" + key + " = 1"), "wand.toml:2: more than 200 dots in one line");
}

/// toml++ 3.3 itself stops at this file with an assertion.
TEST(CoreConfig, AWrongTimeIsAFault) { EXPECT_NE(parse_fault("version = 1\nx = 1:.2\ny = :1.5:"), ""); }

std::string utf8(unsigned code) {
    const auto byte = [](unsigned value) { return std::string(1, static_cast<char>(value)); };
    if (code < 0x800) return byte(0xc0 | code >> 6) + byte(0x80 | (code & 0x3f));
    return byte(0xe0 | code >> 12) + byte(0x80 | (code >> 6 & 0x3f)) + byte(0x80 | (code & 0x3f));
}

/// toml++ 3.3 itself fails here: it assumes that no letter can follow where white space may.
TEST(CoreConfig, ALetterOfAnyScriptBesideAValueIsAFault) {
    for (unsigned code = 0xa1; code < 0xfeff; code += 13) {
        if (code >= 0xd800 && code < 0xe000) continue;  // surrogates are no characters
        const auto letter = utf8(code);
        ASSERT_NE(parse_fault("version = 1\nx = " + letter + "1"), "") << code;
        ASSERT_NE(parse_fault("version = 1\nx = 1" + letter), "") << code;
        ASSERT_NE(parse_fault(letter + "version = 1"), "") << code;
    }
    EXPECT_EQ(parse_fault("version = 1\nx = '\u00e9'  # \u00e9"), "");
}

// ---- random changes of files ------------------------------------------------------------------------------

constexpr std::string_view fuzz_seed = R"(version = 1
# a wand like any other
name = "lift \u00e9 \"quoted\""
force = 2.5e-3
count = 0x7f
when = 1979-05-27T07:32:00Z
at = [1, 2.5, -3]
on = true
long = """
several
lines"""
raw = 'C:\path'
[inner]
deep = { x = 1, y = [ [1], ["a"] ] }
a.b.c = inf
[[ring]]
n = 1
[[ring]]
n = nan
)";

constexpr std::string_view fuzz_bits = "[]{}=.,\"'#\n\r\t\\ 019eE+-_:xnTZ\xff\x00\xc3\xef\xbb\xbf";

/// The file with some random bytes changed, inserted, removed, cut or repeated.
std::string mutated(std::string file, Random& random) {
    const auto edits = 1 + random.below(12);
    for (std::uint64_t i = 0; i < edits && !file.empty(); ++i) {
        const auto at = random.below(file.size());
        const char c = fuzz_bits[random.below(fuzz_bits.size())];
        switch (random.below(6)) {
            case 0: file[at] = c; break;
            case 1: file.insert(at, 1, c); break;
            case 2: file.erase(at, 1 + random.below(8)); break;
            case 3: file.insert(at, file.substr(random.below(file.size()), random.below(40))); break;
            case 4: file[at] = static_cast<char>(random.next()); break;
            default: file.insert(at, random.below(30), c); break;
        }
    }
    if (random.below(20) == 0) file.resize(random.below(file.size() + 1));
    return file;
}

/// Reads every key as every type, as a careless reader would.
void read_all(const ConfigTable& table, int depth) {
    if (depth > 8) return;
    for (const auto& key : table.keys()) {
        table.number(key, {0, 1}, 0);
        table.integer(key, {0, 1});
        table.boolean(key, false);
        table.string(key);
        table.vector(key, {});
        table.choice(key, {"a", "b"});
        read_all(table.table(key), depth + 1);
        for (const auto& item : table.tables(key)) read_all(item, depth + 1);
    }
}

void expect_one_clear_line(const std::string& message) {
    EXPECT_TRUE(message.starts_with("wand.toml")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

void survive(std::string_view file) {
    const auto config = Config::parse(file, "wand.toml", 1);
    if (!config) return expect_one_clear_line(config.error().message);
    read_all(config->root(), 0);
    if (const auto result = config->check(); !result) expect_one_clear_line(result.error().message);
}

TEST(CoreConfigFuzz, FiveThousandMutatedFiles) {
    Random random{20};
    for (int i = 0; i < 5000; ++i) survive(mutated(std::string(fuzz_seed), random));
}

TEST(CoreConfigFuzz, EveryCutOfAFile) {
    for (std::size_t n = 0; n <= fuzz_seed.size(); ++n) survive(fuzz_seed.substr(0, n));
}

TEST(CoreConfigFuzz, AMegabyteOfGarbage) {
    Random random{21};
    for (int round = 0; round < 4; ++round) {
        std::string file(1 << 20, ' ');
        for (auto& c : file) {
            c = round % 2 == 0 ? static_cast<char>(random.next()) : fuzz_bits[random.below(fuzz_bits.size())];
        }
        survive(file);
        survive("version = 1\nx = \"\"\"" + file);
    }
    for (const char c : fuzz_bits) survive(std::string(1 << 20, c));
}

/// A terminal would obey control characters, so messages show them as codes such as \x1b.
TEST(CoreConfig, ControlCharactersOfAFileDoNotReachAMessage) {
    const auto file = Config::parse("version = 1\nkind = \"a\\tb\\u001B[2J\\u007F\"\n", "f.toml", 1).value();
    const auto kind = file.root().string("kind");
    file.root().report("kind", "unknown kind '" + kind + "'");
    EXPECT_EQ(message_of(file.check()), "f.toml:2: unknown kind 'a b\\x1b[2J\\x7f'");
    EXPECT_EQ(in_one_line(std::string(100'000, 'x')), std::string(1000, 'x') + "...");
}

}  // namespace
}  // namespace thaum
