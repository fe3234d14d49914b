#include "field/detail/nrrd_header.h"

#include <algorithm>
#include <cmath>

#include "core/one_line.h"
#include "core/text.h"
#include "field/detail/nrrd_fields.h"

namespace thaum::field {
namespace {

constexpr double shortest = 1e-9, longest = 1e3;  ///< spacings outside this range are refused (m)
constexpr double farthest = 1e6;                  ///< an origin farther away than this is refused (m)
constexpr std::size_t max_axes = 5;
constexpr std::size_t max_files = 100'000;

enum class Role : std::uint8_t { space, component, time };

struct Axis {
    long size = 1;
    Role role = Role::space;
};

/// Axes of the file: three of space, at most one of components, at most one of time.
struct Axes {
    std::vector<Axis> all;
    std::array<std::size_t, 3> in_space{};  ///< index of each axis of space in the file
};

void read_type(NrrdFields& fields, NrrdHeader& header) {
    header.type = static_cast<SampleType>(
        fields.choice("type", "int8, uint8, int16, uint16, int32, uint32, int64, uint64, float or double",
                      {{"int8", "signed char", "int8_t"},
                       {"uint8", "uchar", "unsigned char", "uint8_t"},
                       {"int16", "short", "short int", "signed short", "signed short int", "int16_t"},
                       {"uint16", "ushort", "unsigned short", "unsigned short int", "uint16_t"},
                       {"int32", "int", "signed int", "int32_t"},
                       {"uint32", "uint", "unsigned int", "uint32_t"},
                       {"int64", "longlong", "long long", "long long int", "signed long long",
                        "signed long long int", "int64_t"},
                       {"uint64", "ulonglong", "unsigned long long", "unsigned long long int", "uint64_t"},
                       {"float"},
                       {"double"}}));
    header.encoding = static_cast<NrrdEncoding>(
        fields.choice("encoding", "raw, gzip or ascii", {{"raw"}, {"gzip", "gz"}, {"ascii", "text", "txt"}}));
    const bool one_byte = header.type == SampleType::int8 || header.type == SampleType::uint8;
    const bool in_bytes = !one_byte && header.encoding != NrrdEncoding::ascii;
    if (in_bytes || fields.has("endian"))
        header.big_endian = fields.choice("endian", "little or big", {{"little"}, {"big"}}) == 1;
}

// ---- axes -------------------------------------------------------------------------------------------------

/// A kind of axis that can be read: its role, and the number of samples that such an axis must have (0: any
/// number).
struct KindOfAxis {
    std::string_view name;
    Role role{};
    long size{};
    NrrdColour colour{};
};

constexpr std::array kinds_read{
    KindOfAxis{"domain", Role::space},
    KindOfAxis{"space", Role::space},
    KindOfAxis{"time", Role::time},
    KindOfAxis{"stub", Role::component, 1},
    KindOfAxis{"scalar", Role::component, 1},
    KindOfAxis{"vector", Role::component, 3},
    KindOfAxis{"covariant-vector", Role::component, 3},
    KindOfAxis{"normal", Role::component, 3},
    KindOfAxis{"3-vector", Role::component, 3},
    KindOfAxis{"3-gradient", Role::component, 3},
    KindOfAxis{"3-normal", Role::component, 3},
    KindOfAxis{"3-color", Role::component, 3, NrrdColour::red_green_blue},
    KindOfAxis{"rgb-color", Role::component, 3, NrrdColour::red_green_blue},
    KindOfAxis{"4-color", Role::component, 4, NrrdColour::red_green_blue},
    KindOfAxis{"rgba-color", Role::component, 4, NrrdColour::red_green_blue},
    KindOfAxis{"hsv-color", Role::component, 3, NrrdColour::value_last},
    KindOfAxis{"xyz-color", Role::component, 3, NrrdColour::luminance_second},
};

const KindOfAxis* kind_of(std::string_view word) {
    const auto lower = in_lower_case(word);
    const auto found = std::ranges::find(kinds_read, lower, &KindOfAxis::name);
    return found == kinds_read.end() ? nullptr : &*found;
}

bool is_unknown(std::string_view kind) {
    const auto lower = in_lower_case(kind);
    return lower == "???" || lower == "none" || lower == "unknown";
}

void read_sizes(NrrdFields& fields, std::size_t limit, NrrdHeader& header, Axes& axes) {
    if (!fields.has("dimension")) fields.report("dimension", "a volume has 'dimension: 3'");
    axes.all.resize(static_cast<std::size_t>(fields.integer("dimension", 3, max_axes, 3)));
    const auto sizes = fields.numbers("sizes", axes.all.size());
    std::size_t product = 1;
    for (std::size_t a = 0; a < axes.all.size(); ++a) {
        const double size = sizes[a].value_or(0);
        const bool whole = size >= 1 && size <= 1e9 && size == std::floor(size);
        if (!whole) fields.report("sizes", "a size is not a whole number from 1 on");
        if (whole && static_cast<std::size_t>(size) > limit / product) {
            fields.report("sizes", text("more than ", limit, " samples; make the volume smaller"));
        } else if (whole) {
            axes.all[a].size = static_cast<long>(size);
            product *= static_cast<std::size_t>(size);
        }
    }
    header.stored = product;
}

/// Gives an axis the role that its kind means, and notes in the header what the kind says about colours.
void take_kind(NrrdFields& fields, std::string_view word, Axis& axis, NrrdHeader& header) {
    const auto* kind = kind_of(word);
    // An axis with a single sample needs no role, whatever its kind, such as a list.
    const bool of_one = axis.size == 1 && !is_unknown(word);
    if (kind == nullptr && !of_one) {
        fields.report(
            "kinds", text("an axis of the kind '", printable(word, 40), "' cannot be read; ",
                          in_lower_case(word) == "list" ? "write 'time', 'vector' or 'RGB-color' if it is one"
                                                        : "a volume has three of space, and may have one of "
                                                          "components (vector, colour) and one of time"));
        return;
    }
    axis.role = kind == nullptr ? Role::component : kind->role;
    if (kind != nullptr && kind->role == Role::component && axis.size != 1 && axis.size != kind->size)
        fields.report("sizes", text("an axis of the kind '", kind->name, "' is read only with ", kind->size,
                                    " samples, not ", axis.size));
    if (kind != nullptr && axis.size != 1) header.colour = std::max(header.colour, kind->colour);
}

/// The line "kinds" with one more kind than the three of space, such as 'kinds: vector domain domain domain'.
std::string kinds_with(std::string_view kind, std::size_t at, std::size_t axes) {
    std::string line = "'kinds:";
    for (std::size_t a = 0; a < axes; ++a) append_text(line, text(' ', a == at ? kind : "domain"));
    return line + "'";
}

/// Treats an axis as that of a sample's components, though the header does not give its kind. Three or four
/// bytes are a colour, because bytes have no sign, which parts of a vector need.
void take_unknown_axis(NrrdFields& fields, std::size_t at, Axes& axes, NrrdHeader& header) {
    auto& axis = axes.all[at];
    axis.role = Role::component;
    if (axis.size == 1) return;
    const auto untold = text("'kinds' does not tell what the ", axis.size, " samples of axis ", at, " are; ");
    const bool is_colour = header.type == SampleType::uint8 && (axis.size == 3 || axis.size == 4);
    if (!is_colour && axis.size != 3) {
        fields.report("sizes",
                      text(untold, "only scalars, vectors of 3, and colours can be read without it"));
        return;
    }
    header.is_colour_by_guess = is_colour;
    if (is_colour) header.colour = NrrdColour::red_green_blue;
    const auto taken = is_colour ? "they are taken as red, green and blue, of which the luminance is read"
                                 : "they are taken as the parts of a vector";
    const auto other = is_colour ? text("for a vector write ", kinds_with("vector", at, axes.all.size()))
                                 : text("for colours write ", kinds_with("RGB-color", at, axes.all.size()));
    header.notes.push_back(text(untold, taken, axis.size == 4 ? "" : text("; ", other)));
}

/// The only axis for which a field of the header gives no value; std::nullopt: there is none, or there are
/// several.
template <class Value>
std::optional<std::size_t> axis_without(const std::vector<std::optional<Value>>& values) {
    const auto none = std::ranges::find_if_not(values, &std::optional<Value>::has_value);
    if (std::ranges::count(values, std::optional<Value>{}) != 1) return {};
    return static_cast<std::size_t>(none - values.begin());
}

/// Finds the axis beyond the three of space whose kind the header does not give: the one without a direction
/// or without a spacing, or else the first, where most programs put it.
void find_component_axis(NrrdFields& fields, Axes& axes, NrrdHeader& header) {
    std::optional<std::size_t> at;
    if (fields.has("spacedirections")) at = axis_without(fields.vectors("spacedirections", axes.all.size()));
    if (!at && fields.has("spacings")) at = axis_without(fields.numbers("spacings", axes.all.size()));
    take_unknown_axis(fields, at.value_or(0), axes, header);
}

Axes read_axes(NrrdFields& fields, std::size_t limit, NrrdHeader& header) {
    Axes axes;
    read_sizes(fields, limit, header, axes);
    const auto kinds = fields.words("kinds");
    bool any_unknown = kinds.empty();
    if (fields.has("kinds") && kinds.size() != axes.all.size()) {
        fields.report("kinds", text(kinds.size(), " kinds for ", axes.all.size(), " axes"));
    } else {
        for (std::size_t a = 0; a < kinds.size(); ++a) {
            if (is_unknown(kinds[a]))
                any_unknown = true;
            else
                take_kind(fields, kinds[a], axes.all[a], header);
        }
    }
    const auto count = [&](Role role) { return std::ranges::count(axes.all, role, &Axis::role); };
    if (count(Role::space) == 4 && any_unknown) find_component_axis(fields, axes, header);
    if (count(Role::space) > 3 && any_unknown)
        fields.report(fields.has("kinds") ? "kinds" : "dimension",
                      text("'kinds' does not tell which of the ", axes.all.size(),
                           " axes are space, components and time"));
    if (count(Role::space) != 3 || count(Role::component) > 1 || count(Role::time) > 1)
        fields.report(fields.has("kinds") ? "kinds" : "dimension",
                      "a volume has three axes of space, and may have one of components and one of time");
    std::size_t n = 0;
    for (std::size_t a = 0; a < axes.all.size() && n < 3; ++a)
        if (axes.all[a].role == Role::space) axes.in_space[n++] = a;
    return axes;
}

void keep_axes(const Axes& axes, NrrdHeader& header) {
    std::ptrdiff_t step = 1;
    std::size_t n = 0;
    for (const auto& axis : axes.all) {
        switch (axis.role) {
            case Role::space:
                if (n == 3) break;
                header.sizes[n] = static_cast<int>(axis.size);
                header.stride[n++] = step;
                break;
            case Role::component:
                header.components = axis.size == 1 ? 1 : 3;
                header.component_stride = step;
                break;
            case Role::time:
                header.frames = static_cast<int>(axis.size);
                header.frame_stride = step;
                break;
        }
        step *= axis.size;
    }
}

// ---- space ------------------------------------------------------------------------------------------------

/// A unit of length, as the number of units in a metre. Lengths are divided by it, because 2 / 1000 rounds
/// like the number 0.002.
struct Unit {
    std::string_view words;  ///< names of the unit in lower case, separated by blanks
    double in_a_metre{};
};

constexpr std::array units_read{
    Unit{" mm millimeter millimeters millimetre millimetres ", 1000},
    Unit{" m meter meters metre metres ", 1},
    Unit{" cm centimeter centimeters centimetre centimetres ", 100},
    Unit{" um \xc2\xb5m \xce\xbcm \xb5m micron microns micrometer micrometers micrometre micrometres ", 1e6},
    Unit{" nm nanometer nanometers nanometre nanometres ", 1e9},
    Unit{" in inch inches ", 1 / 0.0254},
};

/// Converts lengths of the header to metres by the units that a field names. A word that is no unit of
/// length, such as "pixel", counts as no unit, and the user gets a note.
class Lengths {
public:
    Lengths(NrrdHeader& header, std::vector<std::string> units) : header_(header), units_(std::move(units)) {}

    double metres(std::size_t axis, double length) {
        const auto word = in_lower_case(axis < units_.size() ? units_[axis] : std::string());
        if (word.empty() || word == "???" || word == "none") return length / units_read[0].in_a_metre;
        const auto found = std::ranges::find_if(units_read, [&](const Unit& unit) {
            return word.find(' ') == std::string::npos &&
                   unit.words.find(text(' ', word, ' ')) != std::string_view::npos;
        });
        if (found != units_read.end()) return length / found->in_a_metre;
        const auto note =
            text("'", printable(units_[axis], 60), "' is no unit of length, so lengths are taken as mm");
        if (std::ranges::find(header_.notes, note) == header_.notes.end()) header_.notes.push_back(note);
        return length / units_read[0].in_a_metre;
    }

private:
    NrrdHeader& header_;
    std::vector<std::string> units_;
};

/// Reads the frame of space. Returns the factor for each axis, 1 or -1, that makes the frame right-handed
/// and, for a patient, left-posterior-superior.
vec3 read_space(NrrdFields& fields, NrrdHeader& header) {
    if (fields.has("spacedimension")) (void)fields.integer("spacedimension", 3, 3, 3);
    header.is_in_space = fields.has("space") || fields.has("spacedimension");
    if (!fields.has("space")) return vec3(1);
    const std::size_t space = fields.choice("space", "a space of three axes, such as left-posterior-superior",
                                            {{"left-posterior-superior", "LPS"},
                                             {"right-anterior-superior", "RAS"},
                                             {"left-anterior-superior", "LAS"},
                                             {"scanner-xyz", "3D-right-handed"},
                                             {"3D-left-handed"}});
    header.is_of_patient = space < 3;
    constexpr std::array signs{vec3{1, 1, 1}, vec3{-1, -1, 1}, vec3{1, -1, 1}, vec3{1, 1, 1}, vec3{1, 1, -1}};
    return signs[space];
}

/// Numbers of a field for all axes of the file; all std::nullopt if the header lacks the field.
std::vector<std::optional<double>> numbers_if_there(NrrdFields& fields, std::string_view field,
                                                    const Axes& axes) {
    if (!fields.has(field)) return std::vector<std::optional<double>>(axes.all.size());
    return fields.numbers(field, axes.all.size());
}

/// Spacings that follow from the ends of the axes, the fields "axis mins" and "axis maxs". A node-centred
/// axis has a sample at each end; otherwise the samples are the middles of cells between the ends, as the
/// format says.
std::vector<std::optional<double>> spacings_of_ends(NrrdFields& fields, const Axes& axes) {
    const auto low = numbers_if_there(fields, "axismins", axes),
               high = numbers_if_there(fields, "axismaxs", axes);
    const auto centres = fields.words(fields.has("centers") ? "centers" : "centerings");
    std::vector<std::optional<double>> spacing(axes.all.size());
    for (std::size_t a = 0; a < axes.all.size(); ++a) {
        const bool nodes = a < centres.size() && in_lower_case(centres[a]) == "node";
        if (low[a] && high[a])
            spacing[a] = (*high[a] - *low[a]) / static_cast<double>(axes.all[a].size - (nodes ? 1 : 0));
    }
    return spacing;
}

/// Directions that the header gives for the axes of space: one for each axis, or none at all.
std::array<std::optional<vec3>, 3> read_directions(NrrdFields& fields, const Axes& axes) {
    std::array<std::optional<vec3>, 3> of_space{};
    if (!fields.has("spacedirections")) return of_space;
    const auto all = fields.vectors("spacedirections", axes.all.size());
    for (std::size_t a = 0; a < 3; ++a) of_space[a] = all[axes.in_space[a]];
    if (std::ranges::any_of(of_space, &std::optional<vec3>::has_value)) {
        if (!std::ranges::all_of(of_space, &std::optional<vec3>::has_value))
            fields.report("spacedirections", "an axis of space has no direction");
        if (!fields.has("space") && !fields.has("spacedimension"))
            fields.report("spacedirections", "the header also needs 'space' or 'space dimension: 3'");
    }
    return of_space;
}

/// Spacings of the axes of the file: those given directly, and those that follow from the ends of the axes.
struct Spacings {
    std::vector<std::optional<double>> given, of_ends;
};

/// Adds a note for the user if the fields "axis mins" and "axis maxs" are ignored in part or whole. In part:
/// only the spacings that follow from them are used, not the position. In whole: other fields override them.
void note_ends(NrrdFields& fields, const Axes& axes, const Spacings& spacings, bool has_directions,
               NrrdHeader& header) {
    const auto low = numbers_if_there(fields, "axismins", axes);
    bool give_spacings = false, at_zero = true, differ = false;
    for (const std::size_t axis : axes.in_space) {
        const auto& given = spacings.given[axis];
        const auto& of_ends = spacings.of_ends[axis];
        give_spacings = give_spacings || (!has_directions && !given && of_ends);
        at_zero = at_zero && low[axis].value_or(0) == 0;
        const bool differs = of_ends && given && !(std::abs(*of_ends - *given) <= 1e-6 * std::abs(*given));
        differ = differ || differs || (has_directions && of_ends);
    }
    if (give_spacings && !at_zero)
        header.notes.emplace_back(
            "'axis mins' and 'axis maxs' give only the spacings; a place needs 'space' and 'space origin'");
    else if (!give_spacings && (differ || !at_zero))
        header.notes.emplace_back(
            "'axis mins' and 'axis maxs' have no effect beside the other fields of space");
}

/// Reads where the samples lie, and stores it in the header: directions, or else spacings along the axes of
/// space, and the origin.
void read_place(NrrdFields& fields, const Axes& axes, vec3 sign, NrrdHeader& header) {
    const auto directions = read_directions(fields, axes);
    const Spacings spacings{numbers_if_there(fields, "spacings", axes), spacings_of_ends(fields, axes)};
    const bool has_directions = directions[0].has_value();
    std::vector<std::string> space_unit, axis_unit;
    if (fields.has("spaceunits")) space_unit = fields.quoted("spaceunits", 3);
    if (fields.has("units")) axis_unit = fields.quoted("units", axes.all.size());
    const bool by_axis = !has_directions && !axis_unit.empty();
    Lengths in_space(header, space_unit);
    Lengths along_axes(header, by_axis ? axis_unit : space_unit);
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t from = axes.in_space[a];
        const int i = static_cast<int>(a);
        vec3 direction(0);
        if (has_directions) {
            for (int k = 0; k < 3; ++k)
                direction[k] = sign[k] * in_space.metres(static_cast<std::size_t>(k),
                                                         directions[a].value_or(vec3(1))[k]);
            if (spacings.given[from])
                fields.report("spacings", "an axis of space also has a direction; keep one");
        } else {
            direction[i] = sign[i] * along_axes.metres(
                                         by_axis ? from : a,
                                         spacings.given[from].value_or(spacings.of_ends[from].value_or(1.0)));
        }
        header.direction[a] = direction;
    }
    note_ends(fields, axes, spacings, has_directions, header);
    if (!fields.has("spaceorigin")) return;
    if (!header.is_in_space)
        fields.report("spaceorigin", "the header also needs 'space' or 'space dimension: 3'");
    if (const auto origin = fields.vectors("spaceorigin", 1).front()) {
        vec3 first(0);
        for (int k = 0; k < 3; ++k)
            first[k] = sign[k] * in_space.metres(static_cast<std::size_t>(k), (*origin)[k]);
        header.first = first;
    }
}

void check_lengths(NrrdFields& fields, const NrrdHeader& header) {
    const char* field = fields.has("spacedirections") ? "spacedirections"
                        : fields.has("spacings")      ? "spacings"
                        : fields.has("axismaxs")      ? "axismaxs"
                                                      : "spacings";
    for (const vec3& direction : header.direction) {
        const double length = glm::length(direction);
        if (!(length >= shortest && length <= longest))
            fields.report(field, "a spacing is not a number from 1e-9 to 1e3 m");
    }
    if (header.first && !(glm::length(*header.first) <= farthest))
        fields.report("spaceorigin", "the origin is farther away than 1e6 m");
}

void read_frame_of_values(NrrdFields& fields, vec3 sign, NrrdHeader& header) {
    mat3 frame(1.0);
    if (fields.has("measurementframe")) {
        const auto columns = fields.vectors("measurementframe", 3);
        for (int i = 0; i < 3; ++i) frame[i] = columns[static_cast<std::size_t>(i)].value_or(vec3(0));
    }
    for (int i = 0; i < 3; ++i) {
        if (!(glm::length(frame[i]) <= farthest)) fields.report("measurementframe", "a number is beyond 1e6");
        header.of_values[i] = sign * frame[i];
    }
    if (header.components == 3 && !(std::abs(glm::determinant(frame)) > 0))
        fields.report("measurementframe", "its vectors do not span space; remove it or correct it");
    // Colours are not vectors in space, so they must not be turned.
    if (header.colour != NrrdColour::none || header.components == 1) header.of_values = mat3(0.0);
}

// ---- the samples' files -----------------------------------------------------------------------------------

/// Files named by a pattern with numbers: "slice%03d.raw 1 40 1".
struct FilePattern {
    std::string_view before, after;
    int digits{};
    bool with_zeros{};
    long from{}, to{}, step{};
};

std::optional<FilePattern> parse_pattern(const std::vector<std::string_view>& words) {
    if (words.size() < 4 || words.size() > 5) return {};
    FilePattern pattern;
    const auto name = words[0];
    const auto percent = name.find('%');
    const auto letter = name.find_first_not_of("0123456789", percent + 1);
    if (percent == std::string_view::npos || letter == std::string_view::npos) return {};
    if (name[letter] != 'd' && name[letter] != 'i' && name[letter] != 'u') return {};
    pattern.before = name.substr(0, percent);
    pattern.after = name.substr(letter + 1);
    const auto digits = name.substr(percent + 1, letter - percent - 1);
    pattern.with_zeros = digits.starts_with('0');
    if (digits.size() > 3) return {};
    pattern.digits = digits.empty() ? 0 : static_cast<int>(number_of(digits));
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) {
        numbers[i] = number_of(words[i + 1]);
        if (!(std::abs(numbers[i]) <= 1e9) || numbers[i] != std::floor(numbers[i])) return {};
    }
    pattern.from = static_cast<long>(numbers[0]);
    pattern.to = static_cast<long>(numbers[1]);
    pattern.step = static_cast<long>(numbers[2]);
    const long way = pattern.to - pattern.from;
    if (pattern.step == 0 || way * pattern.step < 0) return {};
    if (pattern.after.find('%') != std::string_view::npos) return {};
    return pattern;
}

std::string file_of(const FilePattern& pattern, long number) {
    auto digits = text(std::abs(number));
    const auto width = static_cast<std::size_t>(pattern.digits) - (number < 0 && pattern.digits > 0 ? 1 : 0);
    if (digits.size() < width) digits.insert(0, width - digits.size(), pattern.with_zeros ? '0' : ' ');
    return text(pattern.before, number < 0 ? "-" : "", digits, pattern.after);
}

void read_data_files(NrrdFields& fields, NrrdHeader& header) {
    const auto words = fields.words("datafile");
    const std::size_t line = fields.line_of("datafile");
    if (fields.has("datafile") && words.empty()) fields.report("datafile", "it names no file");
    if (words.empty()) return;
    if (fields.lists_files()) {
        for (const auto& listed : fields.listed_files())
            header.data_files.push_back({listed.name, listed.line});
        if (header.data_files.empty()) fields.report("datafile", "no names of files follow LIST");
    } else if (words[0].find('%') != std::string_view::npos && words.size() > 1) {
        const auto pattern = parse_pattern(words);
        if (!pattern) {
            fields.report("datafile", "a pattern of files is like 'slice%03d.raw 1 40 1': from, to, step");
            return;
        }
        const long last =
            std::min((pattern->to - pattern->from) / pattern->step, static_cast<long>(max_files));
        for (long i = 0; i <= last; ++i)
            header.data_files.push_back({file_of(*pattern, pattern->from + i * pattern->step), line});
    } else {
        header.data_files.push_back({std::string(fields.text_of("datafile")), line});
    }
    if (header.data_files.size() > max_files)
        fields.report("datafile", text("more than ", max_files, " files"));
    if (!header.data_files.empty() && header.stored % header.data_files.size() != 0)
        fields.report("datafile", text(header.stored, " samples cannot lie in ", header.data_files.size(),
                                       " equal files"));
}

void read_place_of_data(NrrdFields& fields, NrrdHeader& header) {
    read_data_files(fields, header);
    if (!fields.has("datafile") && !fields.end())
        fields.report("datafile", "the file ends with its header, without samples");
    header.data_at = fields.end().value_or(0);
    header.skipped_lines = static_cast<std::size_t>(fields.integer("lineskip", 0, 1'000'000'000, 0));
    header.skipped_bytes = fields.integer("byteskip", -1, 1'000'000'000, 0);
    if (header.encoding == NrrdEncoding::ascii && header.skipped_bytes < 0)
        fields.report("byteskip", "numbers in text do not end the file at a known byte");
}

/// Adds a note for the user that names the fields of the header that have no effect.
void note_unused(const NrrdFields& fields, NrrdHeader& header) {
    std::string unused;
    for (const auto& [field, written] : {std::pair{"labels", "labels"},
                                         {"thicknesses", "thicknesses"},
                                         {"min", "min"},
                                         {"max", "max"},
                                         {"oldmin", "old min"},
                                         {"oldmax", "old max"},
                                         {"blocksize", "block size"}})
        if (fields.has(field)) append_text(unused, text(unused.empty() ? "" : ", ", written));
    const bool unit_of_axes = fields.has("units") && fields.has("spacedirections");
    if (unit_of_axes) append_text(unused, unused.empty() ? "units" : ", units");
    if (!unused.empty()) header.notes.push_back(text("these fields of the header have no effect: ", unused));
}

}  // namespace

Expected<NrrdHeader> parse_nrrd_header(std::string_view file, const std::string& name, std::size_t limit) {
    auto fields = NrrdFields::parse(file, name);
    if (!fields) return fields.error();
    NrrdHeader header;
    read_type(*fields, header);
    const Axes axes = read_axes(*fields, limit, header);
    keep_axes(axes, header);
    const vec3 sign = read_space(*fields, header);
    read_place(*fields, axes, sign, header);
    check_lengths(*fields, header);
    read_frame_of_values(*fields, sign, header);
    read_place_of_data(*fields, header);
    note_unused(*fields, header);
    header.name = printable(fields->text_of("content"), 200);
    header.units = printable(fields->text_of("sampleunits"), 60);
    header.save_name = printable(fields->text_of(key_of_save), 60);
    if (auto checked = fields->check(); !checked) return checked.error();
    header.path = name;
    header.lines = fields->lines();
    return header;
}

Error fail_field(const NrrdHeader& header, std::string_view field, std::string_view message) {
    const auto found = header.lines.find(field);
    const auto line = found == header.lines.end() ? "" : text(':', found->second);
    return fail(in_one_line(text(header.path, line, ": field '", field, "': ", message)));
}

}  // namespace thaum::field
