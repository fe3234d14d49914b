// Tests of what a Lua script of a scenario can and cannot do in its sandbox.
#include <gtest/gtest.h>

#include <lua.hpp>
#include <regex>

#include "core/clock.h"
#include "core/text.h"
#include "game/scenario/sandbox.h"
#include "unit/message_of.h"

namespace thaum::game {
namespace {

constexpr SandboxLimits small{.memory = 8U << 20U, .steps = 2'000'000};

struct Ran {
    bool ok = false;
    std::string message;
    std::string output;
};

/// Runs a script to its end. Waits of the script take no time.
Ran run(std::string_view source, const SandboxLimits& limits = small) {
    Sandbox sandbox(limits);
    sandbox.add(
        "wait", [](lua_State*, void*) { return Sandbox::wait; }, nullptr);
    sandbox.add(
        "fault", [](lua_State*, void*) -> int { throw ScriptFault{"a fault"}; }, nullptr);
    if (const auto started = sandbox.start(source, "test.lua"); !started)
        return {false, started.error().message, {}};
    for (;;) {
        const auto progress = sandbox.resume();
        if (!progress) return {false, progress.error().message, sandbox.output()};
        if (*progress == Sandbox::Progress::done) return {true, {}, sandbox.output()};
    }
}

std::string printed(std::string_view source) {
    const auto ran = run(source);
    EXPECT_TRUE(ran.ok) << ran.message;
    return ran.output;
}

std::string error_of(std::string_view source, const SandboxLimits& limits = small) {
    const auto ran = run(source, limits);
    EXPECT_FALSE(ran.ok) << source;
    return ran.message;
}

bool mentions(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

TEST(Sandbox, RunsOrdinaryLua) {
    EXPECT_EQ(printed("local t = {} for i = 1, 5 do t[i] = i * i end print(table.concat(t, ' '))"),
              "1 4 9 16 25\n");
    EXPECT_EQ(printed("print(string.format('%d %s %.2f %q', 3, 'x', 1.5, 'y'))"), "3 x 1.50 \"y\"\n");
    EXPECT_EQ(printed("print(('key=value'):sub(1, 3), ('value'):upper(), #'key')"), "key\tVALUE\t3\n");
    EXPECT_EQ(printed("print(pcall(error, 'x', 0))"), "false\tx\n");
    EXPECT_EQ(printed("print(select('#', pcall(function() return 1, nil, 3 end)))"), "4\n");
    EXPECT_EQ(printed("local c = coroutine.wrap(function() coroutine.yield(1) return 2 end) print(c(), c())"),
              "1\t2\n");
    EXPECT_EQ(printed("print(pcall(function() wait() return 'back' end))"), "true\tback\n");
    EXPECT_EQ(printed("print(setmetatable({}, {__tostring = function() return 'me' end}))"), "me\n");
    EXPECT_EQ(printed("print(utf8.char(228) == 'ä', #utf8.char(8364), tostring(nil), 7 // 2, 7 / 2)"),
              "true\t3\tnil\t3\t3.5\n");
}

TEST(Sandbox, HasNothingThatReachesOut) {
    for (const auto* name : {"io", "os", "package", "debug", "require", "load", "loadfile", "dofile",
                             "collectgarbage", "loadstring", "next", "xpcall", "warn", "string.dump",
                             "string.pack", "math.random", "math.randomseed"}) {
        EXPECT_EQ(printed(std::string("print(") + name + ")"), "nil\n") << name;
    }
    EXPECT_EQ(
        printed("local names = {} for k in pairs(_G) do names[#names + 1] = k end print(table.concat(names, "
                "' '))"),
        "_G _VERSION assert coroutine error fault getmetatable ipairs math pairs pcall print rawequal rawget "
        "rawlen rawset select setmetatable string table tonumber tostring type utf8 wait\n");
    EXPECT_EQ(printed("local names = {} for k in pairs(string) do names[#names + 1] = k end "
                      "print(table.concat(names, ' '))"),
              "byte char find format gmatch gsub len lower match rep reverse sub upper\n");
}

TEST(Sandbox, PairsIsSorted) {
    EXPECT_EQ(printed(R"(
        local t = {[true] = 1, b = 1, a = 1, [10] = 1, [2] = 1, [-3] = 1, [1.5] = 1, [2.5] = 1, [false] = 1, B = 1,
                   [math.huge] = 1, [-math.huge] = 1, [math.maxinteger] = 1, [math.mininteger] = 1, ab = 1, [''] = 1}
        local keys = {}
        for k in pairs(t) do keys[#keys + 1] = tostring(k) end
        print(table.concat(keys, ' ')))"),
              "-inf -9223372036854775808 -3 1.5 2 2.5 10 9223372036854775807 inf  B a ab b false true\n");
    EXPECT_EQ(printed("for k, v in pairs {} do print(k) end"), "");
    // A key removed during the loop is not visited. Lua may or may not visit a key added during the loop;
    // the sandbox never does.
    EXPECT_EQ(printed("local t = {1, 2, 3, x = 4} for k in pairs(t) do t[2] = nil t.y = 5 print(k) end"),
              "1\n3\nx\n");
    EXPECT_TRUE(mentions(error_of("for k in pairs {[{}] = 1} do end"), "a table has no order"));
    EXPECT_TRUE(mentions(error_of("for k in pairs {[print] = 1} do end"), "a function has no order"));
    EXPECT_TRUE(mentions(error_of("pairs(3)"), "table expected"));
}

TEST(Sandbox, SameOrderForAnyHistory) {
    // Lua's own order depends on a random seed per state and on earlier contents of the table.
    const auto order = [](const char* history) {
        return printed(
            std::string("local t = {} ") + history +
            " for i = 1, 200 do t['k' .. i] = i end local s = {} for k in pairs(t) do s[#s + 1] = k end "
            "print(table.concat(s))");
    };
    EXPECT_EQ(order(""),
              order("for i = 1, 900 do t['x' .. i] = 1 end for i = 1, 900 do t['x' .. i] = nil end"));
}

TEST(Sandbox, AddressesDoNotLeak) {
    const auto text = printed(R"(
        local f, t, c = function() end, {}, coroutine.create(function() end)
        print(f, t, c, print, pcall, string.rep)
        print(tostring(f), tostring(t), tostring(c))
        print(string.format('%s %s %10s %-10s|', f, t, c, print))
        print(('%s'):format(t), pcall(string.format, '%p', t), pcall(string.format, '%%%-20p', t))
        print(pcall(error, t), pcall(error, f))
        print(setmetatable({}, {__name = 'Name'}), string.format('%s', setmetatable({}, {__name = 'Name'})))
        print(select(2, pcall(function() return t .. 'x' end)), select(2, pcall(function() return t < t end)))
        print(select(2, pcall(table.concat, {{}})), select(2, pcall(string.format, '%d', t)))
        print(coroutine.running()))");
    EXPECT_FALSE(std::regex_search(text, std::regex("0x|[0-9a-f]{6}"))) << text;
    EXPECT_TRUE(mentions(text, "function\ttable\tthread\tfunction")) << text;
    EXPECT_FALSE(mentions(error_of("error({})"), "0x"));
    EXPECT_EQ(error_of("error({})"), "an error that is no text but a table");
}

TEST(Sandbox, EndlessLoopsAreStopped) {
    for (const auto* source : {
             "while true do end",
             "local function f() return f() end f()",
             "while true do pcall(function() while true do end end) end",
             "pcall(function() while true do pcall(error) end end) while true do end",
             "while true do coroutine.wrap(function() while true do end end)() end",
             "while true do local c = coroutine.create(function() while true do end end) coroutine.resume(c) "
             "end",
             "local c = coroutine.wrap(function() while true do coroutine.yield() end end) while true do c() "
             "end",
             "while true do pcall(coroutine.wrap(function() pcall(function() while true do end end) end)) "
             "end",
             "local t = setmetatable({}, {__index = function() while true do end end}) while true do "
             "pcall(function() return t.x end) end",
             "local t <close> = setmetatable({}, {__close = function() while true do end end}) while true do "
             "end",
             "while true do local c = coroutine.create(function() local x <close> = setmetatable({}, "
             "{__close = function() while true do end end}) "
             "coroutine.yield() end) coroutine.resume(c) coroutine.close(c) end",
             "while true do wait() end",
             "while true do coroutine.yield() end",
             "while true do pcall(wait) end",
             "while true do pcall(fault) end",
             "repeat local ok = pcall(string.rep, 'x', 1000) until false",
             "table.sort({3, 2, 1}, function() while true do end end)",
             "::again:: goto again",
         }) {
        const auto message = error_of(source);
        EXPECT_TRUE(mentions(message, "steps") || mentions(message, "C stack overflow")) << source << "\n"
                                                                                         << message;
    }
}

TEST(Sandbox, StepsRunOutAtALineOfTheScript) {
    EXPECT_EQ(error_of("local x = 1\nwhile true do x = x + 1 end"),
              "test.lua:2: the script has spent all its steps: an endless loop?");
}

TEST(Sandbox, MemoryBombsAreStopped) {
    for (const auto* source : {
             "local t = {} while true do t[#t + 1] = ('x'):rep(1000) .. #t end",
             "local s = 'x' while true do s = s .. s end",
             "local t = {} for i = 1, 1e9 do t[i] = i end",
             "local t = {} while true do t = {t, t, t, t} end",
             "local t = {} while true do t[#t + 1] = coroutine.create(function() end) end",
             "local t = {} while true do t[#t + 1] = function() return t end end",
             "local function f(s) while true do s = s .. s end end pcall(f, 'x') f('y')",
             "print(('x'):rep(1e9))",
             "print(('x'):rep(1e5, ('y'):rep(1e5)))",
             "print(('x'):rep(math.maxinteger))",
             "print(string.format('%99.99f', 1):rep(1e5))",
             "print(table.unpack({}, 1, 1e8))",
             "table.move({}, 1, 1e15, 2)",
             "table.concat(setmetatable({}, {__index = function() return '' end}), '', 1, 1e15)",
             "table.insert(setmetatable({}, {__len = function() return 1e15 // 1 | 0 end}), 1, 1)",
             "local function f(...) return f(1, ...) end f()",
             "local function f() return 1 + f() end f()",
         }) {
        const auto message = error_of(source);
        EXPECT_FALSE(message.empty()) << source;
    }
}

TEST(Sandbox, MemoryStaysUnderItsLimit) {
    Sandbox sandbox({.memory = 4U << 20U, .steps = 100'000'000});
    ASSERT_TRUE(sandbox.start("local t = {} for i = 1, 1e6 do t[i] = {i} end", "test.lua"));
    EXPECT_FALSE(sandbox.resume());
    EXPECT_LE(sandbox.memory(), 4U << 20U);
    // Freed memory does not count towards the limit.
    EXPECT_TRUE(run("for i = 1, 20000 do local s = ('x'):rep(1000) .. i end", {.memory = 4U << 20U}).ok);
}

/// Lua's own pattern matching does not count its steps, so scripts cannot use patterns in any way.
TEST(Sandbox, PatternsAreNotAvailable) {
    for (const std::string name : {"find", "match", "gmatch", "gsub"}) {
        const auto wanted = "test.lua:2: string." + name + ": patterns are not available in scenarios";
        EXPECT_TRUE(error_of("local s = 'a b'\nprint(s:" + name + "('a', 'b'))").starts_with(wanted)) << name;
        EXPECT_TRUE(error_of("\nstring." + name + "('a', 'a', 1, true)").starts_with(wanted)) << name;
        EXPECT_TRUE(mentions(printed("\nprint(pcall(string." + name + ", 'a', 'a'))"), "false\t" + wanted));
    }
    EXPECT_TRUE(mentions(error_of("('a'):find('a')"), "string.sub"));
}

/// Operations on texts and lists cost steps in proportion to their length. Otherwise a call that goes through
/// a long one would take no steps, and could run for minutes despite the limit on steps.
TEST(Sandbox, LongTextsAndListsCostSteps) {
    for (const auto* source : {
             "local s = ('a'):rep(500000) while true do s:byte(1, 100) end",
             "local s = ('a'):rep(500000) while true do s:upper() s:reverse() end",
             "local s = ('a'):rep(500000) while true do pcall(s.find, s, '.-.-.-b') end",
             "local s = ('a'):rep(500000) while true do utf8.len(s) end",
             "local t = {} while true do table.concat(t, '', 1, 0) table.unpack(t, 1, 60000) end",
             "local s = ('a'):rep(500000) while true do utf8.codepoint(s, 1, 200) end",
             "local s, t = ('a'):rep(500000), {} for i = 1, 60000 do t[i] = s end table.sort(t)",
             "local function f() coroutine.wrap(f)() end while true do pcall(f) end",
             "while true do coroutine.resume(coroutine.create(function() end)) end",
         }) {
        const auto start_ns = thread_cpu_ns();
        const auto message = error_of(source);
        EXPECT_TRUE(mentions(message, "steps")) << source << "\n" << message;
        EXPECT_LT(thread_cpu_ns() - start_ns, 10'000'000'000) << source;
    }
    // Usual operations on short texts are cheap.
    Sandbox sandbox(small);
    ASSERT_TRUE(sandbox.start("for i = 1, 100 do local k, v = ('speed'):upper(), tonumber('12.5') end", "x"));
    ASSERT_TRUE(sandbox.resume());
    EXPECT_LT(sandbox.steps(), 20'000U);
}

/// Reading a text byte by byte takes steps in proportion to its length, not to the square of its length.
TEST(Sandbox, ReadingOneByteIsCheap) {
    Sandbox sandbox;
    ASSERT_TRUE(sandbox.start(
        "local s, sum = ('a'):rep(60000), 0 "
        "for i = 1, #s do sum = sum + s:byte(i) + s:byte(-i, -i) + utf8.codepoint(s, i) end print(sum)",
        "x"));
    ASSERT_TRUE(sandbox.resume());
    EXPECT_EQ(sandbox.output(), text(60000 * 3 * 97, "\n"));
    EXPECT_LT(sandbox.steps(), 5'000'000);
}

void compute_for_a_while() {
    for (const auto end = thread_cpu_ns() + 200'000'000; thread_cpu_ns() < end;) {}
}

TEST(Sandbox, VerbsHaveATimeOfTheirOwn) {
    Sandbox sandbox({.steps = ~std::uint64_t{0} / 2, .verbs_s = 0.5});
    sandbox.add(
        "slow", [](lua_State*, void*) { return compute_for_a_while(), 0; }, nullptr);
    ASSERT_TRUE(sandbox.start("while true do pcall(slow) end", "test.lua"));
    const auto message = message_of(sandbox.resume());
    EXPECT_TRUE(mentions(message, "processor time")) << message;
}

TEST(Sandbox, ProcessorTimeEndsWorkThatTakesNoSteps) {
    SandboxLimits limits{.steps = ~std::uint64_t{0} / 2};
    limits.compute_s = 0.1;
    for (const auto* source :
         {"while true do end", "while true do pcall(function() while true do end end) end",
          "while true do wait() end"})
        EXPECT_TRUE(mentions(error_of(source, limits), "processor time")) << source;
    // Time spent in the host's functions, and by the host between two waits, does not count.
    Sandbox sandbox(limits);
    sandbox.add(
        "slow",
        [](lua_State*, void*) -> int {
            compute_for_a_while();
            return Sandbox::wait;
        },
        nullptr);
    ASSERT_TRUE(sandbox.start("slow() slow() for i = 1, 5000 do local x = i end", "test.lua"));
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(sandbox.resume());
        compute_for_a_while();
    }
}

TEST(Sandbox, CompiledCodeIsRefused) {
    const char compiled[] = "\x1bLua\x54\x00\x19\x93\r\n\x1a\n";
    EXPECT_TRUE(mentions(error_of({compiled, sizeof compiled}), "attempt to load a binary chunk"));
}

TEST(Sandbox, MathsIsOurs) {
    EXPECT_EQ(printed("print(math.sin(0), math.pow(2, 10), math.log(8, 2), math.atan(1, 1) == math.pi / 4)"),
              "0.0\t1024.0\t3.0\ttrue\n");
    EXPECT_TRUE(error_of("local x = 1\nprint(x ^ 2)").starts_with("test.lua:2: the operator ^"));
    // The check must find the end of a text where Lua does: an escape may hide the end of a line, and \r ends
    // a line too.
    for (const auto* source :
         {"local s = \"\\z\n\" x = 2 ^ 0.5 --\"", "local s = '\\z \t\r\n' x = 2 ^ 0.5 --'",
          "local s = '\\\n' x = 2 ^ 0.5 --'", "local s = '\\\r\n' x = 2 ^ 0.5 --'",
          "local s = '\\\\' x = 2 ^ 0.5 --'", "-- remark\rx = 2 ^ 0.5", "--[==[ ]] ]==] x = 2 ^ 0.5 --[[ ]]",
          "local s = [=[ ]] ]=] x = 2 ^ 0.5"})
        EXPECT_TRUE(mentions(error_of(source), "the operator ^")) << source;
    EXPECT_EQ(printed("print('\\z\n^', \"a\\\n^\", '\\'^')"), "^\ta\n^\t'^\n");
    EXPECT_EQ(printed("print(getmetatable('').__pow)"), "nil\n");
    // Within strings and comments, ^ is not the power operator.
    EXPECT_EQ(printed("print('^', \"^\\\"^\", [[^]], [==[^]]^]==], ('^x'):len()) -- ^\n--[[^\n^]] print(1)"),
              "^\t^\"^\t^\t^]]^\t2\n1\n");
}

TEST(Sandbox, FinalisersAndWeakTablesAreRefused) {
    EXPECT_TRUE(mentions(error_of("setmetatable({}, {__gc = function() end})"), "__gc"));
    EXPECT_TRUE(mentions(error_of("setmetatable({}, {__mode = 'k'})"), "__mode"));
}

TEST(Sandbox, FaultsOfVerbsNameTheScriptsLine) {
    EXPECT_EQ(error_of("\n\nfault()"), "test.lua:3: a fault");
    EXPECT_EQ(printed("print(pcall(fault))\nprint(pcall(function() fault() end))"),
              "false\ttest.lua:1: a fault\nfalse\ttest.lua:2: a fault\n");
    EXPECT_EQ(error_of("local c = coroutine.wrap(wait)\nc()"),
              "test.lua:2: a verb that takes time stands in a coroutine of the script's own");
}

TEST(Sandbox, FaultsBelowThePreludeNameTheScriptsLine) {
    Sandbox sandbox(small);
    sandbox.add(
        "fault", [](lua_State*, void*) -> int { throw ScriptFault{"a fault"}; }, nullptr);
    ASSERT_TRUE(sandbox.run_prelude("\n\n\nfunction ours() local x = fault() return x end"));
    ASSERT_TRUE(sandbox.start("\nlocal x = ours()\n", "test.lua"));
    EXPECT_EQ(sandbox.resume().error().message, "test.lua:2: a fault");
}

TEST(Sandbox, OutputIsBounded) {
    const auto ran = run("for i = 1, 1000 do print(('x'):rep(1000)) end", {.output = 5000});
    EXPECT_TRUE(ran.ok);
    EXPECT_EQ(ran.output.size(), 5000U);
}

TEST(Sandbox, MessagesAreOneLine) { EXPECT_EQ(error_of("error('a\\nb\\rc', 0)"), "a b c"); }

}  // namespace
}  // namespace thaum::game
