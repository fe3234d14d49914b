#include "field/detail/nrrd_header.h"

#include <algorithm>
#include <cmath>

#include "core/one_line.h"
#include "core/text.h"
#include "field/detail/nrrd_fields.h"

namespace thaum::field {
namespace {

constexpr double shortest = 1e-9, longest = 1e3;  ///< spacings that are believed (m)
constexpr double farthest = 1e6;                  ///< farthest origin that is believed (m)
constexpr std::size_t no_axis = 4;

/// Axes of the file.
struct Axes {
    std::size_t count = 3;
    std::array<long, 4> size{1, 1, 1, 1};
    std::size_t components = no_axis;  ///< axis of components, if there is one

    /// Axes of space in the file's order.
    std::array<std::size_t, 3> in_space() const {
        std::array<std::size_t, 3> result{};
        std::size_t n = 0;
        for (std::size_t a = 0; a < count && n < 3; ++a) {
            if (a != components) result[n++] = a;
        }
        return result;
    }
};

void read_type(NrrdFields& fields, NrrdHeader& header) {
    header.type = static_cast<SampleType>(
        fields.choice("type", "int8, uint8, int16, uint16, float or double",
                      {{"int8", "signed char", "int8_t"},
                       {"uint8", "uchar", "unsigned char", "uint8_t"},
                       {"int16", "short", "short int", "signed short", "signed short int", "int16_t"},
                       {"uint16", "ushort", "unsigned short", "unsigned short int", "uint16_t"},
                       {"float"},
                       {"double"}}));
    const bool one_byte = header.type == SampleType::int8 || header.type == SampleType::uint8;
    if (!one_byte || fields.has("endian"))
        header.big_endian = fields.choice("endian", "little or big", {{"little"}, {"big"}}) == 1;
    const std::size_t packing = fields.choice("encoding", "raw or gzip", {{"raw"}, {"gzip", "gz"}});
    header.packing = packing == 0 ? Packing::raw : Packing::gzip;
}

bool is_axis_of_space(std::string_view kind) {
    return kind == "domain" || kind == "space" || kind == "???" || kind == "none";
}

/// Finds the axis of components among four: by its kind, or as the one without a direction, or the first.
std::size_t component_axis(NrrdFields& fields) {
    const auto kinds = fields.words("kinds");
    if (kinds.size() == 4) {
        const auto vector = std::ranges::find_if_not(kinds, is_axis_of_space);
        if (vector != kinds.end()) return static_cast<std::size_t>(vector - kinds.begin());
    }
    if (fields.has("spacedirections")) {
        const auto directions = fields.vectors("spacedirections", 4);
        const auto none = std::ranges::find_if_not(directions, &std::optional<vec3>::has_value);
        if (none != directions.end()) return static_cast<std::size_t>(none - directions.begin());
    }
    return 0;
}

Axes read_axes(NrrdFields& fields, std::size_t limit) {
    Axes axes;
    if (!fields.has("dimension")) fields.report("dimension", "a volume has 'dimension: 3'");
    axes.count = static_cast<std::size_t>(fields.integer("dimension", 3, 4, 3));
    const auto sizes = fields.numbers("sizes", axes.count);
    std::size_t product = 1;
    for (std::size_t a = 0; a < axes.count; ++a) {
        const bool whole = sizes[a] >= 1 && sizes[a] <= 1e9 && sizes[a] == std::floor(sizes[a]);
        if (!whole) fields.report("sizes", "a size is not a whole number from 1 on");
        axes.size[a] = whole ? static_cast<long>(sizes[a]) : 1;
        const auto size = static_cast<std::size_t>(axes.size[a]);
        if (size > limit / product) {
            fields.report("sizes", text("more than ", limit, " samples; make the volume smaller"));
            axes.size[a] = 1;
        } else {
            product *= size;
        }
    }
    const auto kinds = fields.words("kinds");
    if (fields.has("kinds") && kinds.size() != axes.count)
        fields.report("kinds", text(kinds.size(), " kinds for ", axes.count, " axes"));
    if (axes.count == 4) {
        axes.components = component_axis(fields);
        const long size = axes.size[axes.components];
        if (size != 1 && size != 3)
            fields.report("sizes", text("the axis of components has ", size,
                                        " samples; only scalars and vectors of 3 can be read"));
    } else if (!std::ranges::all_of(kinds, is_axis_of_space)) {
        fields.report("kinds", "a volume has three axes of space");
    }
    return axes;
}

void keep_axes(const Axes& axes, NrrdHeader& header) {
    std::array<std::ptrdiff_t, 4> stride{};
    std::ptrdiff_t step = 1;
    for (std::size_t a = 0; a < axes.count; ++a) {
        stride[a] = step;
        step *= axes.size[a];
    }
    const auto in_space = axes.in_space();
    for (std::size_t a = 0; a < 3; ++a) {
        header.sizes[a] = static_cast<int>(axes.size[in_space[a]]);
        header.stride[a] = stride[in_space[a]];
    }
    if (axes.components == no_axis) return;
    header.components = axes.size[axes.components] == 3 ? 3 : 1;
    header.component_stride = stride[axes.components];
}

/// A unit as a division, because that rounds a length of 2 mm as the number 0.002 is rounded.
double to_metres(NrrdFields& fields, std::string_view field, const std::string& unit, double length) {
    if (unit.empty() || unit == "???" || unit == "none" || unit == "mm" || unit == "millimeter" ||
        unit == "millimeters")
        return length / 1000;
    if (unit == "m" || unit == "meter" || unit == "meters") return length;
    if (unit == "cm" || unit == "centimeter" || unit == "centimeters") return length / 100;
    if (unit == "um" || unit == "\xc2\xb5m" || unit == "\xce\xbcm" || unit == "micron" || unit == "microns" ||
        unit == "micrometer" || unit == "micrometers")
        return length / 1e6;
    if (unit == "nm" || unit == "nanometer" || unit == "nanometers") return length / 1e9;
    fields.report(field, text("'", printable(unit, 60), "' is no unit of length; use m, cm, mm, um or nm"));
    return length;
}

/// Signs that make the frame of space right-handed and, for a patient, left-posterior-superior.
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

/// Directions and origin in the file's space.
void read_directions(NrrdFields& fields, const Axes& axes, vec3 sign, NrrdHeader& header) {
    if (fields.has("spacings")) fields.report("spacings", "the header also has 'space directions'; keep one");
    if (!fields.has("space") && !fields.has("spacedimension"))
        fields.report("spacedirections", "the header also needs 'space' or 'space dimension: 3'");
    std::vector<std::string> unit(3);
    if (fields.has("spaceunits")) unit = fields.quoted("spaceunits", 3);
    const auto metres = [&](vec3 v) {
        for (int i = 0; i < 3; ++i)
            v[i] = sign[i] * to_metres(fields, "spaceunits", unit[static_cast<std::size_t>(i)], v[i]);
        return v;
    };
    const auto directions = fields.vectors("spacedirections", axes.count);
    const auto in_space = axes.in_space();
    for (std::size_t a = 0; a < 3; ++a) {
        const auto& direction = directions[in_space[a]];
        if (!direction) fields.report("spacedirections", "an axis of space has no direction");
        header.direction[a] = metres(direction.value_or(vec3(1)));
    }
    if (!fields.has("spaceorigin")) return;
    const auto origin = fields.vectors("spaceorigin", 1).front();
    if (!origin) fields.report("spaceorigin", "it has no place, such as (0,0,0)");
    header.first = metres(origin.value_or(vec3(0)));
}

/// Spacings by the ends of the axes. An axis has a sample at each end if it is centred on nodes, otherwise, as the format
/// says, the samples are the middles of cells between the ends.
std::vector<double> spacings_of_ends(NrrdFields& fields, const Axes& axes) {
    const auto low = fields.numbers("axismins", axes.count), high = fields.numbers("axismaxs", axes.count);
    const std::string_view centers = fields.has("centers") ? "centers" : "centerings";
    const auto centres = fields.words(centers);
    std::vector<double> spacing(axes.count);
    for (std::size_t a = 0; a < axes.count; ++a) {
        const bool nodes = a < centres.size() && centres[a] == "node";
        spacing[a] = (high[a] - low[a]) / static_cast<double>(axes.size[a] - (nodes ? 1 : 0));
    }
    return spacing;
}

/// Axes along those of space, with spacings alone.
void read_spacings(NrrdFields& fields, const Axes& axes, vec3 sign, NrrdHeader& header) {
    std::vector<double> spacing(axes.count, 1.0);
    if (fields.has("spacings"))
        spacing = fields.numbers("spacings", axes.count);
    else if (fields.has("axismins") && fields.has("axismaxs"))
        spacing = spacings_of_ends(fields, axes);
    std::vector<std::string> unit(axes.count);
    if (fields.has("units")) unit = fields.quoted("units", axes.count);
    const auto in_space = axes.in_space();
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t from = in_space[a];
        const int i = static_cast<int>(a);
        header.direction[a] = vec3(0);
        header.direction[a][i] = sign[i] * to_metres(fields, "units", unit[from], spacing[from]);
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
    // Colours are no vectors in space.
    const auto kinds = fields.words("kinds");
    const bool colour = std::ranges::any_of(
        kinds, [](std::string_view kind) { return kind.find("color") != std::string_view::npos; });
    if (colour || header.components == 1) header.of_values = mat3(0.0);
}

void read_place_of_data(NrrdFields& fields, NrrdHeader& header) {
    header.data_file = fields.text_of("datafile");
    const bool list = header.data_file.starts_with("LIST") || header.data_file.find('%') != std::string::npos;
    if (list) fields.report("datafile", "samples in several files cannot be read; join them into one");
    if (fields.has("datafile") && header.data_file.empty()) fields.report("datafile", "it names no file");
    if (!fields.has("datafile") && !fields.end())
        fields.report("datafile", "the file ends with its header, without samples");
    header.data_at = fields.end().value_or(0);
    if (fields.has("lineskip") && fields.text_of("lineskip") != "0")
        fields.report("lineskip", "lines of text before the samples cannot be read; remove both");
    header.skip = fields.integer("byteskip", -1, 1'000'000'000, 0);
    if (header.packing == Packing::gzip && header.skip != 0)
        fields.report("byteskip", "bytes can be skipped in raw data alone");
}

}  // namespace

Expected<NrrdHeader> parse_nrrd_header(std::string_view file, const std::string& name, std::size_t limit) {
    auto fields = NrrdFields::parse(file, name);
    if (!fields) return fields.error();
    NrrdHeader header;
    read_type(*fields, header);
    const Axes axes = read_axes(*fields, limit);
    keep_axes(axes, header);
    const vec3 sign = read_space(*fields, header);
    if (fields->has("spacedirections")) {
        read_directions(*fields, axes, sign, header);
    } else {
        read_spacings(*fields, axes, sign, header);
    }
    check_lengths(*fields, header);
    read_frame_of_values(*fields, sign, header);
    read_place_of_data(*fields, header);
    header.name = printable(fields->text_of("content"), 200);
    header.units = printable(fields->text_of("sampleunits"), 60);
    header.save_name = printable(fields->text_of(key_of_save), 60);
    if (auto checked = fields->check(); !checked) return checked.error();
    return header;
}

}  // namespace thaum::field
