// Reads two hundred random NRRD files that use what real files use: types, encodings, byte orders, attached
// and detached data, several data files, skips, spaces, units, forms of placement, colours, vectors and time.
// The reader must give the values and positions with which the file was made. If teem's `teem-unu` is
// installed, it must read the same values; otherwise the test itself would misunderstand the format. Takes a
// tenth of a second, or two seconds with teem.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstring>

#include "core/random.h"
#include "unit/volume_files.h"

namespace thaum::field {
namespace {

constexpr int file_count = 200;
constexpr double mm = 1e-3;

struct TypeForm {
    const char* name;
    std::size_t bytes;
    bool is_signed, is_float;
};
constexpr std::array type_forms{
    TypeForm{"signed char", 1, true, false}, TypeForm{"uint8_t", 1, false, false},
    TypeForm{"short", 2, true, false},       TypeForm{"unsigned short int", 2, false, false},
    TypeForm{"int", 4, true, false},         TypeForm{"uint32", 4, false, false},
    TypeForm{"int64_t", 8, true, false},     TypeForm{"unsigned long long", 8, false, false},
    TypeForm{"float", 4, true, true},        TypeForm{"double", 8, true, true}};

struct SpaceForm {
    const char* line;
    vec3 sign;  ///< signs that convert the file's frame to ours
};
constexpr std::array space_forms{SpaceForm{"space: left-posterior-superior", {1, 1, 1}},
                                 SpaceForm{"space: RAS", {-1, -1, 1}},
                                 SpaceForm{"space: left-anterior-superior", {1, -1, 1}},
                                 SpaceForm{"space: scanner-xyz", {1, 1, 1}},
                                 SpaceForm{"space: 3D-right-handed", {1, 1, 1}},
                                 SpaceForm{"space: 3D-left-handed", {1, 1, -1}},
                                 SpaceForm{"space dimension: 3", {1, 1, 1}}};

struct UnitForm {
    const char* name;
    double metres;
};
constexpr std::array unit_forms{UnitForm{"", mm},     UnitForm{"mm", mm},   UnitForm{"m", 1},
                                UnitForm{"cm", 1e-2}, UnitForm{"um", 1e-6}, UnitForm{"millimeters", mm},
                                UnitForm{"Meter", 1}};

struct ExtraForm {
    const char* kind;
    int size;        ///< size of the axis that is not spatial; 0: any
    int components;  ///< number of components that the reader returns: 1 or 3
};
constexpr std::array extra_forms{ExtraForm{"", 1, 1},          ExtraForm{"time", 0, 1},
                                 ExtraForm{"RGB-color", 3, 1}, ExtraForm{"vector", 3, 3},
                                 ExtraForm{"3-vector", 3, 3},  ExtraForm{"covariant-vector", 3, 3}};

/// The contents of a random NRRD file, and the form in which they are written.
struct Case {
    const TypeForm* type{};
    const SpaceForm* space{};  ///< null: the file names no space (the frame of its coordinates)
    const UnitForm* unit{};
    const ExtraForm* extra{};
    int extra_size = 1, frame = 0;
    bool extra_is_last = false, is_big = false, has_origin = false, has_directions = false;
    std::array<int, 3> count{};
    std::array<vec3, 3> direction{};  ///< axis vectors in the file's frame and unit
    vec3 origin{};
    std::vector<double> values{};  ///< values in the order of the file
    std::string header{};

    bool is_4d() const { return extra->kind[0] != 0; }
    std::size_t at(std::array<int, 3> i, int e) const {
        const int inner = i[0] + count[0] * (i[1] + count[1] * i[2]), all = count[0] * count[1] * count[2];
        return static_cast<std::size_t>(extra_is_last ? inner + all * e : e + extra_size * inner);
    }
};

template <class Forms>
const auto& one_of(const Forms& forms, Random& random) {
    return forms.at(random.below(forms.size()));
}
bool chance(double share, Random& random) { return random.uniform() < share; }

template <class T>
void append_bytes(double value, bool is_big, std::string& out) {
    const auto exact = static_cast<T>(value);
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &exact, sizeof exact);
    if (is_big != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
    out.append(bytes.data(), bytes.size());
}

void append_value(const TypeForm& type, double value, bool is_big, std::string& out) {
    if (type.is_float)
        return type.bytes == 4 ? append_bytes<float>(value, is_big, out)
                               : append_bytes<double>(value, is_big, out);
    switch (type.bytes) {
        case 1: return append_bytes<std::int8_t>(value < 128 ? value : value - 256, is_big, out);
        case 2: return append_bytes<std::int16_t>(value, is_big, out);
        case 4: return append_bytes<std::int32_t>(value, is_big, out);
        default: return append_bytes<std::int64_t>(value, is_big, out);
    }
}

std::string words_of(const vec3& v) { return text("(", v.x, ",", v.y, ",", v.z, ")"); }

/// Values for the axes in the file's order; the axis that is not spatial gets `of_extra`.
std::string by_axis(const Case& c, const std::array<std::string, 3>& of_space, std::string_view of_extra) {
    std::string out;
    if (c.is_4d() && !c.extra_is_last) append_text(out, text(" ", of_extra));
    for (const auto& one : of_space) append_text(out, text(" ", one));
    if (c.is_4d() && c.extra_is_last) append_text(out, text(" ", of_extra));
    return out;
}

/// Draws three axes at right angles, each along one coordinate axis. In some cases two of them are rotated by
/// the angle of a 3-4-5 triangle, whose sine and cosine are the short decimals 0.6 and 0.8.
void draw_directions(Random& random, bool turned, Case& c) {
    std::array<int, 3> order{0, 1, 2};
    if (turned)
        for (std::size_t i = 2; i > 0; --i) std::swap(order.at(i), order.at(random.below(i + 1)));
    const bool tilted = turned && chance(0.4, random);
    for (std::size_t a = 0; a < 3; ++a) {
        vec3 unit(0);
        unit[order.at(a)] = turned && chance(0.5, random) ? -1 : 1;
        if (tilted) unit = {0.6 * unit.x - 0.8 * unit.y, 0.8 * unit.x + 0.6 * unit.y, unit.z};
        c.direction.at(a) = static_cast<double>(1 + random.below(8)) * 0.25 * unit;
    }
}

/// Header lines that say where the samples lie.
std::string place_lines(Random& random, Case& c) {
    std::string lines = c.space != nullptr ? text(c.space->line, "\n") : "";
    c.has_directions = c.space != nullptr && chance(0.6, random);
    c.has_origin = c.space != nullptr && chance(0.7, random);
    draw_directions(random, c.has_directions, c);
    std::array<std::string, 3> vectors, spacings, lows, highs;
    for (std::size_t a = 0; a < 3; ++a) {
        const double spacing = glm::length(c.direction.at(a));
        vectors.at(a) = words_of(c.direction.at(a));
        spacings.at(a) = text(spacing);
        lows.at(a) = "1";
        highs.at(a) = text(1 + spacing * (c.count.at(a) - 1));
    }
    const std::array<std::string, 3> nans{"nan", "NaN", "nan"}, nodes{"node", "node", "node"};
    if (c.has_directions) {
        append_text(lines, text("space directions:", by_axis(c, vectors, "none"), "\n"));
        if (chance(0.3, random)) append_text(lines, text("spacings:", by_axis(c, nans, "nan"), "\n"));
    } else if (chance(0.7, random)) {
        append_text(lines, text("spacings:", by_axis(c, spacings, "nan"), "\n"));
    } else {
        append_text(lines, text("axis mins:", by_axis(c, lows, "nan"), "\naxis maxs:",
                                by_axis(c, highs, "nan"), "\ncenters:", by_axis(c, nodes, "???"), "\n"));
    }
    if (c.has_origin) {
        c.origin = {std::floor(random.uniform(-50, 50)), 0.5, std::floor(random.uniform(-50, 50))};
        append_text(lines, text("space origin: ", words_of(c.origin), "\n"));
    }
    const auto quoted = text("\"", c.unit->name, "\"");
    if (c.unit->name[0] == 0) return lines;
    if (c.space != nullptr) return text(lines, "space units: ", quoted, " ", quoted, " ", quoted, "\n");
    return text(lines, "units:", by_axis(c, {quoted, quoted, quoted}, "\"\""), "\n");
}

Case draw_case(Random& random) {
    Case c{.type = &one_of(type_forms, random),
           .unit = &one_of(unit_forms, random),
           .extra = &one_of(extra_forms, random)};
    if (chance(0.8, random)) c.space = &one_of(space_forms, random);
    c.is_big = chance(0.4, random);
    for (int& n : c.count) n = static_cast<int>(2 + random.below(4));
    if (c.is_4d()) {
        c.extra_size = c.extra->size > 0 ? c.extra->size : static_cast<int>(1 + random.below(4));
        c.extra_is_last = chance(0.5, random);
    }
    if (c.extra->size == 0)
        c.frame = static_cast<int>(random.below(static_cast<std::uint64_t>(c.extra_size)));
    std::size_t all = static_cast<std::size_t>(c.extra_size);
    for (const int n : c.count) all *= static_cast<std::size_t>(n);
    const double low = c.type->is_signed ? -100 : 0,
                 high = c.type->bytes == 1 && c.type->is_signed ? 127 : 250;
    for (std::size_t i = 0; i < all; ++i)
        c.values.push_back(c.type->is_float ? 0.125 * std::floor(random.uniform(-8000, 8000))
                                            : std::floor(random.uniform(low, high)));
    std::array<std::string, 3> sizes;
    for (std::size_t a = 0; a < 3; ++a) sizes.at(a) = text(c.count.at(a));
    c.header = text("NRRD0005\n", chance(0.3, random) ? "# a comment\n" : "", "type: ", c.type->name,
                    "\ndimension: ", c.is_4d() ? 4 : 3, "\n", place_lines(random, c),
                    "sizes:", by_axis(c, sizes, text(c.extra_size)), "\n");
    if (c.is_4d() || chance(0.3, random))
        append_text(c.header,
                    text("kinds:", by_axis(c, {"domain", "domain", "domain"}, c.extra->kind), "\n"));
    if (chance(0.3, random)) c.header += "content: a random volume\n";
    if (chance(0.3, random)) c.header += "a key:=a value: with \\n a colon\n";
    return c;
}

/// The samples from number `from` to number `to`, encoded as the file has them.
std::string samples_of(const Case& c, std::string_view encoding, std::size_t from, std::size_t to) {
    std::string out;
    for (std::size_t i = from; i < to; ++i) {
        if (encoding == "ascii")
            append_text(out, text(c.values[i], i % 7 == 6 ? "\n" : " "));
        else
            append_value(*c.type, c.values[i], c.is_big, out);
    }
    return out;
}

class RandomNrrd : public VolumeFiles {
protected:
    /// Writes the file or files of a case; returns the header's path.
    fs::path write(Random& random, Case& c) const {
        static constexpr std::array encodings{"raw", "gzip", "ascii"};
        const std::string encoding = one_of(encodings, random);
        c.header += text("encoding: ", encoding, "\n");
        if (c.type->bytes > 1 && encoding != "ascii")
            c.header += text("endian: ", c.is_big ? "big" : "little", "\n");
        const bool several = chance(0.3, random);
        // In NRRD, `line skip` counts lines of the stored file, `byte skip` bytes of the unpacked data.
        std::string skipped_line, skipped_bytes;
        if (chance(0.3, random)) {
            c.header += "line skip: 1\n";
            skipped_line = "a line of another program\n";
        }
        if (encoding != "ascii" && chance(0.3, random)) {
            c.header += "byte skip: 3\n";
            skipped_bytes = "\x01\x02\x03";
        }
        const auto packed = [&](std::size_t from, std::size_t to) {
            const auto plain = skipped_bytes + samples_of(c, encoding, from, to);
            return skipped_line + (encoding == "gzip" ? gzipped(plain) : plain);
        };
        if (several) return write_several(random, c, packed);
        if (chance(0.5, random)) return put("v.nrrd", text(c.header, "\n", packed(0, c.values.size())));
        put("v.data", packed(0, c.values.size()));
        return put("v.nhdr", text(c.header, "data file: v.data\n"));
    }

    /// Writes one file for each slice along the slowest axis.
    template <class Packed>
    fs::path write_several(Random& random, const Case& c, const Packed& packed) const {
        const auto slices =
            static_cast<std::size_t>(c.is_4d() && c.extra_is_last ? c.extra_size : c.count[2]);
        const std::size_t of_one = c.values.size() / slices;
        const bool pattern = chance(0.5, random);
        std::string names;
        for (std::size_t i = 0; i < slices; ++i) {
            const auto name = text("s", i < 9 ? "0" : "", i + 1, ".data");
            put(name, packed(i * of_one, (i + 1) * of_one));
            append_text(names, text(name, "\n"));
        }
        return put("v.nhdr", pattern ? text(c.header, "data file: s%02d.data 1 ", slices, " 1\n")
                                     : text(c.header, "data file: LIST\n", names));
    }
};

/// The value that the reader must give for sample `i`: its components in our frame, or a colour's luminance.
vec3 right_value(const Case& c, std::array<int, 3> i) {
    const auto value = [&](int e) { return static_cast<double>(static_cast<float>(c.values[c.at(i, e)])); };
    if (c.extra->components == 3)
        return (c.space != nullptr ? c.space->sign : vec3(1)) * vec3(value(0), value(1), value(2));
    if (c.extra->size == 3) return vec3(0.2126 * value(0) + 0.7152 * value(1) + 0.0722 * value(2), 0, 0);
    return vec3(value(c.frame), 0, 0);
}

/// Fault of a volume that was read; empty: none. Each of its samples must have the value of the file's sample
/// at that position. If the file has no origin, both volumes must have the same middle.
std::string fault_of(const Case& c, const Volume& v) {
    if (v.has_place != c.has_origin) return "another origin";
    const vec3 sign = c.space != nullptr ? c.space->sign : vec3(1);
    vec3 half(0);
    for (std::size_t a = 0; a < 3; ++a) half += 0.5 * (c.count.at(a) - 1) * c.direction.at(a);
    const vec3 shift = c.has_origin ? vec3(0) : v.placement.origin - c.unit->metres * (sign * half);
    std::size_t next = 0, found = 0;
    for (int k = 0; k < v.count[2]; ++k)
        for (int j = 0; j < v.count[1]; ++j)
            for (int i = 0; i < v.count[0]; ++i) {
                vec3 value(0);
                for (int e = 0; e < v.components; ++e) value[e] = static_cast<double>(v.samples[next++]);
                if (v.components == 3) value = v.placement.turn * value;
                const vec3 place = to_parent(v.placement, v.place(i, j, k));
                for (int z = 0; z < c.count[2]; ++z)
                    for (int y = 0; y < c.count[1]; ++y)
                        for (int x = 0; x < c.count[0]; ++x) {
                            const vec3 own = c.origin + static_cast<double>(x) * c.direction[0] +
                                             static_cast<double>(y) * c.direction[1] +
                                             static_cast<double>(z) * c.direction[2];
                            if (glm::distance(place, shift + c.unit->metres * (sign * own)) >
                                1e-6 * c.unit->metres)
                                continue;
                            ++found;
                            const vec3 right = right_value(c, {x, y, z});
                            if (glm::distance(value, right) > 1e-6 * std::max(1.0, glm::length(right)))
                                return text("another value at ", words_of(place));
                        }
            }
    return found == next / static_cast<std::size_t>(v.components) ? "" : "samples at other places";
}

/// Values that teem reads, in the file's order.
std::vector<double> values_by_teem(const fs::path& file) {
    const auto command =
        text("teem-unu convert -t double -i '", file.string(), "' | teem-unu save -f nrrd -e raw 2>&1");
    std::string out;
    std::array<char, 4096> part{};
    auto* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return {};
    while (const auto n = std::fread(part.data(), 1, part.size(), pipe)) out.append(part.data(), n);
    ::pclose(pipe);
    const auto start = std::min(out.find("\n\n"), out.size() - 2) + 2;
    std::vector<double> values((out.size() - start) / sizeof(double));
    std::memcpy(values.data(), out.data() + start, values.size() * sizeof(double));
    return values;
}

TEST_F(RandomNrrd, TwoHundredFilesHaveTheirValuesAndPlaces) {
    const bool teem = std::system("command -v teem-unu >/dev/null 2>&1") == 0;
    auto random = random_stream(43, 1);
    for (int number = 0; number < file_count; ++number) {
        auto c = draw_case(random);
        const auto file = write(random, c);
        const auto volume = read_nrrd(file, {.frame = c.frame}).value();
        EXPECT_EQ(fault_of(c, volume), "") << c.header;
        if (teem) {
            EXPECT_EQ(values_by_teem(file), c.values) << c.header;
        }
        if (HasFailure()) break;
    }
}

}  // namespace
}  // namespace thaum::field
