#include "audio/detail/openal.h"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <mutex>
#include <string_view>

#include "audio/mixer.h"
#include "core/environment.h"
#include "core/text.h"

namespace thaum::audio::detail {
namespace {

/// Settings for three periods (pieces that the device takes at a time) of 384 samples. OpenAL's default,
/// three periods of 1,024 samples, delays the sound by 60 ms.
constexpr std::string_view short_periods = "[general]\nfrequency = 48000\nperiod_size = 384\nperiods = 3\n";

/// Passes settings to OpenAL as a file in memory, because OpenAL has no call for them.
void choose_short_periods() {
    if (environment_value("ALSOFT_CONF")) return;
    const int fd = ::memfd_create("thaum-openal", MFD_CLOEXEC);
    if (fd < 0) return;
    if (::write(fd, short_periods.data(), short_periods.size()) ==
        static_cast<ssize_t>(short_periods.size())) {
        ::setenv("ALSOFT_CONF", text("/proc/self/fd/", fd).c_str(), 1);
        alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback");  // OpenAL reads the file now
        ::unsetenv("ALSOFT_CONF");
    }
    ::close(fd);
}

void ignore_alsa_message(const char*, int, const char*, int, const char*, ...) {}

/// Turns off the messages of ALSA, which prints several lines for each device that it lacks. OpenAL loads
/// ALSA itself, so ALSA's functions are looked up in the library that is already loaded.
void silence_alsa() {
    void* const alsa = ::dlopen("libasound.so.2", RTLD_LAZY | RTLD_NOLOAD);
    if (alsa == nullptr) return;
    using Handler = void (*)(const char*, int, const char*, int, const char*, ...);
    using SetHandler = int (*)(Handler);
    const auto set_handler = reinterpret_cast<SetHandler>(::dlsym(alsa, "snd_lib_error_set_handler"));
    if (set_handler != nullptr) set_handler(&ignore_alsa_message);
    ::dlclose(alsa);
}

template <class Function>
bool found(Function& function, const char* name) {
    function = reinterpret_cast<Function>(alcGetProcAddress(nullptr, name));
    return function != nullptr;
}

}  // namespace

Expected<OpenAl> find_openal() {
    audio::prepare_openal();
    OpenAl al;
    const bool complete = found(al.open_loopback, "alcLoopbackOpenDeviceSOFT") &&
                          found(al.render, "alcRenderSamplesSOFT") && found(al.reset, "alcResetDeviceSOFT") &&
                          found(al.set_thread_context, "alcSetThreadContext") &&
                          found(al.thread_context, "alcGetThreadContext");
    if (!complete) return fail("this OpenAL cannot mix into memory; install OpenAL Soft 1.19 or newer");
    return al;
}

}  // namespace thaum::audio::detail

namespace thaum::audio {

void prepare_openal() {
    static std::once_flag once;
    std::call_once(once, [] {
        ::setenv("ALSOFT_LOGLEVEL", "0", 0);
        detail::choose_short_periods();
        alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback");
        detail::silence_alsa();
    });
}

}  // namespace thaum::audio
