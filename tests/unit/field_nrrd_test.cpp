// Tests of volume files: NRRD in all forms that can be read, files that are written and read again, raw
// samples with a description, and faulty files.
#include "field/nrrd.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "core/file.h"
#include "core/gzip.h"
#include "core/random.h"
#include "core/text.h"
#include "field/volume_file.h"
#include "unit/volume_files.h"

namespace thaum::field {
namespace {

constexpr std::array types{SampleType::int8,    SampleType::uint8,  SampleType::int16, SampleType::uint16,
                           SampleType::int32,   SampleType::uint32, SampleType::int64, SampleType::uint64,
                           SampleType::float32, SampleType::float64};

float sample(const Volume& v, int i, int j, int k, int c = 0) {
    const int at = c + v.components * (i + v.count[0] * (j + v.count[1] * k));
    return v.samples[static_cast<std::size_t>(at)];
}

// ---- what is read from NRRD files -------------------------------------------------------------------------

TEST_F(VolumeFiles, SamplesOfEitherByteOrderRawOrPacked) {
    for (const bool big : {false, true}) {
        for (const bool packed : {false, true}) {
            const auto v =
                read(text("# a comment\ntype: short\ndimension: 3\nsizes: 2 3 4\nkey:=value: 1\nendian: ",
                          big ? "big" : "little", "\nencoding: ", packed ? "gzip" : "raw"),
                     packed ? gzipped(shorts(24, big)) : shorts(24, big))
                    .value();
            EXPECT_EQ(v.count, (std::array{2, 3, 4}));
            EXPECT_EQ(v.stored_as, SampleType::int16);
            for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(v.samples[i], static_cast<float>(i));
            EXPECT_EQ(v.spacing, vec3(0.001)) << "without spacings, 1 mm";
            EXPECT_EQ(v.placement.origin, vec3(0));
        }
    }
}

TEST_F(VolumeFiles, EveryTypeWithItsExtremes) {
    const auto one = [&](std::string_view type, auto low, auto high) {
        std::string data(2 * sizeof low, '\0');
        std::memcpy(data.data(), &low, sizeof low);
        std::memcpy(data.data() + sizeof low, &high, sizeof high);
        const auto v =
            read(text("type: ", type, "\ndimension: 3\nsizes: 2 1 1\nendian: little\nencoding: raw"), data)
                .value();
        EXPECT_EQ(v.samples[0], static_cast<float>(low)) << type;
        EXPECT_EQ(v.samples[1], static_cast<float>(high)) << type;
        EXPECT_TRUE(std::holds_alternative<std::vector<HeldAs<decltype(low)>>>(v.samples.values)) << type;
    };
    one("signed char", std::int8_t{-128}, std::int8_t{127});
    one("UChar", std::uint8_t{0}, std::uint8_t{255});
    one("int16_t", std::int16_t{-32768}, std::int16_t{32767});
    one("unsigned short", std::uint16_t{0}, std::uint16_t{65535});
    one("float", -1.5F, 3e38F);
    one("double", -0.1, 1e38);
}

TEST_F(VolumeFiles, SpacingsAndUnits) {
    EXPECT_EQ(read_short("spacings: 1.5 2 3").spacing, vec3(1.5, 2, 3) / 1000.0);
    EXPECT_EQ(read_short("spacings: 1.5 2 3\nunits: \"mm\" \"cm\" \"m\"").spacing, vec3(0.0015, 0.02, 3));
    EXPECT_EQ(read_short("spacings: 5 5 5\nunits: \"um\" \"um\" \"um\"").spacing, vec3(5e-6));
    const Volume negative = read_short("spacings: -1 1 1");
    EXPECT_EQ(negative.spacing, vec3(0.001));
    EXPECT_EQ(sample(negative, 0, 0, 0), 1);
}

TEST_F(VolumeFiles, AxesAlongSpaceAreOrderedAndTurnedRound) {
    // The file's first axis runs against z, its second along x, its third along y.
    const Volume v = read_short(
        "space dimension: 3\nspace directions: (0,0,-2) (3,0,0) (0,4,0)\nspace origin: (10,20,30)");
    EXPECT_EQ(v.count, (std::array{3, 4, 2}));
    EXPECT_EQ(v.spacing, vec3(3, 4, 2) / 1000.0);
    EXPECT_EQ(v.placement.turn, mat3(1.0));
    for (int k = 0; k < 2; ++k) {
        for (int j = 0; j < 4; ++j) {
            for (int i = 0; i < 3; ++i) {
                EXPECT_EQ(sample(v, i, j, k), static_cast<float>((1 - k) + 2 * i + 6 * j));
                // Place of sample (i, j, k), computed from the lines of the header.
                const vec3 by_header = vec3(10 + 3 * i, 20 + 4 * j, 30 - 2 * (1 - k)) / 1000.0;
                EXPECT_LE(glm::length(to_parent(v.placement, v.place(i, j, k)) - by_header), 1e-15);
            }
        }
    }
}

TEST_F(VolumeFiles, TurnedAxesGoToThePlacement) {
    // The axes are turned by 30 degrees about z. In the second file the third axis makes the frame
    // left-handed.
    for (const char* third : {"(0,0,2)", "(0,0,-2)"}) {
        const Volume v =
            read_short(text("space: left-posterior-superior\nspace directions: (0.8660254037844387,0.5,0) "
                            "(-1.5,2.598076211353316,0) ",
                            third, "\nspace origin: (1,2,3)"));
        EXPECT_EQ(v.count, (std::array{2, 3, 4}));
        EXPECT_LE(glm::length(v.spacing - vec3(0.001, 0.003, 0.002)), 1e-15);
        EXPECT_NEAR(glm::determinant(v.placement.turn), 1, 1e-12);
        EXPECT_TRUE(v.is_of_patient);
        const double z = third[5] == '-' ? -2 : 2;
        for (int k = 0; k < 4; ++k) {
            const vec3 by_header = (vec3(1, 2, 3) + vec3(0.8660254037844387, 0.5, 0) +
                                    2.0 * vec3(-1.5, 2.598076211353316, 0) + vec3(0, 0, k * z)) /
                                   1000.0;
            const int own = z < 0 ? 3 - k : k;
            EXPECT_LE(glm::length(to_parent(v.placement, v.place(1, 2, own)) - by_header), 1e-15);
            EXPECT_EQ(sample(v, 1, 2, own), static_cast<float>(1 + 2 * 2 + 6 * k));
        }
    }
}

TEST_F(VolumeFiles, SpacesOfPatientsAreTurnedToOne) {
    const char* directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (1,2,3)\nspace: ";
    const auto first = [](const Volume& v) { return to_parent(v.placement, v.place(0, 0, 0)) * 1000.0; };
    const Volume lps = read_short(text(directions, "LPS"));
    EXPECT_LE(glm::length(first(lps) - vec3(1, 2, 3)), 1e-12);
    EXPECT_EQ(sample(lps, 0, 0, 0), 0);
    const Volume ras = read_short(text(directions, "right-anterior-superior"));
    EXPECT_LE(glm::length(first(ras) - vec3(-2, -4, 3)), 1e-12);
    EXPECT_EQ(sample(ras, 0, 0, 0), 1 + 2 * 2);
    const Volume las = read_short(text(directions, "LAS"));
    EXPECT_EQ(sample(las, 0, 0, 0), 2 * 2);
    const Volume mirrored = read_short(text(directions, "3D-left-handed"));
    EXPECT_EQ(sample(mirrored, 0, 0, 0), 6 * 3);
    EXPECT_FALSE(mirrored.is_of_patient);
}

TEST_F(VolumeFiles, VectorsStandInTheFirstAxisOrWhereTheirKindIs) {
    const char* start = "type: short\ndimension: 4\nendian: little\nencoding: raw\n";
    const auto first = read(text(start, "sizes: 3 2 2 2\nspacings: nan 1 2 3"), shorts(24)).value();
    EXPECT_EQ(first.components, 3);
    EXPECT_EQ(first.count, (std::array{2, 2, 2}));
    EXPECT_EQ(first.spacing, vec3(0.001, 0.002, 0.003));
    EXPECT_EQ(sample(first, 1, 0, 1, 2), 2 + 3 + 12);
    const auto last =
        read(text(start, "sizes: 2 2 2 3\nkinds: space space space vector"), shorts(24)).value();
    EXPECT_EQ(sample(last, 1, 0, 1, 2), 1 + 4 + 16);
    const auto scalar =
        read(text(start, "sizes: 1 2 3 4\nkinds: scalar domain domain domain"), shorts(24)).value();
    EXPECT_EQ(scalar.components, 1);
}

TEST_F(VolumeFiles, VectorsTurnWithTheirFrame) {
    const char* start =
        "type: short\ndimension: 4\nendian: little\nencoding: raw\nsizes: 3 1 1 1\n"
        "space directions: none (0,1,0) (-1,0,0) (0,0,1)\n";
    // The vector (0, 1, 2) in the frame of space, which here is also the frame of the volume.
    const auto plain = read(text(start, "space dimension: 3"), shorts(3)).value();
    EXPECT_EQ(plain.samples, (std::vector<float>{0, 1, 2}));
    const auto patient = read(text(start, "space: RAS"), shorts(3)).value();
    EXPECT_EQ(patient.samples, (std::vector<float>{0, -1, 2}));
    EXPECT_EQ(patient.stored_as, SampleType::float32) << "a turned vector needs no longer be whole";
    const auto measured =
        read(text(start, "space dimension: 3\nmeasurement frame: (0,1,0) (0,0,1) (1,0,0)"), shorts(3))
            .value();
    EXPECT_EQ(measured.samples, (std::vector<float>{2, 0, 1}));
}

TEST_F(VolumeFiles, DetachedHeadersAndSkippedBytes) {
    const char* head = "NRRD0005\r\ntype: short\r\ndimension: 3\r\nsizes: 2 3 4\r\nendian: little\r\n";
    put("data.raw", "junk" + shorts(24));
    put("data.gz", gzipped(shorts(24)));
    for (const std::string& remaining :
         {std::string("encoding: raw\r\nbyte skip: 4\r\ndata file: data.raw\r\n"),
          std::string("encoding: raw\r\nbyteskip: -1\r\ndatafile: data.raw\r\n\r\n"),
          std::string("encoding: gz\r\nData File: data.gz")}) {
        const auto v = read_volume(put("head.nhdr", head + remaining)).value();
        EXPECT_EQ(v.samples[23], 23);
    }
}

TEST_F(VolumeFiles, TheRealScanReads) {
    const fs::path path = fs::path(THAUM_SOURCE_DIR) / "../shared/data/volumes/head-ct-128.nrrd";
    if (!fs::exists(path)) GTEST_SKIP() << "there is no folder of volumes beside the source tree";
    const auto v = read_volume(path).value();
    EXPECT_EQ(v.count, (std::array{128, 128, 54}));
    EXPECT_EQ(v.spacing, vec3(1.9140624, 1.9140624, 3.0) / 1000.0);
    EXPECT_EQ(v.stored_as, SampleType::int16);
    EXPECT_LT(range_of(v).low, -900) << "air, in Hounsfield units";
    EXPECT_GT(range_of(v).high, 1000) << "bone";
    ASSERT_TRUE(write_nrrd(in_folder("again.nrrd"), v));
    EXPECT_EQ(read_volume(in_folder("again.nrrd"))->samples, v.samples);
}

// ---- volumes written and read again -----------------------------------------------------------------------

void expect_same(const Volume& a, const Volume& b) {
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.stored_as, b.stored_as);
    EXPECT_EQ(a.samples, b.samples);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.units, b.units);
    EXPECT_EQ(a.is_of_patient, b.is_of_patient);
    EXPECT_LE(glm::length(a.spacing - b.spacing), 1e-15);
    EXPECT_LE(glm::length(a.placement.origin - b.placement.origin), 1e-15);
    for (int i = 0; i < 3; ++i) EXPECT_LE(glm::length(a.placement.turn[i] - b.placement.turn[i]), 1e-14);
}

TEST_F(VolumeFiles, EveryVolumeReadsAsItWasWritten) {
    Random random = random_stream(1, 1);
    for (const SampleType type : types) {
        for (const int components : {1, 3}) {
            for (const bool is_turned : {false, true}) {
                Volume v{.count = {3, 5, 4},
                         .spacing = {random.uniform(1e-4, 1e-2), 0.0019140624, 0.003},
                         .components = components,
                         .stored_as = type,
                         .name = "a name",
                         .units = "HU",
                         .is_of_patient = is_turned};
                v.placement.origin = {random.uniform(-1, 1), 0.25, random.uniform(-1, 1)};
                if (is_turned)
                    v.placement.turn = glm::mat3_cast(rotation(glm::normalize(vec3(1, 2, 3)), 0.7));
                const bool is_signed = type != SampleType::uint8 && type != SampleType::uint16 &&
                                       type != SampleType::uint32 && type != SampleType::uint64;
                const bool is_real = type == SampleType::float32 || type == SampleType::float64;
                for (int i = 0; i < 60 * components; ++i) {
                    const double x = random.uniform(is_signed ? -128 : 0, 127);
                    v.samples.floats().push_back(static_cast<float>(is_real ? x : std::round(x)));
                }
                for (const Packing packing : {Packing::raw, Packing::gzip}) {
                    const auto path = in_folder("again.nrrd");
                    ASSERT_TRUE(write_nrrd(path, v, packing));
                    const auto again = read_nrrd(path).value();
                    expect_same(again, v);
                    if (!is_turned) {
                        EXPECT_EQ(again.spacing, v.spacing) << "the same bits";
                    }
                }
            }
        }
    }
}

TEST_F(VolumeFiles, WhatWasReadIsWrittenAlikeEachTime) {
    const Volume v = read_short(
        "space: RAS\nspace directions: (0,0,-2.3) (3.1,0,0) (0,4.7,0)\nspace origin: (10.1,20.2,30.3)");
    ASSERT_TRUE(write_nrrd(in_folder("a.nrrd"), v));
    const auto again = read_nrrd(in_folder("a.nrrd")).value();
    expect_same(again, v);
    ASSERT_TRUE(write_nrrd(in_folder("b.nrrd"), again));
    const auto words = read_text_file(in_folder("a.nrrd"), 10000).value();
    EXPECT_EQ(words, read_text_file(in_folder("b.nrrd"), 10000).value_or(""));
    EXPECT_NE(words.find("space units: \"mm\" \"mm\" \"mm\""), std::string::npos);
}

TEST_F(VolumeFiles, ATurnedVolumeKeepsItsLastDigits) {
    const Volume v = read_short(
        "space: left-posterior-superior\nspace directions: (1.7,0.3,0.1) (-0.3,1.7,0.0) "
        "(-0.1676470588235294,-0.029584775086505192,2.941176470588235)\nspace origin: (10.1,20.2,30.3)");
    ASSERT_TRUE(write_nrrd(in_folder("0.nrrd"), v));
    const auto first = read_text_file(in_folder("0.nrrd"), 10000);
    EXPECT_NE(first->find("(1.7,0.3,0.1)"), std::string::npos);
    EXPECT_NE(first->find("space origin: (10.1,20.2,30.3)"), std::string::npos);
    for (const char* next : {"1.nrrd", "2.nrrd"}) {
        ASSERT_TRUE(write_nrrd(in_folder(next), *read_nrrd(in_folder("0.nrrd"))));
        EXPECT_EQ(read_text_file(in_folder(next), 10000).value_or(""), *first);
    }
    Volume moved = v;
    moved.placement.origin.x += 0.5;
    ASSERT_TRUE(write_nrrd(in_folder("m.nrrd"), moved));
    EXPECT_NEAR(read_nrrd(in_folder("m.nrrd"))->placement.origin.x, moved.placement.origin.x, 1e-12);
}

TEST_F(VolumeFiles, NoFrameAndNoOriginAreInventedForAFile) {
    const Volume v = read_short("spacings: 1.5 2 3");
    EXPECT_FALSE(v.has_place);
    ASSERT_TRUE(write_nrrd(in_folder("a.nrrd"), v));
    const auto words = read_text_file(in_folder("a.nrrd"), 10000);
    EXPECT_NE(words->find("\nspacings: 1.5 2 3\n"), std::string::npos) << *words;
    EXPECT_EQ(words->find("space"), std::string::npos) << *words;
    EXPECT_EQ(read_nrrd(in_folder("a.nrrd"))->spacing, v.spacing);
}

TEST_F(VolumeFiles, AFrameWithoutAnOriginBeginsAtTheFirstSample) {
    const char* directions = "space dimension: 3\nspace directions: (2,0,0) (0,-2,0) (0,0,2)";
    const Volume v = read_short(directions);
    ASSERT_TRUE(v.file_axes && v.file_axes->middle);
    EXPECT_LE(glm::distance(*v.file_axes->middle, vec3(0.001, -0.002, 0.003)), 1e-15);
    EXPECT_EQ(v.placement.origin, vec3(0));
    const Volume placed = read_short(text(directions, "\nspace origin: (0,4,0)"));
    EXPECT_EQ(*placed.file_axes->middle, placed.placement.origin);
    EXPECT_FALSE(read_short("spacings: 1 1 1").file_axes->middle);
}

TEST_F(VolumeFiles, FilesAndTheNameOfTheSaveAreKnown) {
    Volume v = read_short("spacings: 1 1 1");
    EXPECT_EQ(v.files, std::vector{in_folder("v.nrrd")});
    EXPECT_EQ(v.save_name, "");
    v.save_name = "12ab";
    ASSERT_TRUE(write_nrrd(in_folder("a.nrrd"), v));
    EXPECT_EQ(read_nrrd(in_folder("a.nrrd"))->save_name, "12ab");
    put("d.raw", shorts(24));
    const auto detached = read_nrrd(put("d.nhdr",
                                        "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n"
                                        "encoding: raw\ndata file: d.raw\n"))
                              .value();
    EXPECT_EQ(detached.files, (std::vector{in_folder("d.nhdr"), in_folder("d.raw")}));
}

TEST_F(VolumeFiles, TheEndsOfTheAxesGiveSpacings) {
    const char* ends = "axis mins: 0 0 0\naxis maxs: 4 6 12\n";
    EXPECT_EQ(read_short(text(ends, "centers: cell cell cell")).spacing, vec3(2, 2, 3) / 1000.0);
    EXPECT_EQ(read_short(text(ends, "centers: node node node")).spacing, vec3(4, 3, 4) / 1000.0);
    EXPECT_TRUE(read_short(text(ends, "centers: cell cell cell")).notes.empty());
    const auto both = read_short(text(ends, "spacings: 1 2 3"));
    EXPECT_EQ(both.spacing, vec3(1, 2, 3) / 1000.0);
    ASSERT_EQ(both.notes.size(), 1U);
    EXPECT_NE(both.notes[0].find("'axis mins' and 'axis maxs' have no effect"), std::string::npos);
    const auto elsewhere = read_short("axis mins: 5 0 0\naxis maxs: 9 6 12");
    EXPECT_EQ(elsewhere.spacing, vec3(2, 2, 3) / 1000.0);
    ASSERT_EQ(elsewhere.notes.size(), 1U);
    EXPECT_NE(elsewhere.notes[0].find("give only the spacings"), std::string::npos);
}

TEST_F(VolumeFiles, SamplesThatAreNoFiniteNumbersAreCountedOrRefused) {
    const auto doubles = [&](double first) {
        std::string data(24 * sizeof(double), '\0');
        for (std::size_t i = 0; i < 24; ++i) {
            const double value = i == 0 ? first : std::nan("");
            std::memcpy(&data[i * sizeof(double)], &value, sizeof value);
        }
        const auto path = put("v.nrrd", text("NRRD0004\ntype: double\ndimension: 3\nsizes: 2 3 4\n"
                                             "endian: little\nencoding: raw\n\n",
                                             data));
        return read_volume(path);
    };
    EXPECT_EQ(not_finite(*doubles(7)), 23U);
    expect_refused(doubles(std::nan("")), "none of its 24 samples is a finite number");
}

TEST_F(VolumeFiles, TheScaleBecomesPartOfTheSpacing) {
    Volume v{.count = {2, 2, 2}, .spacing = vec3(0.001), .samples = std::vector<float>(8)};
    v.placement = {.origin = {1, 2, 3}, .scale = 4};
    ASSERT_TRUE(write_nrrd(in_folder("a.nrrd"), v));
    const auto again = read_nrrd(in_folder("a.nrrd"));
    EXPECT_EQ(again->spacing, vec3(0.004));
    EXPECT_LE(glm::length(to_parent(again->placement, again->place(1, 0, 1)) -
                          to_parent(v.placement, v.place(1, 0, 1))),
              1e-15);
}

TEST_F(VolumeFiles, SamplesThatDoNotFitAreLimited) {
    Volume v{.count = {5, 1, 1}, .stored_as = SampleType::int8};
    v.samples = {-1000, 1000, 1.5F, std::numeric_limits<float>::quiet_NaN(), HUGE_VALF};
    ASSERT_TRUE(write_nrrd(in_folder("a.nrrd"), v));
    EXPECT_EQ(read_nrrd(in_folder("a.nrrd"))->samples, (std::vector<float>{-128, 127, 2, 0, 127}));
    EXPECT_FALSE(write_nrrd(in_folder("no/a.nrrd"), v));
}

// ---- raw samples with a description -----------------------------------------------------------------------

TEST_F(VolumeFiles, RawSamplesWithADescription) {
    put("head.raw", shorts(24, true));
    const auto v = read_volume(put("head.toml",
                                   "version = 1\nfile = \"head.raw\"\nsizes = [2, 3, 4]\ntype = \"int16\"\n"
                                   "endian = \"big\"\nspacing_mm = [1.9, 2, 3]\nname = \"head\"\n"
                                   "units = \"HU\"\n"))
                       .value();
    EXPECT_EQ(v.count, (std::array{2, 3, 4}));
    EXPECT_EQ(v.samples[23], 23);
    EXPECT_EQ(v.spacing, vec3(1.9, 2, 3) / 1000.0);
    EXPECT_EQ(v.name, "head");
    EXPECT_EQ(v.units, "HU");
}

TEST_F(VolumeFiles, WrongDescriptionsAreRefused) {
    put("head.raw", shorts(24));
    const auto with = [&](std::string_view lines) {
        return read_volume(put("h.toml", text("version = 1\nspacing_mm = [1, 1, 1]\n", lines)));
    };
    const char* file = "file = \"head.raw\"\n";
    expect_refused(with(text(file, "type = \"int16\"\nsizes = [2, 3, 5]")), "48 bytes");
    expect_refused(with(text(file, "type = \"int16\"\nsizes = [2, 3, 3]")), "48 bytes");
    expect_refused(with(text(file, "type = \"int32\"\nsizes = [2, 3, 4]")), "type");
    expect_refused(with(text(file, "type = \"int16\"\nsizes = [2.5, 3, 4]")), "whole numbers");
    expect_refused(with(text(file, "type = \"int8\"\nsizes = [1e6, 1e6, 1e6]")), "samples");
    expect_refused(with(text(file, "type = \"int16\"\nsizes = [2, 3, 4]\ncolour = 1")), "colour");
    expect_refused(with(text(file, "type = \"int16\"\nsizes = [2, 3, 2]\ncomponents = 2")), "1 or 3");
    expect_refused(with("file = \"none\"\ntype = \"int16\"\nsizes = [2, 3, 4]"), "No such file");
    expect_refused(with("file = \".\"\ntype = \"int16\"\nsizes = [2, 3, 4]"), "not an ordinary file");
}

// ---- faulty files -----------------------------------------------------------------------------------------

TEST_F(VolumeFiles, WrongHeadersAreRefusedWithTheirLine) {
    const auto refused = [&](std::string_view lines, std::string_view what) {
        expect_refused(read(lines, shorts(24)), what);
    };
    const std::string good = "type: short\ndimension: 3\nsizes: 2 3 4\nencoding: raw\nendian: little";
    EXPECT_TRUE(read(good, shorts(24)));
    const auto without = [&](std::string_view field) {
        const auto at = good.find(field);
        const auto end = std::min(good.find('\n', at), good.size());
        return std::string(good).erase(at, end - at + 1);
    };
    for (const char* field : {"type", "dimension", "sizes", "endian", "encoding"})
        refused(without(field), text("no field '", field, "'"));
    refused(good + "\nnonsense", ":7: 'nonsense' is no field");
    refused(good + "\ncolour: red", ":7: NRRD has no field 'colour'");
    refused(good + "\nsizes: 2 3 4", ":7: field 'sizes' stands in the header twice");
    refused(without("type") + "\ntype: block", "'block' cannot be read");
    for (const char* encoding : {"bzip2", "hex", "zstd", ""})
        refused(without("encoding") + "\nencoding: " + encoding, text("'", encoding, "' cannot be read"));
    refused(without("dimension") + "\ndimension: 2", "from 3 to 5");
    refused(without("sizes") + "\nsizes: 2 3", "2 numbers for 3 axes");
    refused(without("sizes") + "\nsizes: 2 x 4", "'x' is no number");
    for (const char* sizes : {"2 0 4", "2 -3 4", "2 2.5 4", "nan 1 1"})
        refused(without("sizes") + "\nsizes: " + sizes, "not a whole number");
    for (const char* spacings : {"0 1 1", "1e300 1 1"})
        refused(good + "\nspacings: " + spacings, "spacing is not a number");
    for (const char* spacings : {"inf 1 1", "x 1 1"})
        refused(good + "\nspacings: " + spacings, "is no number");
    refused(good + "\nspacings: 1 1\n", "2 numbers for 3 axes");
    refused(good + "\nspace directions: (1,0,0) (0,1,0) (0,0,1)", "'space'");
    refused(good + "\nkinds: domain domain time", "three axes of space");
    refused(good + "\nkinds: domain domain vector", "is read only with 3 samples, not 4");
    refused(good + "\ndata file: LIST", "no names of files follow LIST");
    refused(good + "\nspace origin: (0,0,0)", "the header also needs 'space'");
    refused(good + "\nbyte skip: -2", "whole number from -1");
    refused(good + "\nline skip: -2", "field 'line skip': '-2' is not a whole number");
    refused(without("encoding") + "\nencoding: ascii\nbyte skip: -1", "do not end the file");
    refused(good + "\nbyte Skip: x", "field 'byte Skip': 'x'");
    EXPECT_TRUE(read(good + "\nline skip: 0", shorts(24)));
}

TEST_F(VolumeFiles, WrongSpacesAreRefused) {
    const auto refused = [&](std::string_view more, std::string_view what) {
        expect_refused(
            read(text("type: short\ndimension: 3\nsizes: 2 3 4\nendian: little\nencoding: raw\n", more),
                 shorts(24)),
            what);
    };
    const std::string space = "space dimension: 3\nspace directions: ";
    refused(space + "(1,0,0) (0.2,1,0) (0,0,1)", "not at right angles");
    refused(space + "(1,0,0) (1,0,0) (0,0,1)", "not at right angles");
    refused(space + "(1,0,0) (0,0,0) (0,0,1)", "spacing is not a number");
    refused(space + "(1,0,0) (0,nan,0) (0,0,1)", "vectors of three numbers");
    refused(space + "(1,0,0) (0,1e300,0) (0,0,1)", "spacing is not a number");
    refused(space + "(1,0,0) none (0,0,1)", "no direction");
    refused(space + "(1,0,0) (0,1) (0,0,1)", "vectors of three numbers");
    refused(space + "(1,0,0) (0,1,0)", "not one vector for each of 3 axes");
    refused(space + "(1,0,0) (0,1,0) (0,0,1) (1,1,1)", "not one vector for each of 3 axes");
    refused(space + "(1,0,0) (0,1,0) (0,0,1)\nspace origin: (1e300,0,0)", "origin is farther away");
    refused(space + "(1,0,0) (0,1,0) (0,0,1)\nspacings: 1 1 1", "keep one");
    refused("space directions: (1,0,0) (0,1,0) (0,0,1)", "field 'space directions': the header also needs");
    expect_refused(read("type: short\ndimension: 4\nsizes: 3 2 2 2\nendian: little\nencoding: raw\n"
                        "space dimension: 3\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
                        "measurement frame: (0,0,0) (0,0,0) (0,0,0)",
                        shorts(24)),
                   "do not span space");
    refused("space: hyperspace\nspacings: 1 1 1", "'hyperspace' cannot be read");
    refused("space dimension: 2", "whole number from 3 to 3");
}

TEST_F(VolumeFiles, LyingHeadersAreRefusedBeforeMemoryIsTaken) {
    const auto with = [&](std::string_view sizes, std::string_view encoding, std::string_view data,
                          std::size_t limit = max_samples) {
        return read(
            text("type: short\ndimension: 3\nendian: little\nsizes: ", sizes, "\nencoding: ", encoding), data,
            limit);
    };
    expect_refused(with("2 3 5", "raw", shorts(24)),
                   ":5: field 'sizes': the header promises 60 bytes of samples, but there are 48");
    expect_refused(with("2 3 5", "gzip", gzipped(shorts(24))), "promises 60");
    expect_refused(with("2000 2000 2000", "raw", shorts(24)), "more than 134217728 samples");
    expect_refused(with("1000000000 1000000000 1000000000", "raw", shorts(24)), "more than");
    expect_refused(with("99999999999999999999 1 1", "raw", shorts(24)), "not a whole number");
    expect_refused(with("512 512 512", "gzip", gzipped(shorts(24))), "cannot hold them");
    expect_refused(with("512 512 512", "raw", shorts(24)), "promises 268435456");
    expect_refused(with("2 3 4", "raw", shorts(24), 23), "more than 23 samples");
    // A decompression bomb: 8 MB of zeros in 8 kB, with a header that promises 48 bytes. Only 48 bytes are
    // unpacked.
    EXPECT_TRUE(with("2 3 4", "gzip", gzipped(std::string(8'000'000, '\0'))));
    std::string zeros;
    zeros.resize(std::size_t{80} << 20U);
    expect_refused(with("2 3 4", "gzip\nbyte skip: -1", gzipped(zeros)),
                   "more than 67108864 bytes are packed before the samples");
    std::string cut = gzipped(shorts(24));
    cut.resize(cut.size() - 9);
    expect_refused(with("2 3 4", "gzip", cut), "cut off");
    expect_refused(with("2 3 4", "gzip", gzipped(shorts(24)).replace(12, 4, "xxxx")), "damaged");
}

TEST_F(VolumeFiles, OtherObjectsAreRefused) {
    expect_refused(read_volume(in_folder("none.nrrd")), "No such file");
    fs::create_directory(in_folder("folder.nrrd"));
    expect_refused(read_volume(in_folder("folder.nrrd")), "not an ordinary file");
    expect_refused(read_volume(put("v.stl", "solid")), "end in .nrrd, .nhdr or .toml");
    expect_refused(read_volume(put("v.nrrd", "")), "not an NRRD file");
    expect_refused(read_volume(put("v.nrrd", "NRRD0009\n\n")), "version of NRRD");
    expect_refused(read_volume(put("v.nrrd", text("NRRD0004\n# ", std::string(5'000'000, 'x')))),
                   "longer than");
    expect_refused(read_volume(put("v.nrrd", text("NRRD0004\nty\x1bpe: \x07\n\n"))), "no field");
    expect_refused(read_volume(put("v.nhdr",
                                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n"
                                   "encoding: raw\ndata file: folder.nrrd\n")),
                   "not an ordinary file");
    expect_refused(read_volume(put("v.nhdr",
                                   "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 4\nendian: little\n"
                                   "encoding: raw\n")),
                   "without samples");
}

}  // namespace
}  // namespace thaum::field
