#include <algorithm>

#include "fuzz/fuzz.h"

namespace thaum::fuzz {
namespace {

constexpr std::size_t max_bytes = 400'000;

std::size_t below(Random& random, std::size_t n) {
    return n == 0 ? 0 : static_cast<std::size_t>(random.below(n));
}

/// A random piece of the text or bytes `from`, short in most cases.
std::string piece(const std::string& from, Random& random) {
    const auto at = below(random, from.size());
    const auto longest = random.below(4) == 0 ? from.size() : std::size_t{200};
    return from.substr(at, 1 + below(random, longest));
}

void flip_bit(std::string& s, Random& random) {
    if (s.empty()) return;
    auto& c = s[below(random, s.size())];
    c = static_cast<char>(static_cast<unsigned char>(c) ^ (1U << random.below(8)));
}

void put_striking_byte(std::string& s, Random& random) {
    static constexpr char striking[] = {'\0', '\x01', '\x7f', '\x80', '\xff', '\n', '"', '\xc0'};
    if (!s.empty()) s[below(random, s.size())] = striking[random.below(sizeof striking)];
}

void erase_piece(std::string& s, Random& random) {
    s.erase(below(random, s.size() + 1), 1 + below(random, 40));
}
void cut(std::string& s, Random& random) { s.resize(below(random, s.size() + 1)); }

void splice(std::string& s, const std::vector<std::string>& seeds, Random& random) {
    const auto& other = seeds[below(random, seeds.size())];
    if (!other.empty()) s.insert(below(random, s.size() + 1), piece(other, random));
}

void repeat(std::string& s, Random& random) {
    if (s.empty()) return;
    const auto what = piece(s, random);
    const auto at = below(random, s.size());
    std::string many;
    for (auto n = 1 + below(random, 3000); n > 0 && s.size() + many.size() < max_bytes; --n) many += what;
    s.insert(at, many);
}

/// Start and end of a random line, with its line feed.
std::pair<std::size_t, std::size_t> some_line(const std::string& s, Random& random) {
    const auto at = below(random, s.size());
    const auto before = at == 0 ? std::string::npos : s.rfind('\n', at - 1);
    const auto begin = before == std::string::npos ? 0 : before + 1;
    const auto end = s.find('\n', at);
    return {begin, end == std::string::npos ? s.size() : end + 1};
}

void double_line(std::string& s, Random& random) {
    const auto [begin, end] = some_line(s, random);
    s.insert(begin, s.substr(begin, end - begin));
}

void lose_line(std::string& s, Random& random) {
    const auto [begin, end] = some_line(s, random);
    s.erase(begin, end - begin);
}

void move_line(std::string& s, Random& random) {
    const auto [begin, end] = some_line(s, random);
    const auto line = s.substr(begin, end - begin);
    s.erase(begin, end - begin);
    s.insert(some_line(s, random).first, line);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

void put_hostile_number(std::string& s, Random& random) {
    static const std::string hostile[] = {"nan",
                                          "-nan",
                                          "inf",
                                          "-inf",
                                          "1e308",
                                          "-1e308",
                                          "1e400",
                                          "1e-320",
                                          "0",
                                          "-0.0",
                                          "-1",
                                          "0x7f",
                                          "0b1",
                                          "1_000",
                                          "1.",
                                          ".5",
                                          "1e",
                                          "true",
                                          "\"1\"",
                                          "[]",
                                          "{}",
                                          "[1,2]",
                                          "''",
                                          "2147483648",
                                          "1e15",
                                          "65536",
                                          "99999999",
                                          "1e-300",
                                          "100000",
                                          "9223372036854775807",
                                          "9223372036854775808",
                                          std::string(400, '9')};
    const auto from = below(random, s.size());
    const auto begin = std::find_if(s.begin() + static_cast<std::ptrdiff_t>(from), s.end(), is_digit);
    const auto end =
        std::find_if(begin, s.end(), [](char c) { return !is_digit(c) && c != '.' && c != 'e'; });
    if (begin != s.end()) s.replace(begin, end, hostile[below(random, std::size(hostile))]);
}

void slip(std::string& s, Random& random) {
    static constexpr std::string_view keys = "0123456789.-[]\"=\n#eE_+xinfa{},'\\ \t\r";
    const char key = keys[below(random, keys.size())];
    if (s.empty() || random.below(2) == 0)
        s.insert(below(random, s.size() + 1), 1, key);
    else
        s[below(random, s.size())] = key;
}

}  // namespace

std::string mutate_bytes(const std::vector<std::string>& seeds, Random& random) {
    auto s = seeds[below(random, seeds.size())];
    for (auto n = 1 + random.below(8); n > 0; --n) {
        switch (random.below(8)) {
            case 0: erase_piece(s, random); break;
            case 1: splice(s, seeds, random); break;
            case 2: random.below(4) == 0 ? cut(s, random) : flip_bit(s, random); break;
            case 3: random.below(8) == 0 ? repeat(s, random) : flip_bit(s, random); break;
            case 4: put_striking_byte(s, random); break;
            default: flip_bit(s, random); break;
        }
    }
    return s;
}

std::string mutate_text(const std::vector<std::string>& seeds, Random& random) {
    auto s = seeds[below(random, seeds.size())];
    for (auto n = 1 + random.below(3); n > 0; --n) {
        switch (random.below(16)) {
            case 0: double_line(s, random); break;
            case 1: lose_line(s, random); break;
            case 2: move_line(s, random); break;
            case 3: erase_piece(s, random); break;
            case 4: random.below(3) == 0 ? cut(s, random) : slip(s, random); break;
            case 5: random.below(3) == 0 ? splice(s, seeds, random) : slip(s, random); break;
            case 6: random.below(3) == 0 ? repeat(s, random) : slip(s, random); break;
            case 7: put_striking_byte(s, random); break;
            case 8: flip_bit(s, random); break;
            case 9:
            case 10: slip(s, random); break;
            default: put_hostile_number(s, random); break;
        }
    }
    return s;
}

}  // namespace thaum::fuzz
