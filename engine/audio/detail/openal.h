// audio/detail/openal.h: OpenAL with the extensions that this folder uses.
#pragma once
#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>

#include "core/error.h"

namespace thaum::audio::detail {

/// Functions of OpenAL's extensions. If one of them is missing, `find_openal` returns an error.
struct OpenAl {
    LPALCLOOPBACKOPENDEVICESOFT open_loopback{};
    LPALCRENDERSAMPLESSOFT render{};
    LPALCRESETDEVICESOFT reset{};
    PFNALCSETTHREADCONTEXTPROC set_thread_context{};
    PFNALCGETTHREADCONTEXTPROC thread_context{};
};

/// Prepares OpenAL once for the process, then finds the functions. Call it first while one thread runs,
/// because it sets environment variables: messages of OpenAL are off, and devices play in short
/// periods, unless the user has chosen.
Expected<OpenAl> find_openal();

/// Makes a context of OpenAL current for this thread; the destructor makes the former one current again.
class ContextScope {
public:
    ContextScope(const OpenAl& al, ALCcontext* context) : al_(al), before_(al.thread_context()) {
        al_.set_thread_context(context);
    }
    ~ContextScope() { al_.set_thread_context(before_); }
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

private:
    const OpenAl& al_;
    ALCcontext* before_;
};

}  // namespace thaum::audio::detail
