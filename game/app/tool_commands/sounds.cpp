// thaum sounds: lists the sounds of the game, and writes them as files and pictures.
#include <array>
#include <cstdio>

#include "audio/analysis.h"
#include "audio/synth.h"
#include "audio/wav.h"
#include "core/file.h"
#include "core/near_name.h"
#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "game/app/command.h"
#include "game/app/sound_picture.h"
#include "game/command_line/arguments.h"
#include "game/data/match_data.h"

namespace thaum::game::inline app {
namespace {

constexpr std::string_view sounds_help =
    R"(usage: thaum sounds [NAME ...] [OPTIONS]

Lists the sounds of the game: length, largest sample, level of the loudest 50 ms, and what is
heard. With names, only these. Needs neither a display nor speakers.

  --out DIR       also writes each sound as DIR/NAME.wav, and DIR/NAME.png: the waveform above,
                  the spectrogram below (40 Hz to 16 kHz; bright: loud)
  --sheet FILE    also writes one picture (PNG) with the spectrograms of all listed sounds

The sounds are made from the recipes in assets/sounds; SOUNDS.md there explains them.
)";

using Chosen = std::vector<const audio::Sound*>;

/// The sounds with these names; without names, all sounds. The error is about the first unknown name.
Expected<Chosen> choose(const audio::SoundBank& bank, const std::vector<std::string>& names) {
    Chosen chosen;
    for (const auto& name : names) {
        const auto number = bank.find(name);
        if (!number)
            return fail(text("no sound '", name, "'; `thaum sounds` lists them",
                             did_you_mean(name, bank.sounds, &audio::Sound::name)));
        chosen.push_back(&bank.sounds[*number]);
    }
    if (names.empty()) {
        for (const auto& sound : bank.sounds) chosen.push_back(&sound);
    }
    return chosen;
}

std::string_view name_of(audio::SoundGroup group) {
    static constexpr std::array<std::string_view, audio::sound_groups> names{"effects", "music", "interface"};
    return names[static_cast<std::size_t>(group)];
}

constexpr std::size_t max_of_name_shown = 100;

void print_list(const Chosen& sounds) {
    std::printf("%-20s %-9s %7s %5s %7s  %s\n", "sound", "group", "s", "peak", "dB", "what is heard");
    for (const auto* sound : sounds) {
        const double seconds = static_cast<double>(sound->samples.size()) / audio::sample_rate;
        std::printf("%-20s %-9s %7s %5s %7s  ", printable(sound->name, max_of_name_shown).c_str(),
                    std::string(name_of(sound->group)).c_str(),
                    text(fixed(seconds, 2), sound->loops ? "~" : "").c_str(),
                    fixed(audio::peak_of(sound->samples), 2).c_str(),
                    fixed(audio::loudest_db(sound->samples), 1).c_str());
        print_line(sound->description);
    }
    std::printf("~: loops\n");
}

Expected<void> write_wav(const audio::Sound& sound, const std::filesystem::path& path) {
    auto file = audio::WavWriter::create(path, audio::WavFormat::float_32, 1);
    if (!file) return file.error();
    file->write(sound.samples);
    return file->close();
}

Expected<void> write_all_of(const Chosen& sounds, const std::filesystem::path& folder, render::Font& font) {
    if (auto made = make_folder(folder); !made) return made;
    for (const auto* sound : sounds) {
        if (auto done = write_wav(*sound, folder / text(sound->name, ".wav")); !done) return done;
        if (auto done = render::write_png(folder / text(sound->name, ".png"), draw_sound(*sound, font));
            !done)
            return done;
    }
    return {};
}

int run_sounds(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--out", 1}, output("--sheet")};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    const auto out = arguments->value("--out"), sheet = arguments->value("--sheet");
    if (sheet) {
        const auto folder = std::filesystem::path(*sheet).parent_path();
        if (const auto made = folder.empty() ? Expected<void>() : make_folder(folder); !made)
            return refuse(made.error());
        if (const auto free = check_output(*sheet); !free) return refuse(free.error());
    }
    const auto bank = audio::load_sounds(find_assets() / "sounds");
    if (!bank) return refuse(bank.error());
    if (!bank->faulty.empty()) return refuse(bank->faulty[0].fault);
    const auto sounds = choose(*bank, arguments->plain());
    if (!sounds) return refuse(sounds.error());
    print_list(*sounds);
    if (!out && !sheet) return done;
    auto font = render::Font::load();
    if (!font) return refuse(font.error());
    if (out) {
        if (const auto written = write_all_of(*sounds, *out, *font); !written) return refuse(written.error());
    }
    if (sheet) {
        if (const auto written = render::write_png(*sheet, draw_sounds(*sounds, *font)); !written)
            return refuse(written.error());
    }
    return done;
}

const CommandRegistration registration_of_sounds({.name = "sounds", .help = sounds_help, .run = run_sounds});

}  // namespace

}  // namespace thaum::game::inline app
