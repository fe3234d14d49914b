#include "field/volume_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/config.h"
#include "core/file.h"
#include "core/file_reader.h"
#include "core/one_line.h"
#include "core/text.h"
#include "field/detail/nrrd_fields.h"
#include "field/detail/nrrd_samples.h"
#include "field/detail/sample_decoder.h"
#include "field/detail/sample_file.h"
#include "field/detail/samples.h"
#include "field/nrrd.h"

namespace thaum::field {
namespace {

constexpr std::size_t max_description = 1U << 16U;  ///< largest TOML file that is accepted (bytes)

struct RawDescription {
    Volume volume;
    std::string file;
    bool big_endian{};
    std::size_t bytes{};  ///< size of the file of samples (bytes)
};

/// Reads the number of samples along each axis. Returns the product of these numbers and the components, or
/// reports that they are wrong.
std::size_t read_sizes(const ConfigTable& root, std::size_t limit, Volume& volume) {
    const vec3 sizes = root.vector("sizes", {1, 1e6});
    auto product = static_cast<std::size_t>(volume.components);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = sizes[static_cast<int>(axis)];
        if (size != std::floor(size)) root.report("sizes", "must be whole numbers");
        volume.count[axis] = static_cast<int>(size);
        if (static_cast<std::size_t>(size) > limit / product) {
            root.report("sizes", text("more than ", limit, " samples; make the volume smaller"));
            return 1;
        }
        product *= static_cast<std::size_t>(size);
    }
    return product;
}

Expected<RawDescription> parse_raw(std::string_view toml, const std::string& name, std::size_t limit) {
    const auto config = Config::parse(toml, name, 1);
    if (!config) return config.error();
    const ConfigTable root = config->root();
    RawDescription raw;
    const auto names = sample_type_names();
    raw.file = root.string("file");
    raw.volume.stored_as = static_cast<SampleType>(root.choice("type", {names.begin(), names.end()}));
    raw.big_endian = root.choice("endian", {"little", "big"}, 0) == 1;
    raw.volume.components = static_cast<int>(root.integer("components", {1, 3}, 1));
    if (raw.volume.components == 2) root.report("components", "must be 1 or 3");
    raw.volume.spacing = root.vector("spacing_mm", {1e-6, 1e6}) / 1000.0;
    raw.volume.name = printable(root.string("name", ""), 200);
    raw.volume.units = printable(root.string("units", ""), 60);
    raw.bytes = read_sizes(root, limit, raw.volume) * size_of(raw.volume.stored_as);
    if (auto checked = config->check(); !checked) return checked.error();
    return raw;
}

/// A format that cannot be read, recognised by the extension of its files.
struct OtherFormat {
    std::string_view ending, name;
    std::string_view conversion{"convert it to .nrrd, for example with 3D Slicer"};
};

constexpr std::string_view by_fiji = "convert it to .nrrd, for example with Fiji";
constexpr std::string_view by_samples =
    "write the samples as raw bytes, and describe them in a .toml or .nhdr";
constexpr std::array other_formats{
    OtherFormat{".mha", "MetaImage files"},
    OtherFormat{".mhd", "MetaImage files"},
    OtherFormat{".nii", "NIfTI files"},
    OtherFormat{".hdr", "Analyze and NIfTI files"},
    OtherFormat{".img", "Analyze and NIfTI files"},
    OtherFormat{".mgh", "FreeSurfer files"},
    OtherFormat{".mgz", "FreeSurfer files"},
    OtherFormat{".mnc", "MINC files", by_samples},
    OtherFormat{".dcm", "DICOM files"},
    OtherFormat{".ima", "DICOM files"},
    OtherFormat{".vtk", "VTK files", by_samples},
    OtherFormat{".vti", "VTK files", by_samples},
    OtherFormat{".h5", "HDF5 files", by_samples},
    OtherFormat{".tif", "TIFF files", by_fiji},
    OtherFormat{".tiff", "TIFF files", by_fiji},
    OtherFormat{".mrc", "MRC files", by_fiji},
    OtherFormat{".npy", "NumPy arrays", "save it with pynrrd: nrrd.write('volume.nrrd', array)"},
    OtherFormat{".mat", "MATLAB files", by_samples},
    OtherFormat{".raw", "samples without a header", "describe them in a .toml or .nhdr, and open that"},
    OtherFormat{".gz", "packed files",
                "unpack it; a .nrrd may pack its samples inside, with 'encoding: gzip'"},
    OtherFormat{".zip", "packed files", "unpack it"},
};

/// Says what a file with another extension is, and what to do with it.
std::string advice_for(std::string_view ending) {
    const auto found = std::ranges::find(other_formats, ending, &OtherFormat::ending);
    if (found == other_formats.end()) return "volumes are files that end in .nrrd, .nhdr or .toml";
    return text(found->name, " are not read (read are .nrrd, .nhdr, .toml); ", found->conversion);
}

}  // namespace

Expected<Volume> read_raw(const std::filesystem::path& path, std::size_t limit) {
    const auto toml = read_text_file(path, max_description);
    if (!toml) return toml.error();
    auto raw = parse_raw(*toml, path.string(), limit);
    if (!raw) return raw.error();
    const auto data_path = sample_file(path, raw->file);
    if (const auto note = note_on_place(path, raw->file, data_path); !note.empty())
        raw->volume.notes.push_back(note);
    auto file = FileReader::open(data_path, limit * size_of(SampleType::float64));
    if (!file) return Error{in_one_line(file.error().message)};
    const auto fits = [&](std::size_t bytes) -> Expected<void> {
        if (bytes == raw->bytes) return {};
        return fail(in_one_line(text(data_path.string(), ": ", bytes, " bytes, but ", path.string(),
                                     " describes ", raw->bytes, "; correct sizes and type")));
    };
    if (auto good = fits(file->size()); !good) return good.error();
    SampleDecoder decoder(raw->volume.stored_as, raw->big_endian,
                          plain_order(raw->volume.count, raw->volume.components),
                          raw->bytes / size_of(raw->volume.stored_as), raw->volume);
    const auto bytes = decode_bytes(*file, raw->bytes, decoder);
    if (!bytes) return Error{in_one_line(bytes.error().message)};
    if (auto good = fits(*bytes); !good) return good.error();
    decoder.finish();
    if (auto kept = check_rounding(raw->volume); !kept)
        return fail(in_one_line(text(data_path.string(), ": ", kept.error().message)));
    raw->volume.files = {path, data_path};
    return std::move(raw->volume);
}

Expected<Volume> read_volume(const std::filesystem::path& path, const ReadChoice& choice) {
    std::string ending = in_lower_case(path.extension().string());
    if (ending == ".gz" && in_lower_case(path.stem().extension().string()) == ".nii") ending = ".nii";
    const bool nrrd = ending == ".nrrd" || ending == ".nhdr";
    if (!nrrd && ending != ".toml") return fail(in_one_line(text(path.string(), ": ", advice_for(ending))));
    auto volume = nrrd ? read_nrrd(path, choice) : read_raw(path, choice.limit);
    if (volume && not_finite(*volume) == volume->samples.size())
        return fail(in_one_line(text(path.string(), ": none of its ", volume->samples.size(),
                                     " samples is a finite number; export the volume again")));
    return volume;
}

}  // namespace thaum::field
