// Part of the area `field`: reading a file of samples, beside reading the same bytes as they are, and the
// memory that the samples then take.
#include <span>

#include "core/file.h"
#include "core/file_reader.h"
#include "core/text.h"
#include "field/nrrd.h"
#include "field/volume_file.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

/// Numbers as a scanner gives them: air, tissue and noise of a few units.
template <class T>
std::vector<T> scanned_numbers(std::size_t count) {
    std::vector<T> numbers(count);
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = static_cast<T>((i / 40 % 3 == 0 ? 5 : 105) + i * 2'654'435'761 % 16);
    return numbers;
}

std::size_t bytes_held(const field::VolumeSamples& samples) {
    return samples.visit([](const auto& all) { return all.capacity() * sizeof(all[0]); });
}

/// Reads a file into new memory, as the shortest program would.
std::vector<std::byte> plain_bytes(const std::filesystem::path& path) {
    auto file = FileReader::open(path);
    std::vector<std::byte> bytes(file ? file->size() : 0);
    if (file) (void)file->read(bytes);
    return bytes;
}

template <class T>
Expected<void> read_one(std::string_view name, field::SampleType type, int n, const Options& options,
                        Report& report) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "volume.nrrd";
    const auto count =
        static_cast<std::size_t>(n) * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    const field::Volume made{.count = {n, n, n}, .stored_as = type, .samples = scanned_numbers<T>(count)};
    if (auto written = field::write_nrrd(path, made, field::Packing::raw); !written) return written;
    const auto volume = field::read_volume(path);
    if (!volume) return volume.error();
    if (volume->samples != made.samples) return fail("a file gave other samples than were written");
    const std::array contestants{Contestant{{}, [&] { do_not_optimise(field::read_volume(path)); }},
                                 Contestant{{}, [&] { do_not_optimise(plain_bytes(path)); }}};
    const auto us = measure(contestants, {.seconds = options.quick ? 0.3 : 3.0, .least = 5});
    report.rows.push_back({.area = "field",
                           .name = "read_volume",
                           .setting = {{"type", std::string(name)}, {"n", std::int64_t{n}}},
                           .time_us = times(us[0]),
                           .metrics = {{"ratio_to_plain_read", ratio(us[0], us[1])},
                                       {"held_of_file", static_cast<double>(bytes_held(volume->samples)) /
                                                            static_cast<double>(count * sizeof(T))}}});
    return {};
}

}  // namespace

void volume_files(const Options& options, Report& report) {
    const int n = options.quick ? 96 : 256;
    using field::SampleType;
    for (const auto& done : {read_one<std::uint8_t>("uint8", SampleType::uint8, n, options, report),
                             read_one<std::int16_t>("int16", SampleType::int16, n, options, report),
                             read_one<std::uint16_t>("uint16", SampleType::uint16, n, options, report)})
        if (!done) report.faults.push_back(text("field read_volume: ", done.error().message));
}

}  // namespace thaum::bench
