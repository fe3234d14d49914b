#include "field/nrrd.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/file.h"
#include "core/file_reader.h"
#include "core/file_writer.h"
#include "core/gzip.h"
#include "core/one_line.h"
#include "core/text.h"
#include "field/detail/nrrd_fields.h"
#include "field/detail/nrrd_header.h"
#include "field/detail/nrrd_samples.h"
#include "field/detail/sample_decoder.h"
#include "field/detail/samples.h"

namespace thaum::field {
namespace {

/// An axis of samples counts as turned if the tangent of its angle to the nearest axis of space is larger
/// than `is_turned`. Two axes count as skewed if the cosine of the angle between them is larger than
/// `is_skewed`.
constexpr double is_turned = 1e-6, is_skewed = 1e-3;

using Path = std::filesystem::path;

Error fail_file(const Path& path, std::string_view message) {
    return fail(in_one_line(text(path.string(), ": ", message)));
}

// ---- reading ----------------------------------------------------------------------------------------------

/// Correspondence of a file's axes to those of a volume, and how they lie in space.
struct Arrangement {
    std::array<std::size_t, 3> from{0, 1, 2};  ///< index of the file's axis for each axis of the volume
    std::array<bool, 3> is_reversed{};
    vec3 spacing{};
    mat3 turn{1.0};
};

/// How the file's axes become those of the volume if they lie along those of space; std::nullopt if they do
/// not.
std::optional<Arrangement> along_space(const std::array<vec3, 3>& direction) {
    Arrangement a;
    std::array<bool, 3> used{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const vec3 d = direction[axis], size = glm::abs(d);
        const int main = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const auto to = static_cast<std::size_t>(main);
        vec3 off_axis = d;
        off_axis[main] = 0;
        if (used[to] || glm::length(off_axis) > is_turned * size[main]) return {};
        used[to] = true;
        a.from[to] = axis;
        a.is_reversed[to] = d[main] < 0;
        a.spacing[main] = size[main];
    }
    return a;
}

/// How the file's axes become those of the volume if they are turned against those of space but at right
/// angles to each other; std::nullopt if they are not.
std::optional<Arrangement> turned(const std::array<vec3, 3>& direction) {
    Arrangement a;
    std::array<vec3, 3> unit{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        a.spacing[static_cast<int>(axis)] = glm::length(direction[axis]);
        unit[axis] = direction[axis] / a.spacing[static_cast<int>(axis)];
    }
    const double skew = std::max({std::abs(glm::dot(unit[0], unit[1])), std::abs(glm::dot(unit[1], unit[2])),
                                  std::abs(glm::dot(unit[2], unit[0]))});
    if (!(skew <= is_skewed)) return {};
    const vec3 y = glm::normalize(unit[1] - glm::dot(unit[0], unit[1]) * unit[0]);
    const vec3 z = glm::cross(unit[0], y);
    a.turn = mat3(unit[0], y, z);
    a.is_reversed[2] = glm::dot(z, unit[2]) < 0;
    return a;
}

/// Reduces each colour to its luminance, or to its V or Y component if the file's colours are HSV or XYZ.
void keep_luminance(NrrdColour colour, Volume& volume) {
    // Shares of red, green and blue in the luminance, from ITU-R BT.709.
    constexpr std::array<std::array<double, 3>, 4> shares{
        {{1, 0, 0}, {0.2126, 0.7152, 0.0722}, {0, 0, 1}, {0, 1, 0}}};
    const auto& share = shares[static_cast<std::size_t>(colour)];
    auto& samples = volume.samples.floats();
    for (std::size_t i = 0; 3 * i < samples.size(); ++i) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += share[c] * static_cast<double>(samples[3 * i + c]);
        samples[i] = static_cast<float>(sum);
    }
    samples.resize(samples.size() / 3);
    volume.components = 1;
    if (colour == NrrdColour::red_green_blue) volume.stored_as = SampleType::float32;
}

/// Keeps colours as they are or only their luminance, as chosen. Adds a note on that for the user unless
/// there is one already.
void take_colours(const NrrdHeader& header, const ReadChoice& choice, Volume& volume) {
    volume.is_colour = choice.colours_as_vectors;
    if (choice.colours_as_vectors) return;
    keep_luminance(header.colour, volume);
    if (!header.is_colour_by_guess)
        volume.notes.emplace_back("the samples are colours, of which the luminance is read");
}

/// Turns vector values from the file's frame to the volume's. Values that are already in the volume's frame
/// keep their bits; turned integers are stored as floats from then on.
void turn_values(const mat3& to_own, Volume& volume) {
    bool same = true;
    for (int i = 0; i < 3; ++i) same = same && glm::length(to_own[i] - mat3(1.0)[i]) < is_turned;
    if (same) return;
    if (volume.stored_as < SampleType::float32) volume.stored_as = SampleType::float32;
    auto& samples = volume.samples.floats();
    for (std::size_t at = 0; at + 3 <= samples.size(); at += 3) {
        const vec3 v = to_own * vec3(samples[at], samples[at + 1], samples[at + 2]);
        for (int i = 0; i < 3; ++i) samples[at + static_cast<std::size_t>(i)] = static_cast<float>(v[i]);
    }
}

/// The file's direction vectors, in the order of the volume's axes.
FileAxes axes_of(const NrrdHeader& header, const Arrangement& a, const Volume& volume) {
    FileAxes axes{.first = header.first, .spacing = volume.spacing, .placement = volume.placement};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t from = a.from[axis];
        const vec3 direction = header.direction[from];
        axes.direction[axis] = a.is_reversed[axis] ? -direction : direction;
        if (a.is_reversed[axis] && axes.first)
            *axes.first += static_cast<double>(header.sizes[from] - 1) * direction;
    }
    return axes;
}

/// Refuses samples that are clearly in the wrong byte order, and adds a note if they are possibly in the
/// wrong order.
Expected<void> check_order(const NrrdHeader& header, ByteOrder order, Volume& volume) {
    if (header.encoding == NrrdEncoding::ascii) return {};
    const auto* other = header.big_endian ? "'endian: little'" : "'endian: big'";
    if (order == ByteOrder::wrong)
        return fail_field(
            header, "endian",
            text("read so, many samples are beyond 1e30 or below 1e-30, and in the other byte order none is; "
                 "write ",
                 other));
    if (order == ByteOrder::doubtful)
        volume.notes.push_back(text("every sample is a multiple of 256; if that is wrong, write ", other));
    return {};
}

/// Positions of the samples of one moment of time in a file, in the order of the volume.
StoredOrder order_of(const NrrdHeader& header, const Arrangement& a, int frame) {
    StoredOrder order{.first = frame * header.frame_stride, .component_stride = header.component_stride};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t stride = header.stride[a.from[axis]], last = header.sizes[a.from[axis]] - 1;
        order.stride[axis] = a.is_reversed[axis] ? -stride : stride;
        order.first += a.is_reversed[axis] ? last * stride : 0;
    }
    return order;
}

/// A volume without samples that has all else that the header says.
Volume volume_for(const NrrdHeader& header, const Arrangement& a) {
    Volume volume;
    volume.spacing = a.spacing;
    volume.components = header.components;
    volume.stored_as = header.type;
    volume.name = header.name;
    volume.units = header.units;
    volume.is_of_patient = header.is_of_patient;
    volume.frames = header.frames;
    vec3 half(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int count = header.sizes[a.from[axis]];
        volume.count[axis] = count;
        half += 0.5 * (static_cast<double>(count - 1) * header.direction[a.from[axis]]);
    }
    volume.placement.turn = a.turn;
    if (header.first) volume.placement.origin = *header.first + half;
    volume.has_place = header.first.has_value();
    volume.file_axes = axes_of(header, a, volume);
    if (header.is_in_space) volume.file_axes->middle = header.first.value_or(vec3(0)) + half;
    volume.save_name = header.save_name;
    return volume;
}

/// Interprets samples as the header says: picks the luminance of colours, turns vectors and adds notes for
/// the user. The samples are in the volume's order already. The error says what is wrong with them, without
/// the path.
Expected<void> interpret(const NrrdHeader& header, const Arrangement& a, const ReadChoice& choice,
                         Volume& volume) {
    if (header.frames > 1)
        volume.notes.push_back(text("moment ", choice.frame + 1, " of ", header.frames, " is read"));
    if (auto kept = check_rounding(volume); !kept) return kept;
    if (header.colour != NrrdColour::none) take_colours(header, choice, volume);
    if (header.of_values != mat3(0.0)) turn_values(glm::transpose(a.turn) * header.of_values, volume);
    return {};
}

// ---- writing ----------------------------------------------------------------------------------------------

/// Direction vectors of a header to be written (m).
struct WrittenSpace {
    std::array<vec3, 3> direction{};
    std::optional<vec3> first{};
};

bool still_lies_there(const FileAxes& axes, const Volume& volume) {
    const Placement &was = axes.placement, &current = volume.placement;
    return axes.spacing == volume.spacing && was.origin == current.origin && was.turn == current.turn &&
           was.scale == current.scale;
}

WrittenSpace space_of(const Volume& volume) {
    if (volume.file_axes && still_lies_there(*volume.file_axes, volume))
        return {volume.file_axes->direction, volume.file_axes->first};
    const Placement& p = volume.placement;
    WrittenSpace space;
    for (int i = 0; i < 3; ++i)
        space.direction[static_cast<std::size_t>(i)] = p.turn[i] * (volume.spacing[i] * p.scale);
    if (volume.has_place || p.origin != vec3(0))
        space.first = p.origin - p.turn * (p.scale * (0.5 * volume.extent()));
    return space;
}

/// True if the file needs to give only spacings, because the volume has no place and is not turned.
bool needs_no_space(const Volume& volume, const WrittenSpace& space) {
    return !space.first && !volume.is_of_patient && volume.placement.turn == mat3(1.0);
}

/// The number of mm from which a reader computes exactly this length; std::nullopt: there is none.
std::optional<double> mm_of(double metres) {
    const double mm = metres * 1000;
    for (const double one : {mm, std::nextafter(mm, HUGE_VAL), std::nextafter(mm, -HUGE_VAL)}) {
        if (one / 1000 == metres) return one;
    }
    return {};
}

bool is_exact_in_mm(vec3 v) { return mm_of(v.x) && mm_of(v.y) && mm_of(v.z); }

void append_vector(std::string& out, vec3 v, bool mm) {
    const auto number = [mm](double metres) { return mm ? mm_of(metres).value_or(metres) : metres; };
    append_text(out, text('(', number(v.x), ',', number(v.y), ',', number(v.z), ')'));
}

/// Appends the fields for the frame and the axes of space.
void append_space(std::string& out, const Volume& volume) {
    const WrittenSpace space = space_of(volume);
    const bool mm = (!space.first || is_exact_in_mm(*space.first)) &&
                    std::ranges::all_of(space.direction, is_exact_in_mm);
    const bool vectors = volume.components == 3;
    const std::string_view unit = mm ? " \"mm\"" : " \"m\"";
    if (needs_no_space(volume, space)) {
        append_text(out, vectors ? "\nspacings: nan" : "\nspacings:");
        for (std::size_t i = 0; i < 3; ++i) {
            const double length = space.direction[i][static_cast<int>(i)];
            append_text(out, text(' ', mm ? mm_of(length).value_or(length) : length));
        }
        append_text(out, text("\nunits:", vectors ? " \"\"" : "", unit, unit, unit));
        return;
    }
    append_text(out, volume.is_of_patient ? "\nspace: left-posterior-superior" : "\nspace: 3D-right-handed");
    append_text(out, vectors ? "\nspace directions: none" : "\nspace directions:");
    for (const vec3 d : space.direction) append_vector(out += ' ', d, mm);
    if (space.first) append_vector(out += "\nspace origin: ", *space.first, mm);
    append_text(out, text("\nspace units:", unit, unit, unit));
    if (!vectors || volume.is_colour) return;
    append_text(out, "\nmeasurement frame:");
    for (int i = 0; i < 3; ++i) append_vector(out += ' ', volume.placement.turn[i], false);
}

std::string header_of(const Volume& volume, Packing packing) {
    const bool vectors = volume.components == 3;
    std::string out = text("NRRD0005\ntype: ", name_of(volume.stored_as), "\ndimension: ", vectors ? 4 : 3);
    if (const std::string name = printable(volume.name, 200); !name.empty())
        append_text(out, text("\ncontent: ", name));
    append_text(out, vectors ? "\nsizes: 3" : "\nsizes:");
    for (const int n : volume.count) append_text(out, text(' ', n));
    append_space(out, volume);
    const std::string_view first_kind = !vectors ? "" : volume.is_colour ? " RGB-color" : " vector";
    append_text(out, text("\nkinds:", first_kind, " domain domain domain"));
    if (const std::string units = printable(volume.units, 60); !units.empty())
        append_text(out, text("\nsample units: ", units));
    append_text(out, "\nendian: little");
    append_text(out, packing == Packing::gzip ? "\nencoding: gzip\n" : "\nencoding: raw\n");
    if (!volume.save_name.empty()) append_text(out, text(key_of_save, ":=", volume.save_name, '\n'));
    return out + '\n';
}

Expected<NrrdHeader> read_header(const Path& path, std::size_t limit) {
    const auto start = read_start(path, longest_header + 1);
    if (!start) return start.error();
    const std::string_view characters(reinterpret_cast<const char*>(start->data()), start->size());
    return parse_nrrd_header(characters, path.string(), limit);
}

}  // namespace

Expected<Volume> read_nrrd(const Path& path, const ReadChoice& choice) {
    const std::size_t max_bytes = choice.limit * size_of(SampleType::float64) + longest_header;
    auto header = read_header(path, choice.limit);
    if (!header) return header.error();
    if (choice.frame < 0 || choice.frame >= header->frames)
        return fail_file(path,
                         text("there is no moment ", choice.frame + 1, "; the file has ", header->frames));
    const auto space = along_space(header->direction);
    const auto arrangement = space ? space : turned(header->direction);
    if (!arrangement)
        return fail_field(*header, "space directions",
                          "the axes are not at right angles; resample the volume to a straight box");
    if (choice.colours_as_vectors && header->colour > NrrdColour::red_green_blue)
        return fail_field(*header, "kinds", "colours must be red, green and blue; convert to 'RGB-color'");
    auto file = FileReader::open(path, header->data_files.empty() ? max_bytes : FileReader::any_size);
    if (!file) return Error{in_one_line(file.error().message)};
    Volume volume = volume_for(*header, *arrangement);
    volume.notes = std::move(header->notes);
    const bool in_text = header->encoding == NrrdEncoding::ascii;
    SampleDecoder decoder(in_text ? SampleType::float64 : header->type, !in_text && header->big_endian,
                          order_of(*header, *arrangement, choice.frame), header->stored, volume);
    if (auto done = read_nrrd_samples(*header, path, *file, max_bytes, decoder, volume); !done)
        return done.error();
    if (auto done = check_order(*header, decoder.byte_order(), volume); !done) return done.error();
    decoder.finish();
    if (auto done = interpret(*header, *arrangement, choice, volume); !done)
        return fail_file(path, done.error().message);
    return volume;
}

Expected<FileWriter> start_nrrd(const Path& path, const Volume& volume, Packing packing) {
    std::size_t size = static_cast<std::size_t>(volume.components);
    for (const int n : volume.count) size *= static_cast<std::size_t>(n);
    THAUM_ASSERT(size == volume.samples.size(), "a volume's samples do not match its count");
    auto file = FileWriter::create(path);
    if (!file) return file;
    file->write(header_of(volume, packing));
    const Bytes samples = encode(volume);
    if (packing == Packing::gzip) {
        file->write(pack_gzip(samples));
    } else {
        file->write(samples);
    }
    if (auto finished = file->finish(); !finished) return finished.error();
    return file;
}

Expected<void> write_nrrd(const Path& path, const Volume& volume, Packing packing) {
    auto file = start_nrrd(path, volume, packing);
    return file ? file->close() : file.error();
}

}  // namespace thaum::field
